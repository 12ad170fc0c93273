//! Line of a check: label, value, meaning.

use crate::model::{Geometry, Model};
use crate::units::Amount;
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// Label, value and meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name of the value.
    pub label: String,
    /// Number with its unit, or word.
    pub value: String,
    /// The number, if it is one.
    pub amount: Option<Amount>,
    /// Meaning or origin; may be empty.
    pub meaning: String,
}

impl Line {
    /// Value in its unit; `None` for words.
    pub fn number(&self) -> Option<f64> {
        self.amount.map(|amount| amount.value)
    }
}

impl Serialize for Line {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_struct("Line", 5)?;
        map.serialize_field("label", &self.label)?;
        map.serialize_field("value", &self.value)?;
        map.serialize_field("meaning", &self.meaning)?;
        map.serialize_field("number", &self.number())?;
        map.serialize_field("unit", self.amount.map_or("", |amount| amount.unit.spelled()))?;
        map.end()
    }
}

/// Line with words as its value.
pub(super) fn line(label: impl Into<String>, value: impl Into<String>, meaning: impl Into<String>) -> Line {
    Line { label: label.into(), value: value.into(), amount: None, meaning: meaning.into() }
}

/// Line with a number as its value.
pub(super) fn number(label: &str, amount: Amount, meaning: impl Into<String>) -> Line {
    Line { amount: Some(amount), ..line(label, amount, meaning) }
}

/// Distance from the axis or symmetry plane \[mm\] as shops give it: for round parts the diameter.
pub(super) fn size_of(model: &Model, half: f64, amount: fn(f64) -> Amount) -> String {
    match model.geometry {
        Geometry::Axisymmetric => format!("Ø {}", amount(2.0 * half)),
        Geometry::PlaneStrain => amount(half).to_string(),
    }
}
