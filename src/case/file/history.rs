//! A quantity that stays, or one that changes from point to point.

use crate::units::Dimensioned;
use schemars::JsonSchema;
use serde::de::value::{SeqAccessDeserializer, StrDeserializer};
use serde::{Deserialize, Deserializer, de};
use std::fmt;
use std::marker::PhantomData;

/// A value as text, or a list of points `[x, value]` with x rising.
#[derive(Clone, Debug, PartialEq)]
pub enum Given<X, V> {
    /// One value that stays.
    Constant(V),
    /// Values at rising x, straight between them.
    Points(Vec<(X, V)>),
}

impl<X: Dimensioned, V: Copy> Given<X, V> {
    /// The points with the x in solver units; a constant is one point.
    pub fn points(&self) -> Vec<(f64, V)> {
        match self {
            Self::Constant(value) => vec![(0.0, *value)],
            Self::Points(points) => points.iter().map(|(x, value)| (x.value(), *value)).collect(),
        }
    }
}

impl<'de, X: Deserialize<'de>, V: Deserialize<'de>> Deserialize<'de> for Given<X, V> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either<X, V>(PhantomData<(X, V)>);
        impl<'de, X: Deserialize<'de>, V: Deserialize<'de>> de::Visitor<'de> for Either<X, V> {
            type Value = Given<X, V>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "a value with its unit, or a list of points [x, value]")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                V::deserialize(StrDeserializer::new(text)).map(Given::Constant)
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                V::deserialize(de::value::I64Deserializer::new(value)).map(Given::Constant)
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                V::deserialize(de::value::F64Deserializer::new(value)).map(Given::Constant)
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, points: A) -> Result<Self::Value, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(points)).map(Given::Points)
            }
        }
        from.deserialize_any(Either(PhantomData))
    }
}

impl<X: JsonSchema, V: JsonSchema> JsonSchema for Given<X, V> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("{}Over{}", V::schema_name(), X::schema_name()).into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let (value, points) = (generator.subschema_for::<V>(), generator.subschema_for::<Vec<(X, V)>>());
        schemars::json_schema!({ "anyOf": [value, points] })
    }
}
