//! Numbers of known dimension: as text, in case files, and in their JSON schema.

use super::error::QuantityError;
use super::kind::Kind;
use super::parse::{parse, thicknesses};
use super::unit::{FORCE, factor};
use schemars::JsonSchema;
use serde::Serializer;
use serde::de::{self, Deserialize, Deserializer, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// Number whose dimension and range have been checked.
pub trait Dimensioned: Copy {
    /// Name, unit and range.
    const KIND: &'static Kind;

    /// Bounds of the type for schemas: JSON-schema keywords with their values.
    const BOUND: &'static [(&'static str, f64)] = &[];

    /// Checks a number given in solver units.
    ///
    /// # Errors
    /// When it is not finite or out of range; `found` is quoted in the message.
    fn checked(value: f64, found: &str) -> Result<Self, QuantityError>;

    /// Number in the solver's unit ([`Kind::unit`]).
    fn value(self) -> f64;
}

/// Reads text as a quantity: number, unit, dimension, range.
pub(super) fn read<Q: Dimensioned>(text: &str) -> Result<Q, QuantityError> {
    let (kind, found) = (Q::KIND, text.trim());
    if let Some(tonnes) = thicknesses(text).filter(|_| kind.dimension == FORCE) {
        let kilonewtons = 1e-3 * tonnes * factor("tonf").unwrap_or(f64::NAN);
        return Err(QuantityError::new(
            format!("{found:?} are thicknesses of the sheet, wanted {}", kind.name),
            format!("t is thicknesses of the sheet here: write {tonnes} tonf (tonnes-force) or {kilonewtons:.0} kN"),
        ));
    }
    let parsed = parse(text)?;
    // A bare 8 would be 800 %.
    let is_bare_share = kind.unit == "%" && !parsed.has_unit;
    if parsed.dimension == kind.dimension && !is_bare_share {
        return Q::checked(parsed.value, found);
    }
    Err(match parsed.has_unit {
        true => QuantityError::new(
            format!("{found:?} is {}, wanted {}", parsed.dimension.describe(), kind.name),
            format!("write for example {}", kind.written()),
        ),
        false => QuantityError::missing_unit(found, kind),
    })
}

/// `FromStr`, `Display`, `Deserialize` and `JsonSchema` of a quantity type.
macro_rules! implement {
    ([$($generic:tt)*] $type:ty) => {
        impl<$($generic)*> std::str::FromStr for $type {
            type Err = $crate::units::QuantityError;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                $crate::units::dimensioned::read(text)
            }
        }

        impl<$($generic)*> std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let value = $crate::units::Dimensioned::value(*self);
                match <Self as $crate::units::Dimensioned>::KIND.unit {
                    "" => write!(f, "{value}"),
                    "%" => write!(f, "{} %", $crate::units::rounded(100.0 * value)),
                    unit => write!(f, "{value} {unit}"),
                }
            }
        }

        impl<'de, $($generic)*> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                from.deserialize_any($crate::units::dimensioned::Written(std::marker::PhantomData))
            }
        }

        impl<$($generic)*> schemars::JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                <Self as $crate::units::Dimensioned>::KIND.name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $crate::units::dimensioned::schema::<Self>()
            }
        }
    };
}
pub(super) use implement;

/// Schema of a quantity: a number, or text with examples, kind and unit.
pub(super) fn schema<Q: Dimensioned>() -> schemars::Schema {
    let kind = Q::KIND;
    let mut schema = if kind.unit.is_empty() {
        schemars::json_schema!({ "type": "number" })
    } else {
        let note = format!("{} with its unit; solved in {}", kind.name, kind.unit);
        schemars::json_schema!({ "type": "string", "description": note, "examples": kind.examples, "x-quantity": kind.measured() })
    };
    for (keyword, bound) in Q::BOUND {
        schema.insert((*keyword).into(), (*bound).into());
    }
    schema
}

/// Reader of a quantity in a case file: text with a unit, or a plain number if the quantity has none.
pub(super) struct Written<Q>(pub PhantomData<Q>);

impl<Q: Dimensioned> Visitor<'_> for Written<Q> {
    type Value = Q;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let unit = if Q::KIND.unit.is_empty() { "" } else { " with its unit" };
        write!(f, "{}{unit}, such as {}", Q::KIND.name, Q::KIND.written())
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Q, E> {
        if Q::KIND.unit.is_empty() {
            return Err(E::invalid_type(de::Unexpected::Str(text), &self));
        }
        read(text).map_err(E::custom)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Q, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Q, E> {
        self.visit_f64(value as f64)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Q, E> {
        let (found, kind) = (format!("{value:?}"), Q::KIND);
        let found = found.strip_suffix(".0").unwrap_or(&found);
        if kind.unit.is_empty() {
            return Q::checked(value, found).map_err(E::custom);
        }
        Err(E::custom(QuantityError::missing_unit(found, kind)))
    }
}

/// Reads and writes a plain number in the solver's unit as a quantity is written, for fields of solver types:
/// `#[serde(with = "As::<Positive<Stress>>")] k: f64`; an `Option<f64>` as an `Option` of a quantity.
pub struct As<Q>(PhantomData<Q>);

/// Quantity, or one that may be left out.
pub trait Plain {
    /// `f64` or `Option<f64>`.
    type Number;

    /// Number in the solver's unit.
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
