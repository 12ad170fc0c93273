//! Scatter of a class of sheets by its delivery standard: declared, never measured on a coil.

use crate::case::thickness_tolerance::Standard;
use crate::units::{Dimensioned, Stress};
use serde::{Deserialize, Deserializer, de::Error};

/// Scatter of a class of sheets.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Class {
    strength: Option<[Stress; 2]>,
    /// Standard of its thickness tolerance.
    #[serde(default, deserialize_with = "standard")]
    pub thickness: Option<Standard>,
    /// Source of the range of its strength.
    pub source: String,
}

impl Class {
    /// Least and largest tensile strength that the standard allows \[MPa\].
    pub fn strength(&self) -> Option<[f64; 2]> {
        self.strength.as_ref().map(|ends| ends.each_ref().map(|end| end.value()))
    }

    /// Half of that range over its middle \[–\].
    pub fn strength_share(&self) -> Option<f64> {
        self.strength().map(|[low, high]| (high - low) / (high + low))
    }
}

fn standard<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Standard>, D::Error> {
    let name = String::deserialize(deserializer)?;
    let known = Standard::ALL.into_iter().find(|standard| standard.name() == name);
    known.map(Some).ok_or_else(|| D::Error::custom(format!("no table of tolerances for {name}")))
}
