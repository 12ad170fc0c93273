//! `friction` of a tool or a side of the sheet.

use crate::units::{Fraction, NonNegative, Number, Positive, Speed, Stress};
use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::{Deserialize, Deserializer, de};
use std::fmt;

/// Coulomb's coefficient, or another law with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Friction {
    Coulomb(Fraction),
    Law(FrictionLaw),
}

/// Exactly one law.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrictionLaw {
    pub pressure_dependent: Option<PressureDependent>,
    pub stribeck: Option<Stribeck>,
    pub tresca: Option<Tresca>,
}

/// Coefficient that falls with pressure: μ = coefficient (p/reference)^(exponent − 1).
///
/// Source: in common use for lubricated sheet; I. Gil et al., Tribology International 103 (2016) 266–273 (not read).
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PressureDependent {
    /// At the reference pressure, 0 to 1.
    #[schemars(example = 0.12)]
    pub coefficient: Fraction,
    /// Reference pressure.
    #[schemars(example = "5 MPa")]
    pub reference: Positive<Stress>,
    /// 0 to 1; 1 is Coulomb's law.
    #[schemars(example = 0.9)]
    pub exponent: Fraction,
}

/// Coefficient that depends on the sliding speed v: sliding + (at_rest − sliding) exp(−(v/speed)²) + viscous v.
///
/// Source: in common use; B. Armstrong-Hélouvry et al., Automatica 30 (1994) 1083–1138 (not read).
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stribeck {
    /// Of the slowest sliding, 0 to 1.
    #[schemars(example = 0.15)]
    pub at_rest: Fraction,
    /// Of fast sliding, 0 to 1.
    #[schemars(example = 0.05)]
    pub sliding: Fraction,
    /// Stribeck's speed.
    #[schemars(example = "10 mm/s")]
    pub speed: Positive<Speed>,
    /// Rise of the coefficient with the speed, per mm/s; none when not given.
    #[schemars(example = 0.0001)]
    pub viscous: Option<NonNegative<Number>>,
}

/// Friction stress of at most a share of the sheet's shear yield stress k.
///
/// Source: I. Bobrovskij et al., Metals 12 (2022) 239; E. Orowan (1943) (not read). The smooth passage is ours.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tresca {
    /// Share m of k, 0 to 1.
    #[schemars(example = 0.2)]
    pub factor: Fraction,
    /// Coulomb's coefficient under light pressure; 1/√3, the largest that makes sense, when not given.
    #[schemars(example = 0.1)]
    pub coefficient: Option<Fraction>,
}

/// Friction by the face of the sheet, for tools that do not name their own, and where all of the case's friction comes from.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sides {
    /// Of the face that punch and holder touch: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub punch_side: Option<Friction>,
    /// Of the face that the die touches: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub die_side: Option<Friction>,
    /// Where the coefficients of all tools come from: how they were measured, or author and year; left out where they are
    /// assumed.
    #[schemars(example = &"strip drawing with this oil")]
    pub source: Option<String>,
}

impl<'de> Deserialize<'de> for Friction {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> de::Visitor<'de> for Either {
            type Value = Friction;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "a plain number, such as 0.1, or a law, such as {{ tresca = {{ factor = 0.2 }} }}")
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Friction, E> {
                Fraction::deserialize(de::value::I64Deserializer::new(value)).map(Friction::Coulomb)
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Friction, E> {
                Fraction::deserialize(de::value::F64Deserializer::new(value)).map(Friction::Coulomb)
            }

            fn visit_map<A: de::MapAccess<'de>>(self, law: A) -> Result<Friction, A::Error> {
                FrictionLaw::deserialize(MapAccessDeserializer::new(law)).map(Friction::Law)
            }
        }
        from.deserialize_any(Either)
    }
}

impl JsonSchema for Friction {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Friction".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let (number, law) = (generator.subschema_for::<Fraction>(), generator.subschema_for::<FrictionLaw>());
        schemars::json_schema!({ "anyOf": [number, law] })
    }
}
