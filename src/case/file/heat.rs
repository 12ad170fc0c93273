//! `[heat]`: the sheet's temperature and what changes it.

use crate::units::{Conductivity, Density, Fraction, HeatTransfer, Positive, SpecificHeat, Temperature};
use serde::de::value::{MapAccessDeserializer, StrDeserializer};
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// Temperature of the sheet. Without density and specific heat it stays as it is given.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "density": ["specific_heat"], "specific_heat": ["density"], "conductivity": ["density"], "plastic_share": ["density"], "punch": ["density"], "die": ["density"], "holder": ["density"] }))]
pub struct Heat {
    /// Of the flat sheet: one temperature, one for the part under the punch and one for the flange, or a CSV file.
    pub initial: InitialTemperature,
    /// Of the sheet; with the specific heat, its temperature changes.
    #[schemars(example = "2700 kg/m^3")]
    pub density: Option<Positive<Density>>,
    /// Of the sheet, per mass.
    #[schemars(example = "900 J/kg/K")]
    pub specific_heat: Option<Positive<SpecificHeat>>,
    /// Share of the plastic work that becomes heat; 0.9 when not given.
    #[schemars(example = 0.9)]
    pub plastic_share: Option<Fraction>,
    /// Along the sheet; none when not given.
    #[schemars(example = "130 W/m/K")]
    pub conductivity: Option<Positive<Conductivity>>,
    /// A tool that heats or cools what lies on it.
    pub punch: Option<ToolHeat>,
    /// As `punch`, of the die.
    pub die: Option<ToolHeat>,
    /// As `punch`, of the holder.
    pub holder: Option<ToolHeat>,
}

/// Heat transfer from and to a tool whose temperature stays.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct ToolHeat {
    /// Temperature of the tool.
    #[schemars(example = "25 °C")]
    pub temperature: Positive<Temperature>,
    /// Heat-transfer coefficient of the contact.
    #[schemars(example = "1.4 kW/m^2/K")]
    pub transfer: Positive<HeatTransfer>,
}

/// Temperature of the flat sheet.
#[derive(Clone, Debug, schemars::JsonSchema)]
#[schemars(untagged)]
pub enum InitialTemperature {
    /// The same everywhere.
    Uniform(Positive<Temperature>),
    /// By the tools: under the punch, from the die's throat outward, straight in between.
    Zones(Zones),
    /// CSV file, looked up from the case file's folder: columns `s0_mm,temperature_C`, s0 rising; straight in between,
    /// held before the first and beyond the last.
    File(String),
}

/// Temperatures by the tools' places on the flat sheet.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Zones {
    /// Inside the punch's radius.
    #[schemars(example = "25 °C")]
    pub punch: Positive<Temperature>,
    /// From the die's throat outward.
    #[schemars(example = "230 °C")]
    pub flange: Positive<Temperature>,
}

impl<'de> Deserialize<'de> for InitialTemperature {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Written;
        impl<'de> Visitor<'de> for Written {
            type Value = InitialTemperature;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                write!(f, "a temperature such as \"230 °C\", {{ punch = .., flange = .. }}, or the name of a CSV file")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<InitialTemperature, E> {
                if text.to_lowercase().ends_with(".csv") {
                    return Ok(InitialTemperature::File(text.to_owned()));
                }
                Positive::deserialize(StrDeserializer::new(text)).map(InitialTemperature::Uniform)
            }

            fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<InitialTemperature, A::Error> {
                Zones::deserialize(MapAccessDeserializer::new(table)).map(InitialTemperature::Zones)
            }
        }
        from.deserialize_any(Written)
    }
}
