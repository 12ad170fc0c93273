//! Errors of models that cannot be solved, and the checks of single values.

use crate::numerics::PiecewiseLinear;
use std::ops::RangeInclusive;

/// Largest relative difference of two numbers that must agree \[–\].
const SAME: f64 = 1e-6;

/// Reason why a model cannot be solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("`{what}` {problem}")]
pub struct ModelError {
    /// Path of the value in the model.
    pub what: String,
    /// Condition that is not met, and the found value.
    pub problem: String,
    /// Nearest whole number that can be solved.
    pub nearest: Option<usize>,
}

pub(super) type Checked = Result<(), ModelError>;

/// An error unless a condition holds.
pub(super) fn check(holds: bool, what: &str, problem: impl FnOnce() -> String) -> Checked {
    if holds { Ok(()) } else { Err(ModelError { what: what.into(), problem: problem(), nearest: None }) }
}

pub(super) fn finite(what: &str, value: f64) -> Checked {
    check(value.is_finite(), what, || format!("must be finite, found {value:?}"))
}

pub(super) fn positive(what: &str, value: f64) -> Checked {
    check(value > 0.0 && value.is_finite(), what, || format!("must be positive and finite, found {value:?}"))
}

pub(super) fn not_negative(what: &str, value: f64) -> Checked {
    check(value >= 0.0 && value.is_finite(), what, || format!("must be zero or positive and finite, found {value:?}"))
}

/// A number from `least` to `most`, both included.
pub(super) fn within(what: &str, value: f64, least: f64, most: f64) -> Checked {
    let inside = (least..=most).contains(&value);
    check(inside, what, || format!("must lie between {least:?} and {most:?}, found {value:?}"))
}

pub(super) fn count(what: &str, value: usize, range: RangeInclusive<usize>) -> Checked {
    let (least, most) = (*range.start(), *range.end());
    check(range.contains(&value), what, || format!("must lie between {least} and {most}, found {value}"))
        .map_err(|error| ModelError { nearest: Some(value.clamp(least, most)), ..error })
}

/// Finite numbers that rise, the first above `before`.
pub(super) fn rising(what: &str, mut before: f64, values: impl IntoIterator<Item = f64>) -> Checked {
    for value in values {
        finite(what, value)?;
        check(value > before, what, || format!("must rise from entry to entry, found {value:?} after {before:?}"))?;
        before = value;
    }
    Ok(())
}

/// A curve with finite arguments and values that pass `valid`.
pub(super) fn curve(what: &str, curve: &PiecewiseLinear, valid: fn(&str, f64) -> Checked) -> Checked {
    curve.points().iter().try_for_each(|(x, value)| finite(what, *x).and_then(|()| valid(what, *value)))
}

pub(super) fn agree(what: &str, value: f64, other: &str, wanted: f64) -> Checked {
    let same = (value - wanted).abs() <= SAME * value.abs().max(wanted.abs());
    check(same, what, || format!("is {value:?} and must agree with `{other}`, {wanted:?}"))
}

pub(super) fn needs(what: &str, given: bool, other: &str) -> Checked {
    check(given, what, || format!("needs `{other}`"))
}

pub(super) fn excludes(both: bool, what: &str, other: &str) -> Checked {
    check(!both, what, || format!("and `{other}` exclude each other"))
}
