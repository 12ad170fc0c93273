//! One line of what is said of a case.

use crate::message::{Amount, Message, message};
use crate::model::{Geometry, Model};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// One line of the report.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What is said.
    pub label: Message,
    /// The number with its unit, or the word itself.
    pub value: Message,
    /// What it means or where it comes from; may be empty.
    pub meaning: Message,
}

impl Line {
    /// The value in its unit; `None` where it is a word.
    pub fn number(&self) -> Option<f64> {
        self.value.amount().map(|amount| amount.value)
    }
}

impl Serialize for Line {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_struct("Line", 5)?;
        map.serialize_field("label", &self.label)?;
        map.serialize_field("value", &self.value)?;
        map.serialize_field("meaning", &self.meaning)?;
        map.serialize_field("number", &self.number())?;
        map.serialize_field("unit", self.value.amount().map_or("", |amount| amount.unit.spelled()))?;
        map.end()
    }
}

/// A line; what it means may be empty.
pub(super) fn line(label: impl Into<Message>, value: impl Into<Message>, meaning: impl Into<Message>) -> Line {
    Line { label: label.into(), value: value.into(), meaning: meaning.into() }
}

/// A distance from the axis or symmetry plane \[mm\] as shops have it: of a round part the diameter; told as `amount` does.
pub(super) fn size_of(model: &Model, half: f64, amount: fn(f64) -> Amount) -> Message {
    match model.geometry {
        Geometry::Axisymmetric => message!("Ø {diameter}", diameter = amount(2.0 * half)),
        Geometry::PlaneStrain => message!("{half}", half = amount(half)),
    }
}
