//! `[gas]`, `[heat]`, and quantities that change over the run.

use super::untagged::untagged;
use crate::units::{
    Conductivity, Density, Dimensioned, Force, Fraction, HeatTransfer, Kind, Length, LineForce, NonNegative, Number,
    Positive, SpecificHeat, StrainRate, Stress, StressRate, Temperature, Time, parse,
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::value::{SeqAccessDeserializer, StrDeserializer};
use serde::de::{Deserializer, Error, IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, de};
use std::{borrow::Cow, fmt, marker::PhantomData};

/// Gas or oil pressure; alone it bulges the blank, against a punch it forms the sheet over it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// On the punch's side: pushes along the punch travel.
    pub lower: Option<GasFace>,
    /// On the die's side: pushes against the punch travel.
    pub upper: Option<GasFace>,
    /// Duration of a run without a punch.
    #[schemars(example = "10 s")]
    pub duration: Option<Positive<Time>>,
}

/// Pressure on one face.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "norm": ["strain_rate"], "max_pressure": ["strain_rate"], "max_pressure_rate": ["strain_rate"] }))]
pub struct GasFace {
    /// Pressure, or its history over time: [["0 s", "0 MPa"], ["10 s", "5 MPa"]]. Without a punch a single pressure is
    /// raised evenly over the duration, for a flat sheet cannot bear it at once.
    #[schemars(example = "5 MPa")]
    pub pressure: Option<Given<NonNegative<Time>, NonNegative<Stress>>>,
    /// Superplastic forming, instead of a pressure: the strain rate that the pressure holds in every step.
    #[schemars(example = "0.001 /s")]
    pub strain_rate: Option<Positive<StrainRate>>,
    /// Norm of the strain rate over the sheet's volume, 1 to 50: 1 is the mean, a large one the fastest place; default 10.
    #[schemars(example = 10.0)]
    pub norm: Option<Positive<Number>>,
    /// With a strain rate: largest pressure of the press; at it the rate falls below its target.
    #[schemars(example = "2 MPa")]
    pub max_pressure: Option<Positive<Stress>>,
    /// With a strain rate: fastest rise of the pressure of the press.
    #[schemars(example = "0.01 MPa/s")]
    pub max_pressure_rate: Option<Positive<StressRate>>,
    /// Distance of the seal from the axis or symmetry plane. Default: the holder's inner edge (lower face) or the end of the
    /// die's shoulder (upper face), or else the whole blank.
    #[schemars(example = "50 mm")]
    pub within: Option<Positive<Length>>,
}

/// Temperature of the sheet. Without density and specific heat it stays as it is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "density": ["specific_heat"], "specific_heat": ["density"], "conductivity": ["density"], "plastic_share": ["density"], "punch": ["density"], "die": ["density"], "holder": ["density"] }))]
pub struct Heat {
    /// Temperature of the flat sheet: one value, one for the part under the punch and one for the flange, or a CSV file.
    pub initial: InitialTemperature,
    /// Density of the sheet; with the specific heat, its temperature changes.
    #[schemars(example = "2700 kg/m^3")]
    pub density: Option<Positive<Density>>,
    /// Specific heat of the sheet, per mass.
    #[schemars(example = "900 J/kg/K")]
    pub specific_heat: Option<Positive<SpecificHeat>>,
    /// Share of the plastic work that becomes heat; default 0.9.
    #[schemars(example = 0.9)]
    pub plastic_share: Option<Fraction>,
    /// Conductivity along the sheet; default none.
    #[schemars(example = "130 W/m/K")]
    pub conductivity: Option<Positive<Conductivity>>,
    /// Punch that heats or cools the sheet in contact.
    pub punch: Option<ToolHeat>,
    /// Die, likewise.
    pub die: Option<ToolHeat>,
    /// Holder, likewise.
    pub holder: Option<ToolHeat>,
}

/// Heat transfer from and to a tool whose temperature stays.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolHeat {
    /// Temperature of the tool.
    #[schemars(example = "25 °C")]
    pub temperature: Positive<Temperature>,
    /// Heat-transfer coefficient of the contact.
    #[schemars(example = "1.4 kW/m^2/K")]
    pub transfer: Positive<HeatTransfer>,
}

/// Temperature of the flat sheet.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub enum InitialTemperature {
    /// Uniform temperature.
    Uniform(Positive<Temperature>),
    /// By the tools: under the punch, from the die's throat outward, straight in between.
    Zones(Zones),
    /// CSV file, looked up from the case file's folder: columns `s0_mm,temperature_C`, s0 rising; straight in between,
    /// held before the first and beyond the last.
    File(String),
}

untagged!(
    InitialTemperature, "a temperature such as \"230 °C\", { punch = .., flange = .. }, or the name of a CSV file",
    text(text) => match text.to_lowercase().ends_with(".csv") {
        true => Ok(InitialTemperature::File(text.to_owned())),
        false => Positive::deserialize(text.into_deserializer()).map(InitialTemperature::Uniform),
    },
    table => InitialTemperature::Zones
);

/// Temperatures by the tools' places on the flat sheet.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Zones {
    /// Inside the punch's radius.
    #[schemars(example = "25 °C")]
    pub punch: Positive<Temperature>,
    /// From the die's throat outward.
    #[schemars(example = "230 °C")]
    pub flange: Positive<Temperature>,
}

/// Value as text, or a list of points `[x, value]` with x rising.
#[derive(Clone, Debug, PartialEq)]
pub enum Given<X, V> {
    /// Value that stays.
    Constant(V),
    /// Values at rising x, straight between them.
    Points(Vec<(X, V)>),
}

impl<X: Dimensioned, V: Copy> Given<X, V> {
    /// Points with the x in solver units; a constant is one point.
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
        impl<'de, X: Deserialize<'de>, V: Deserialize<'de>> Visitor<'de> for Either<X, V> {
            type Value = Given<X, V>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "a value with its unit, or a list of points [x, value]")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
                V::deserialize(StrDeserializer::new(text)).map(Given::Constant)
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Self::Value, E> {
                V::deserialize(de::value::I64Deserializer::new(value)).map(Given::Constant)
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Self::Value, E> {
                V::deserialize(de::value::F64Deserializer::new(value)).map(Given::Constant)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, points: A) -> Result<Self::Value, A::Error> {
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

    fn schema_name() -> Cow<'static, str> {
        format!("{}Over{}", V::schema_name(), X::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (value, points) = (generator.subschema_for::<V>(), generator.subschema_for::<Vec<(X, V)>>());
        schemars::json_schema!({ "anyOf": [value, points] })
    }
}

/// Enum of a quantity of the whole section and the same per mm of depth.
macro_rules! whole_or_per_depth {
    ($(#[$doc:meta])* $type:ident, $whole:ty, $per_depth:ty, $expecting:literal, $examples:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum $type {
            /// Whole section: axisymmetric, or in plane strain over a known depth.
            InAll(NonNegative<$whole>),
            /// Per mm of depth, plane strain.
            PerDepth(NonNegative<$per_depth>),
        }

        untagged!(
            $type, $expecting,
            text(text) => {
                let per_depth = parse(text).is_ok_and(|p| p.dimension == <$per_depth as Dimensioned>::KIND.dimension);
                let read =
                    if per_depth { text.parse().map($type::PerDepth) } else { text.parse().map($type::InAll) };
                read.map_err(E::custom)
            },
            number(value) => Kinds.visit_str(&value.to_string())
        );

        impl JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> Cow<'static, str> {
                stringify!($type).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                let kinds = [NonNegative::<$whole>::KIND, NonNegative::<$per_depth>::KIND];
                let quantity = kinds.map(Kind::measured).join(", or ");
                schemars::json_schema!({ "type": "string", "examples": $examples, "x-quantity": quantity })
            }
        }
    };
}

whole_or_per_depth!(
    /// Force of the whole section, or per mm of its depth.
    HolderForce, Force, LineForce,
    "a force with its unit, such as \"80 kN\" (axisymmetric) or \"2600 N/mm\" (plane strain)",
    ["80 kN", "2600 N/mm"]
);
whole_or_per_depth!(
    /// Stiffness of the whole holder: force per length, or force per length and depth.
    Stiffness, LineForce, Stress,
    "a stiffness with its unit, such as \"5 kN/mm\" (axisymmetric) or \"50 N/mm^2\" (plane strain)",
    ["5 kN/mm", "50 N/mm^2"]
);
