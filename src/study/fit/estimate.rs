//! Fitted parameters with one standard error each.

use crate::numerics::least_squares::{Minimum, Parameter};
use crate::study::report::{Cell, ReportTable};
use crate::units::{rounded, significant, trimmed};
use nalgebra::DMatrix;
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

/// Estimates of a minimum, and the pairs with the largest correlation.
pub(super) fn estimates(
    names: &[(String, String)],
    parameters: &[Parameter],
    minimum: &Minimum,
    least_variance: f64,
) -> (Vec<Estimate>, Option<DMatrix<f64>>) {
    let covariance = minimum.covariance(minimum.variance().max(least_variance));
    let one = |(j, ((key, unit), parameter)): (usize, (&(String, String), &Parameter))| Estimate {
        key: key.clone(),
        unit: unit.clone(),
        value: minimum.values[j],
        error: covariance.as_ref().filter(|_| minimum.free[j]).map(|covariance| covariance[(j, j)].sqrt()),
        bound: (!minimum.free[j] && parameter.low < parameter.high).then_some(minimum.values[j]),
    };
    (names.iter().zip(parameters).enumerate().map(one).collect(), covariance)
}

/// Pairs that the points cannot tell apart: `(i, j, correlation)` of this size or more.
pub(super) fn correlated(covariance: Option<&DMatrix<f64>>, least: f64) -> Vec<(usize, usize, f64)> {
    let Some(c) = covariance else { return Vec::new() };
    let pairs = (0..c.nrows()).flat_map(|i| (i + 1..c.nrows()).map(move |j| (i, j)));
    let correlation = |(i, j): (usize, usize)| {
        let size = (c[(i, i)] * c[(j, j)]).sqrt();
        (size > 0.0).then(|| (i, j, c[(i, j)] / size))
    };
    pairs.filter_map(correlation).filter(|(.., c)| c.abs() >= least).collect()
}

/// Table of parameters.
pub(super) fn table(all: &[(&str, &Estimate)]) -> ReportTable {
    let mut table = ReportTable::new("fit", &["Of", "Parameter", "Unit", "Value", "Standard error", "At bound"]);
    for (of, e) in all {
        let error = e.error.map_or_else(String::new, |error| significant(error, 2).to_string());
        let bound = if e.bound.is_some() { "yes" } else { "" };
        let cells = [(*of).to_owned(), e.key.clone(), e.unit.clone(), e.written(), error, bound.to_owned()];
        table.rows.push(cells.map(Cell::from).to_vec());
    }
    table
}

impl Estimate {
    /// The value to two digits more than its error allows, because errors of several parameters go together.
    pub fn written(&self) -> String {
        match self.error.filter(|error| *error > PERFECT * self.value.abs()) {
            Some(error) => {
                trimmed(self.value, (3 - magnitude(error)).clamp(0, (FINEST - magnitude(self.value)).max(0)))
            }
            None => rounded(self.value).to_string(),
        }
    }

    /// Whether a value lies within so many standard errors.
    pub fn holds(&self, value: f64, errors: f64) -> bool {
        self.error.is_some_and(|error| (value - self.value).abs() <= errors * error)
    }
}

/// Power of ten of a number.
fn magnitude(value: f64) -> i32 {
    if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 }
}
