//! Quantities in a case file: text with a unit, or a plain number where the quantity has none.

use super::dimensioned::{Dimensioned, read};
use super::error::QuantityError;
use super::kind::Kind;
use serde::Deserialize;
use serde::Serializer;
use serde::de::{self, Deserializer, Visitor};
use std::fmt;
use std::marker::PhantomData;

struct Text<Q>(PhantomData<Q>);

impl<Q: Dimensioned> Text<Q> {
    fn number<E: de::Error>(&self, value: f64) -> Result<Q, E> {
        let (found, kind) = (format!("{value:?}"), Q::KIND);
        let found = found.strip_suffix(".0").unwrap_or(&found).to_owned();
        if kind.unit.is_empty() {
            Q::checked(value, &found).map_err(E::custom)
        } else {
            Err(E::custom(QuantityError::missing_unit(&found, kind)))
        }
    }
}

impl<Q: Dimensioned> Visitor<'_> for Text<Q> {
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

pub(super) fn deserialize<'de, Q: Dimensioned, D: Deserializer<'de>>(from: D) -> Result<Q, D::Error> {
    from.deserialize_any(Text(PhantomData))
}

/// Reads and writes a plain number in the solver's unit as a quantity is written, for fields of solver types:
/// `#[serde(with = "As::<Positive<Stress>>")] k: f64`; an `Option<f64>` as an `Option` of a quantity.
pub struct As<Q>(PhantomData<Q>);

/// A quantity that may be left out, or not.
pub trait Plain {
    /// `f64`, or `Option<f64>` of what may be left out.
    type Number;

    /// The number in the solver's unit.
    fn plain(self) -> Self::Number;

    /// Writes the number with its unit.
    ///
    /// # Errors
    /// Errors of the serializer.
    fn write<S: Serializer>(number: &Self::Number, to: S) -> Result<S::Ok, S::Error>;
}

impl<Q: Dimensioned> Plain for Q {
    type Number = f64;

    fn plain(self) -> f64 {
        self.value()
    }

    fn write<S: Serializer>(number: &f64, to: S) -> Result<S::Ok, S::Error> {
        match Q::KIND.unit {
            "" => to.serialize_f64(*number),
            unit => to.collect_str(&format_args!("{number} {unit}")),
        }
    }
}

impl<Q: Dimensioned> Plain for Option<Q> {
    type Number = Option<f64>;

    fn plain(self) -> Option<f64> {
        self.map(Q::value)
    }

    fn write<S: Serializer>(number: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
        match number {
            Some(number) => Q::write(number, to),
            None => to.serialize_none(),
        }
    }
}

impl<Q: Plain> As<Q> {
    /// Reads the number.
    ///
    /// # Errors
    /// When it is not such a quantity.
    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Q::Number, D::Error>
    where
        Q: Deserialize<'de>,
    {
        Q::deserialize(from).map(Q::plain)
    }

    /// Writes the number.
    ///
    /// # Errors
    /// Errors of the serializer.
    pub fn serialize<S: Serializer>(number: &Q::Number, to: S) -> Result<S::Ok, S::Error> {
        Q::write(number, to)
    }
}
