//! `[material] anisotropy`: a mean r-value, or those of three directions.

use crate::material::RValues;
use crate::units::{Dimensioned, Number, Positive};
use serde::Deserialize;
use serde::de::{self, Deserializer, IntoDeserializer, MapAccess, Visitor, value};
use std::fmt;

/// Normal anisotropy: the mean, or what it is the mean of.
#[derive(Clone, Copy, Debug, PartialEq, schemars::JsonSchema)]
#[schemars(untagged)]
pub enum Anisotropy {
    /// r̄.
    Mean(Positive<Number>),
    /// By direction.
    Directions(Directions),
}

/// r at 0°, 45° and 90° to the rolling direction; r̄ = (r0 + 2 r45 + r90)/4.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Directions {
    /// Along the rolling direction.
    #[schemars(example = 0.525)]
    pub r0: Positive<Number>,
    /// At 45°.
    #[schemars(example = 0.248)]
    pub r45: Positive<Number>,
    /// Across.
    #[schemars(example = 0.429)]
    pub r90: Positive<Number>,
}

impl Anisotropy {
    /// r̄ \[–\].
    pub fn mean(self) -> f64 {
        match self {
            Self::Mean(mean) => mean.value(),
            Self::Directions(_) => self.directions().map_or(1.0, |r| r.mean()),
        }
    }

    /// The r-values, where they are given by direction.
    pub fn directions(self) -> Option<RValues> {
        let Self::Directions(r) = self else { return None };
        Some(RValues { r0: r.r0.value(), r45: r.r45.value(), r90: r.r90.value() })
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Anisotropy;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("r̄ such as 1.6, or { r0 = 0.5, r45 = 0.3, r90 = 0.4 }")
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Anisotropy, E> {
        self.visit_f64(number as f64)
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<Anisotropy, E> {
        Positive::deserialize(number.into_deserializer()).map(Anisotropy::Mean)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Anisotropy, A::Error> {
        Directions::deserialize(value::MapAccessDeserializer::new(map)).map(Anisotropy::Directions)
    }
}

impl<'de> Deserialize<'de> for Anisotropy {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Reader)
    }
}
