//! Why a model cannot be solved, and the checks of single values that say so.

use crate::numerics::PiecewiseLinear;
use std::ops::RangeInclusive;

/// Difference between two numbers that must agree, over the larger one \[–\].
const SAME: f64 = 1e-6;

/// Why a model cannot be solved: which value, what it is and what it may be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    #[error("`{what}` must lie between {least:?} and {most:?}, found {value:?}")]
    Range { what: String, value: f64, least: f64, most: f64 },
    #[error("`{what}` must lie between {least} and {most}, found {value}")]
    Count { what: String, value: usize, least: usize, most: usize },
    #[error("`{what}` must be positive and finite, found {value:?}")]
    NotPositive { what: String, value: f64 },
    #[error("`{what}` must be zero or positive and finite, found {value:?}")]
    Negative { what: String, value: f64 },
    #[error("`{what}` must be finite, found {value:?}")]
    NotFinite { what: String, value: f64 },
    #[error("`{what}` must rise from entry to entry, found {value:?} after {before:?}")]
    NotRising { what: String, before: f64, value: f64 },
    #[error("`{what}` is {value:?} and must agree with `{other}`, {wanted:?}")]
    Differs { what: String, value: f64, other: &'static str, wanted: f64 },
    #[error("`{what}` is empty")]
    Empty { what: &'static str },
    #[error("`{what}` needs `{other}`")]
    Needs { what: String, other: String },
    #[error("`{what}` and `{other}` exclude each other")]
    Excludes { what: &'static str, other: &'static str },
    #[error("there is more than one {what}")]
    Twice { what: String },
}

pub(super) type Checked = Result<(), ModelError>;

pub(super) fn finite(what: &str, value: f64) -> Checked {
    if value.is_finite() { Ok(()) } else { Err(ModelError::NotFinite { what: what.into(), value }) }
}

pub(super) fn positive(what: &str, value: f64) -> Checked {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(ModelError::NotPositive { what: what.into(), value }) }
}

pub(super) fn not_negative(what: &str, value: f64) -> Checked {
    if value >= 0.0 && value.is_finite() { Ok(()) } else { Err(ModelError::Negative { what: what.into(), value }) }
}

/// A number from `least` to `most`, both included.
pub(super) fn within(what: &str, value: f64, least: f64, most: f64) -> Checked {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(ModelError::Range { what: what.into(), value, least, most })
}

pub(super) fn count(what: &str, value: usize, range: RangeInclusive<usize>) -> Checked {
    let (least, most) = (*range.start(), *range.end());
    if range.contains(&value) { Ok(()) } else { Err(ModelError::Count { what: what.into(), value, least, most }) }
}

/// Finite numbers that rise, the first above `before`.
pub(super) fn rising(what: &str, mut before: f64, values: impl Iterator<Item = f64>) -> Checked {
    for value in values {
        finite(what, value)?;
        if value <= before {
            return Err(ModelError::NotRising { what: what.into(), before, value });
        }
        before = value;
    }
    Ok(())
}

/// Finite places and values that pass `check`; that the places rise is the curve's own promise.
pub(super) fn curve(what: &str, curve: &PiecewiseLinear, check: fn(&str, f64) -> Checked) -> Checked {
    curve.points().iter().try_for_each(|(x, value)| finite(what, *x).and_then(|()| check(what, *value)))
}

pub(super) fn agree(what: &str, value: f64, other: &'static str, wanted: f64) -> Checked {
    if (value - wanted).abs() <= SAME * value.abs().max(wanted.abs()) {
        return Ok(());
    }
    Err(ModelError::Differs { what: what.into(), value, other, wanted })
}

pub(super) fn needs(what: &str, given: bool, other: &str) -> Checked {
    if given { Ok(()) } else { Err(ModelError::Needs { what: what.into(), other: other.into() }) }
}

pub(super) fn excludes(both: bool, what: &'static str, other: &'static str) -> Checked {
    if both { Err(ModelError::Excludes { what, other }) } else { Ok(()) }
}
