//! A quantity as text: from a string, from serde, in a JSON schema, and back.

use super::{Kind, Quantity, QuantityError, parse};
use schemars::JsonSchema;
use serde::de::{self, Deserializer, Visitor};
use serde::{Deserialize, Serializer};
use std::fmt;
use std::marker::PhantomData;

/// Checks text against a type: number, unit, dimension, range.
pub(super) fn read<Q: Quantity>(text: &str) -> Result<Q, QuantityError> {
    let (parsed, kind) = (parse(text)?, Q::KIND);
    let found = text.trim();
    // A bare 8 would be 800 %: who writes a percentage says so.
    let is_bare_share = kind.unit == "%" && !parsed.has_unit;
    if parsed.dimension == kind.dimension && !is_bare_share {
        return Q::checked(parsed.value, found);
    }
    let found = found.into();
    Err(match parsed.has_unit {
        true => QuantityError::WrongDimension { found, is: parsed.dimension, kind },
        false => QuantityError::MissingUnit { found, kind },
    })
}

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

/// Reads and writes a plain number in the solver's unit as a quantity is written, for fields of solver types:
/// `#[serde(with = "As::<Positive<Stress>>")] k: f64`; an `Option<f64>` as an `Option` of a quantity.
pub struct As<Q>(PhantomData<Q>);

/// A quantity that may be left out, or not.
pub trait Plain {
    type Number;

    /// The number in the solver's unit.
    fn plain(self) -> Self::Number;

    /// Writes the number with its unit.
    ///
    /// # Errors
    /// As the serializer's.
    fn write<S: Serializer>(number: &Self::Number, to: S) -> Result<S::Ok, S::Error>;
}

impl<Q: Quantity> Plain for Q {
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

impl<Q: Quantity> Plain for Option<Q> {
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
    /// As the serializer's.
    pub fn serialize<S: Serializer>(number: &Q::Number, to: S) -> Result<S::Ok, S::Error> {
        Q::write(number, to)
    }
}

impl<Q: JsonSchema> JsonSchema for As<Q> {
    fn inline_schema() -> bool {
        Q::inline_schema()
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        Q::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Q::json_schema(generator)
    }
}

/// The schema of a quantity: a number with its bounds, or text with examples.
pub(super) fn schema<Q: Quantity>() -> schemars::Schema {
    let kind = Q::KIND;
    let mut schema = if kind.unit.is_empty() {
        schemars::json_schema!({ "type": "number" })
    } else {
        let note = format!("{} with its unit; solved in {}", kind.name, kind.unit);
        schemars::json_schema!({ "type": "string", "description": note, "examples": kind.examples })
    };
    if kind.unit.is_empty() {
        for (keyword, bound) in Q::BOUND {
            schema.insert((*keyword).into(), (*bound).into());
        }
    }
    schema
}

/// `FromStr`, `Display`, serde and schema of a quantity type.
macro_rules! implement {
    ([$($generic:tt)*] $type:ty) => {
        impl<$($generic)*> std::str::FromStr for $type {
            type Err = $crate::units::QuantityError;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                $crate::units::text::read(text)
            }
        }

        impl<$($generic)*> std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let (value, unit) = ($crate::units::Quantity::value(*self), <Self as $crate::units::Quantity>::KIND.unit);
                match unit {
                    "" => write!(f, "{value}"),
                    "%" => write!(f, "{} %", $crate::units::rounded(100.0 * value)),
                    unit => write!(f, "{value} {unit}"),
                }
            }
        }

        impl<'de, $($generic)*> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                $crate::units::text::deserialize(from)
            }
        }

        impl<$($generic)*> schemars::JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                <Self as $crate::units::Quantity>::KIND.name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $crate::units::text::schema::<Self>()
            }
        }
    };
}
pub(super) use implement;
