//! Quantities in a case file: text with a unit, or a plain number where the quantity has none.

use super::error::QuantityError;
use super::kind::Kind;
use super::quantity::{Quantity, read};
use serde::Deserialize;
use serde::de::{self, Deserializer, Visitor};
use std::fmt;
use std::marker::PhantomData;

struct Text<Q>(PhantomData<Q>);

impl<Q: Quantity> Text<Q> {
    fn number<E: de::Error>(&self, value: f64) -> Result<Q, E> {
        let (found, kind) = (format!("{value:?}"), Q::KIND);
        let found = found.strip_suffix(".0").unwrap_or(&found).to_owned();
        if kind.unit.is_empty() {
            Q::checked(value, &found).map_err(E::custom)
        } else {
            Err(E::custom(QuantityError::MissingUnit { found, kind }))
        }
    }
}

impl<Q: Quantity> Visitor<'_> for Text<Q> {
    type Value = Q;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Kind { name, unit, .. } = Q::KIND;
        if unit.is_empty() {
            write!(f, "{name}, such as {}", Q::KIND.written())
        } else {
            write!(f, "{name} with its unit, such as {}", Q::KIND.written())
        }
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Q, E> {
        if Q::KIND.unit.is_empty() {
            return Err(E::invalid_type(de::Unexpected::Str(text), &self));
        }
        read(text).map_err(E::custom)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Q, E> {
        self.number(value as f64)
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Q, E> {
        self.number(value as f64)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Q, E> {
        self.number(value)
    }
}

pub(super) fn deserialize<'de, Q: Quantity, D: Deserializer<'de>>(from: D) -> Result<Q, D::Error> {
    from.deserialize_any(Text(PhantomData))
}

/// Reads a quantity for a field that holds its number in solver units.
///
/// # Errors
/// As the quantity's own.
pub fn value<'de, Q: Quantity + Deserialize<'de>, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Q::deserialize(from).map(Q::value)
}

/// As [`value`], for a field that may be left out.
///
/// # Errors
/// As the quantity's own.
pub fn optional<'de, Q: Quantity + Deserialize<'de>, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    value::<Q, D>(from).map(Some)
}
