//! Fits: hardening laws from tension tests, keys of a case from measured curves.

mod case_fit;
mod flow_curve;
mod law;
mod law_report;
mod tension;

pub use case_fit::{CaseFit, CaseFitRequest, fit_case};
pub use flow_curve::{FlowCurve, Reduction, flow_curves};
pub use law::{Direction, HardeningKind, LawFit, LawFits, fit_laws};
pub use law_report::material_text;
pub use tension::FlowPoint;

use crate::numerics::least_squares::{Minimum, Parameter};
use crate::study::{Cell, ReportTable};
use crate::units::{rounded, significant, trimmed};
use serde::Serialize;

/// Relative error of perfect data \[–\].
const PERFECT: f64 = 1e-7;

/// A fitted parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Name of a law's parameter, or dotted path of a case's key.
    pub key: String,
    /// Unit; empty for plain numbers.
    pub unit: String,
    /// Best value.
    pub value: f64,
    /// One standard error, from the covariance; `None` if the points do not determine it.
    pub error: Option<f64>,
    /// Bound that it is pushed against.
    pub bound: Option<f64>,
}

/// Estimates of named parameters with units at a minimum. Weighted residuals have a variance of 1 at least.
fn estimates<'a>(
    names: impl Iterator<Item = (&'a str, &'a str)>, parameters: &[Parameter], minimum: &Minimum, is_weighted: bool,
) -> Vec<Estimate> {
    let covariance = minimum.covariance(minimum.variance().max(f64::from(is_weighted)));
    let one = |(j, (key, unit)): (usize, (&str, &str))| {
        let (value, is_free) = (minimum.values[j], minimum.free[j]);
        let error = covariance.as_ref().filter(|_| is_free).map(|c| c[(j, j)].sqrt());
        let bound = (!is_free && parameters[j].low < parameters[j].high).then_some(value);
        Estimate { key: key.to_owned(), unit: unit.to_owned(), value, error, bound }
    };
    names.enumerate().map(one).collect()
}

fn table<'a>(all: impl Iterator<Item = (String, &'a Estimate)>) -> ReportTable {
    let row = |(owner, e): (String, &Estimate)| {
        let error = e.error.map_or_else(String::new, |error| significant(error, 2).to_string());
        let bound = if e.bound.is_some() { "yes" } else { "" };
        [owner, e.key.clone(), e.unit.clone(), e.written(), error, bound.to_owned()].map(Cell::from)
    };
    ReportTable::new("fit", &["Of", "Parameter", "Unit", "Value", "Standard error", "At bound"], all.map(row))
}

impl Estimate {
    /// Value to two digits more than its error allows, because errors of several parameters go together.
    pub fn written(&self) -> String {
        let magnitude = |value: f64| if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
        let most = (9 - magnitude(self.value)).max(0);
        match self.error.filter(|error| *error > PERFECT * self.value.abs()) {
            Some(error) => trimmed(self.value, (3 - magnitude(error)).clamp(0, most)),
            None => rounded(self.value).to_string(),
        }
    }
}
