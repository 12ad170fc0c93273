//! Why a model cannot be solved, and the checks of single values that say so.

use crate::numerics::PiecewiseLinear;
use std::ops::RangeInclusive;

/// Difference between two numbers that must agree, over the larger one \[–\].
const SAME: f64 = 1e-6;

/// Why a model cannot be solved: which value, what it is and what it may be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// A number lies outside of its range.
    #[error("`{what}` must lie between {least:?} and {most:?}, found {value:?}")]
    Range {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: f64,
        /// The least that is allowed.
        least: f64,
        /// The most that is allowed.
        most: f64,
    },
    /// A whole number lies outside of its range.
    #[error("`{what}` must lie between {least} and {most}, found {value}")]
    Count {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: usize,
        /// The least that is allowed.
        least: usize,
        /// The most that is allowed.
        most: usize,
    },
    /// A number that must be positive is not, or is not finite.
    #[error("`{what}` must be positive and finite, found {value:?}")]
    NotPositive {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: f64,
    },
    /// A number is negative or not finite.
    #[error("`{what}` must be zero or positive and finite, found {value:?}")]
    Negative {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: f64,
    },
    /// A number is not finite.
    #[error("`{what}` must be finite, found {value:?}")]
    NotFinite {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: f64,
    },
    /// A list does not rise.
    #[error("`{what}` must rise from entry to entry, found {value:?} after {before:?}")]
    NotRising {
        /// Path of the value in the model.
        what: String,
        /// The entry before, or the bound that the first entry must exceed.
        before: f64,
        /// The entry that is not above it.
        value: f64,
    },
    /// Two numbers that say the same differ.
    #[error("`{what}` is {value:?} and must agree with `{other}`, {wanted:?}")]
    Differs {
        /// Path of the value in the model.
        what: String,
        /// What was found.
        value: f64,
        /// Path of the other value.
        other: &'static str,
        /// What follows from the other value.
        wanted: f64,
    },
    /// A list that needs an entry has none.
    #[error("`{what}` is empty")]
    Empty {
        /// Path of the value in the model.
        what: &'static str,
    },
    /// A value is given without one that it needs.
    #[error("`{what}` needs `{other}`")]
    Needs {
        /// Path of the value in the model.
        what: String,
        /// What is missing.
        other: String,
    },
    /// Two things are given that cannot be together.
    #[error("`{what}` and `{other}` exclude each other")]
    Excludes {
        /// Path of the value in the model.
        what: &'static str,
        /// The other one.
        other: &'static str,
    },
    /// Nothing acts on the sheet: no place of it is in equilibrium rather than another.
    #[error("nothing acts on the sheet: there is no tool, no gas, no pulled edge and no release")]
    Idle,
    /// There are two of which there may be one.
    #[error("there is more than one {what}")]
    Twice {
        /// What there is more than one of.
        what: String,
    },
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
