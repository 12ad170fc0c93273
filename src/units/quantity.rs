//! Result numbers: the one form in which verdict, summary, tables, studies and pictures hold them.

use super::{Amount, rounded};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Named result with its unit, error bar, limits and place.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Name in files: `thinnest`.
    pub key: &'static str,
    /// Name in text: `Thinnest`.
    pub label: &'static str,
    /// Name in text in place of it: `Ejector`.
    pub name: Option<String>,
    /// Value, unit and digits.
    pub amount: Amount,
    /// Discretisation error.
    pub error: ErrorBar,
    /// Numbers from which it is in doubt or refused.
    pub limits: Option<Limits>,
    /// Location, instant or reference; may be empty.
    pub place: String,
}

/// Numbers, in the quantity's unit, from which it turns amber and red.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Limits {
    /// Good side.
    pub sense: Sense,
    /// Amber from here on.
    pub amber: Option<f64>,
    /// Red from here on.
    pub red: Option<f64>,
}

/// Good side of limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// Not above them.
    AtMost,
    /// Not below them.
    AtLeast,
}

/// Discretisation error of a number: in JSON `error_bar`, null with an `error_bar_reason`, or nothing if not computed.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ErrorBar {
    /// Not computed.
    #[default]
    NotComputed,
    /// Half width, in the unit of the number; 0 if no refinement moves it.
    Half(f64),
    /// None, and the reason.
    Missing(String),
}

impl Quantity {
    /// Quantity without error bar, limits and place.
    pub fn new(key: &'static str, label: &'static str, amount: Amount) -> Self {
        Self { key, label, name: None, amount, error: ErrorBar::NotComputed, limits: None, place: String::new() }
    }

    /// Sets the place.
    pub fn at(self, place: impl Into<String>) -> Self {
        Self { place: place.into(), ..self }
    }

    /// Sets the error bar, which then limits the digits.
    pub fn with_error(self, error: ErrorBar) -> Self {
        let half = if let ErrorBar::Half(half) = error { Some(half).filter(|half| *half > 0.0) } else { None };
        Self { amount: half.map_or(self.amount, |half| self.amount.with_bar(half)), error, ..self }
    }
}

impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("key", self.key)?;
        map.serialize_entry("value", &rounded(self.amount.value))?;
        self.error.write(&mut map)?;
        map.serialize_entry("unit", self.amount.unit.spelled())?;
        map.serialize_entry("about", &self.place)?;
        map.end()
    }
}

impl ErrorBar {
    /// Reason of a number without an error, such as an input.
    pub(crate) const UNMOVED: &str = "no refinement moves it";

    /// Writes its entries into a map.
    pub fn write<M: SerializeMap>(&self, map: &mut M) -> Result<(), M::Error> {
        match self {
            Self::NotComputed => Ok(()),
            Self::Half(half) if *half > 0.0 => map.serialize_entry("error_bar", &rounded(*half)),
            Self::Half(_) => Self::Missing(Self::UNMOVED.to_owned()).write(map),
            Self::Missing(why) => {
                map.serialize_entry("error_bar", &None::<f64>)?;
                map.serialize_entry("error_bar_reason", why)
            }
        }
    }
}
