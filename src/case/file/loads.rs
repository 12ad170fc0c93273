//! `[gas]`, `[heat]`, and quantities that change over the run.

use super::untagged::{inline_schema, untagged};
use crate::model::Extent;
use crate::units::{
    Conductivity, Density, Dimensioned, Force, Fraction, HeatTransfer, Kind, Length, LineForce, NonNegative, Number,
    Positive, SpecificHeat, StrainRate, Stress, StressRate, Temperature, Time, parse,
};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Error, IntoDeserializer};

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
    [] InitialTemperature, "a temperature such as \"230 °C\", { punch = .., flange = .. }, or the name of a CSV file",
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

untagged!(
    [X: Sized, V: Sized] Given<X, V>, "a value with its unit, or a list of points [x, value]",
    text(text) => V::deserialize(text.into_deserializer()).map(Given::Constant),
    number(value) => V::deserialize(value.into_deserializer()).map(Given::Constant),
    list => Given::Points
);

inline_schema!(
    [X: JsonSchema, V: JsonSchema] Given<X, V>, format!("{}Over{}", V::schema_name(), X::schema_name()),
    |generator| {
        let (value, points) = (generator.subschema_for::<V>(), generator.subschema_for::<Vec<(X, V)>>());
        schemars::json_schema!({ "anyOf": [value, points] })
    }
);

/// Force of the whole section, or per mm of its depth.
pub type HolderForce = Extensive<Force, LineForce>;
/// Stiffness of the whole holder: force per length, or force per length and depth.
pub type Stiffness = Extensive<LineForce, Stress>;

/// Quantity of the whole section, or the same per mm of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extensive<W, P> {
    /// Whole section: axisymmetric, or in plane strain over a known depth.
    InAll(NonNegative<W>),
    /// Per mm of depth, plane strain.
    PerDepth(NonNegative<P>),
}

impl<W: Dimensioned, P: Dimensioned> Extensive<W, P> {
    /// Value in the units of the extent; else the case that it does not fit.
    pub fn in_extent(self, extent: Extent) -> Result<f64, &'static str> {
        match (self, extent) {
            (Self::InAll(_), Extent::PerDepth) => Err("in plane strain without blank.depth"),
            (Self::PerDepth(_), Extent::Ring) => Err("in an axisymmetric case"),
            (Self::PerDepth(value), Extent::Depth(depth)) => Ok(value.value() * depth),
            (Self::PerDepth(value), Extent::PerDepth) => Ok(value.value()),
            (Self::InAll(value), _) => Ok(value.value()),
        }
    }

    fn read<E: Error>(text: &str) -> Result<Self, E> {
        match parse(text).is_ok_and(|parsed| parsed.dimension == P::KIND.dimension()) {
            true => NonNegative::deserialize(text.into_deserializer()).map(Self::PerDepth),
            false => NonNegative::deserialize(text.into_deserializer()).map(Self::InAll),
        }
    }
}

untagged!(
    [W: Dimensioned, P: Dimensioned] Extensive<W, P>, "a value with its unit, of the whole section or per mm of depth",
    text(text) => Extensive::read(text),
    number(value) => Extensive::read(&value.to_string())
);

inline_schema!(
    [W: Dimensioned, P: Dimensioned] Extensive<W, P>, format!("{} in all or per depth", W::KIND.name),
    |_generator| {
        let quantity = [W::KIND, P::KIND].map(Kind::measured).join(", or ");
        schemars::json_schema!({ "type": "string", "examples": [W::KIND.examples[0], P::KIND.examples[0]], "x-quantity": quantity })
    }
);
