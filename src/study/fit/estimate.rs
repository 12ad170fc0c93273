//! Fitted parameters with one standard error each.

use crate::numerics::least_squares::{Minimum, Parameter};
use crate::study::{Cell, ReportTable};
use crate::units::{rounded, significant, trimmed};
use serde::Serialize;

/// Relative error of perfect data \[–\].
const PERFECT: f64 = 1e-7;
/// Most decimals that are written.
const FINEST: i32 = 9;

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

/// Two parameters that the points cannot tell apart, with their correlation.
pub type Correlated = (usize, usize, f64);

/// Estimates at a minimum, and pairs with a correlation of `tied` or more. Weighted residuals have a variance of 1 at least.
pub(super) fn estimates(
    names: &[(&str, &str)],
    parameters: &[Parameter],
    minimum: &Minimum,
    is_weighted: bool,
    tied: f64,
) -> (Vec<Estimate>, Vec<Correlated>) {
    let variance = minimum.variance().max(if is_weighted { 1.0 } else { 0.0 });
    let covariance = minimum.covariance(variance);
    let one = |(j, ((key, unit), parameter)): (usize, (&(&str, &str), &Parameter))| Estimate {
        key: (*key).to_owned(),
        unit: (*unit).to_owned(),
        value: minimum.values[j],
        error: covariance.as_ref().filter(|_| minimum.free[j]).map(|c| c[(j, j)].sqrt()),
        bound: (!minimum.free[j] && parameter.low < parameter.high).then_some(minimum.values[j]),
    };
    let estimates = names.iter().zip(parameters).enumerate().map(one).collect();
    let Some(c) = covariance else { return (estimates, Vec::new()) };
    let pairs = (0..c.nrows()).flat_map(|i| (i + 1..c.nrows()).map(move |j| (i, j)));
    let correlations = pairs.map(|(i, j)| (i, j, c[(i, j)] / (c[(i, i)] * c[(j, j)]).sqrt()));
    (estimates, correlations.filter(|(.., correlation)| correlation.abs() >= tied).collect())
}

pub(super) fn table<'a>(all: impl Iterator<Item = (String, &'a Estimate)>) -> ReportTable {
    let mut table = ReportTable::new("fit", &["Of", "Parameter", "Unit", "Value", "Standard error", "At bound"]);
    for (owner, e) in all {
        let error = e.error.map_or_else(String::new, |error| significant(error, 2).to_string());
        let bound = if e.bound.is_some() { "yes" } else { "" };
        let cells = [owner, e.key.clone(), e.unit.clone(), e.written(), error, bound.to_owned()];
        table.rows.push(cells.map(Cell::from).to_vec());
    }
    table
}

impl Estimate {
    /// Value to two digits more than its error allows, because errors of several parameters go together.
    pub fn written(&self) -> String {
        let magnitude = |value: f64| if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
        let error = self.error.filter(|error| *error > PERFECT * self.value.abs());
        let most = (FINEST - magnitude(self.value)).max(0);
        error.map_or_else(
            || rounded(self.value).to_string(),
            |error| trimmed(self.value, (3 - magnitude(error)).clamp(0, most)),
        )
    }

    /// Whether a value lies within so many standard errors.
    pub fn holds(&self, value: f64, errors: f64) -> bool {
        self.error.is_some_and(|error| (value - self.value).abs() <= errors * error)
    }
}
