//! Line of a check: label, value, meaning.

use crate::model::{Geometry, Model};
use crate::units::Amount;

/// Label, value and meaning.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Line {
    /// Name of the value.
    pub label: String,
    /// Number with its unit, or word.
    pub value: String,
    /// Meaning or origin; may be empty.
    pub meaning: String,
    /// Value in its unit; `None` for words.
    pub number: Option<f64>,
    /// Unit of the number; else empty.
    pub unit: &'static str,
}

pub(super) fn line(label: impl Into<String>, value: impl Into<String>, meaning: impl Into<String>) -> Line {
    Line { label: label.into(), value: value.into(), meaning: meaning.into(), number: None, unit: "" }
}

pub(super) fn number(label: &str, amount: Amount, meaning: impl Into<String>) -> Line {
    Line { number: Some(amount.value), unit: amount.unit.spelled(), ..line(label, amount, meaning) }
}

/// Distance from the axis or symmetry plane \[mm\] as shops give it: for round parts the diameter.
pub(super) fn size_of(model: &Model, half: f64, amount: fn(f64) -> Amount) -> String {
    match model.geometry {
        Geometry::Axisymmetric => format!("Ø {}", amount(2.0 * half)),
        Geometry::PlaneStrain => amount(half).to_string(),
    }
}
