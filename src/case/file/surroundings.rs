//! `[heat]`: initial temperature of the flat sheet, and heat flow; `[gas]`: pressure on the faces of the sheet.

use super::*;
use crate::model::{Face, HeatFlow, Pressure, RateControl, tool_sizes::extent};
use crate::table::Unit;
use crate::units::{
    Conductivity, Density, HeatTransfer, SpecificHeat, StrainRate, StressRate, Temperature, ZERO_CELSIUS,
};

/// Share of the plastic work that becomes heat, in common use for metals \[–\].
const PLASTIC_SHARE: f64 = 0.9;
/// Possible temperatures of a sheet \[K\].
const SHEET: std::ops::RangeInclusive<f64> = 70.0..=2500.0;
const KEY: &str = "heat.initial";
const EXAMPLE: &str = "write for example s0_mm,temperature_C in the first line and 30,230 below it";

/// Temperature of the sheet. Without density and specific heat it stays as it is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "density": ["specific_heat"], "specific_heat": ["density"], "conductivity": ["density"], "plastic_share": ["density"], "punch": ["density"], "die": ["density"], "holder": ["density"] }))]
pub struct Heat {
    /// Temperature of the flat sheet: one value, one for the part under the punch and one for the flange, or a CSV file.
    initial: InitialTemperature,
    /// Density of the sheet; with the specific heat, its temperature changes.
    density: Option<Positive<Density>>,
    /// Specific heat of the sheet, per mass.
    specific_heat: Option<Positive<SpecificHeat>>,
    /// Share of the plastic work that becomes heat; default 0.9.
    plastic_share: Option<Fraction>,
    /// Conductivity along the sheet; default none.
    conductivity: Option<Positive<Conductivity>>,
    /// Punch that heats or cools the sheet in contact.
    punch: Option<ToolHeat>,
    /// Die, likewise.
    die: Option<ToolHeat>,
    /// Holder, likewise.
    holder: Option<ToolHeat>,
}

/// Heat transfer from and to a tool whose temperature stays.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ToolHeat {
    /// Temperature of the tool.
    temperature: Positive<Temperature>,
    /// Heat-transfer coefficient of the contact.
    transfer: Positive<HeatTransfer>,
}

/// Temperature of the flat sheet.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
enum InitialTemperature {
    /// Uniform temperature.
    Uniform(Positive<Temperature>),
    /// By the tools: under the punch, from the die's throat outward, straight in between.
    Zones(Zones),
    /// CSV file beside the case: `s0_mm,temperature_C`, s0 rising; straight in between, held beyond its ends.
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
struct Zones {
    /// Inside the punch's radius.
    punch: Positive<Temperature>,
    /// From the die's throat outward.
    flange: Positive<Temperature>,
}

impl Heat {
    pub fn model(&self, tools: &[Tool], source: &Source) -> Result<model::Heat> {
        let initial = match &self.initial {
            InitialTemperature::Uniform(temperature) => temperature.value().into(),
            InitialTemperature::Zones(zones) => zones.temperature(tools, source)?,
            InitialTemperature::File(name) => from_file(name, source)?,
        };
        for temperature in [initial.smallest(), initial.largest()] {
            let (least, most) = (SHEET.start(), SHEET.end());
            let what = format!("the sheet cannot be at {temperature:.0} K: between {least} and {most} K");
            source.require(SHEET.contains(&temperature), KEY, what, "write \"230 °C\" for degrees Celsius")?;
        }
        Ok(model::Heat { initial, flow: self.flow(tools, source)? })
    }

    fn flow(&self, tools: &[Tool], source: &Source) -> Result<Option<HeatFlow>> {
        let capacity = match (self.density, self.specific_heat) {
            (Some(density), Some(specific_heat)) => density.value() * specific_heat.value(),
            (Some(_), None) => return Err(source.missing("heat", "specific_heat")),
            (None, Some(_)) => return Err(source.missing("heat", "density")),
            (None, None) => {
                let others = ["plastic_share", "conductivity", "punch", "die", "holder"];
                let why = "changes the temperature only of a sheet with a density and a specific heat";
                let help = "add density = \"2700 kg/m^3\" and specific_heat = \"900 J/kg/K\", or drop it";
                return source.refuse("heat", &others, why, help).map(|()| None);
            }
        };
        let mut exchanging = Vec::new();
        for (role, tool) in [(Role::Punch, self.punch), (Role::Die, self.die), (Role::Holder, self.holder)] {
            let Some(ToolHeat { temperature, transfer }) = tool else { continue };
            let what = format!("there is no {} to exchange heat with", role.name());
            let is_there = tools.iter().any(|tool| tool.role == role);
            source.require(is_there, &format!("heat.{}", role.name()), what, "drop it, or add the tool")?;
            let (temperature, transfer) = (temperature.value(), transfer.value());
            exchanging.push(model::ToolHeat { role, temperature, transfer });
        }
        let plastic_share = self.plastic_share.map_or(PLASTIC_SHARE, Dimensioned::value);
        let conductivity = self.conductivity.map_or(0.0, Dimensioned::value);
        Ok(Some(HeatFlow { capacity, plastic_share, conductivity, tools: exchanging }))
    }
}

impl Zones {
    fn temperature(&self, tools: &[Tool], source: &Source) -> Result<PiecewiseLinear> {
        let tool = |role: Role| tools.iter().find(|t| t.role == role);
        let Some((punch, die)) = tool(Role::Punch).zip(tool(Role::Die)) else {
            let what = "temperatures by zones need a punch and a die";
            return Err(source.error(KEY, what, "give one temperature, or a CSV file"));
        };
        let (inner, outer) = (extent(punch).1, die.profile.least_r());
        let points = vec![(inner, self.punch.value()), (outer.max(inner + 1e-6), self.flange.value())];
        Ok(PiecewiseLinear::new(points).expect("two rising places"))
    }
}

fn from_file(name: &str, source: &Source) -> Result<PiecewiseLinear> {
    let (lines, csv) = Named { file: name, what: "temperature", example: EXAMPLE, key: KEY }.open(source)?;
    let column = |name: &str, unit: Unit| {
        let factor = |i: usize| csv.unit(i).ok().filter(|(known, _)| *known == unit).map(|(_, factor)| factor);
        let mut fields = csv.header.fields.iter().enumerate().filter(|(_, field)| field.starts_with(name));
        fields.find_map(|(i, _)| Some((i, factor(i)?))).ok_or_else(|| {
            let what = format!("there is no column {}; found {}", unit.keyed(name), csv.names());
            lines.error(csv.header.line, what, EXAMPLE)
        })
    };
    let ((s0, factor), (temperature, _)) = (column("s0", Unit::Mm)?, column("temperature", Unit::Celsius)?);
    let mut points: Vec<(f64, f64)> = Vec::new();
    for row in &csv.rows {
        let fail = |what: &str| lines.error(row.line, what, EXAMPLE);
        let place = lines.number(row, s0)?.ok_or_else(|| fail("s0 is missing"))? * factor;
        let place = Length::checked(place, &place.to_string()).map_err(|error| fail(&error.to_string()))?.value();
        let celsius = lines.number(row, temperature)?.ok_or_else(|| fail("the temperature is missing"))?;
        let kelvin = celsius + ZERO_CELSIUS;
        let check = |holds: bool, what: &str| if holds { Ok(()) } else { Err(fail(what)) };
        check(SHEET.contains(&kelvin), &format!("the sheet cannot be at {celsius} °C"))?;
        check(points.last().is_none_or(|last| place > last.0), "s0 must rise from row to row")?;
        points.push((place, kelvin));
    }
    let empty = || lines.error(csv.header.line, "the temperature file has no rows", EXAMPLE);
    PiecewiseLinear::new(points).ok_or_else(empty)
}

/// Default norm of the strain rate that a superplastic pressure holds \[–\].
const NORM: f64 = 10.0;

/// Gas or oil pressure; alone it bulges the blank, against a punch it forms the sheet over it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// On the punch's side: pushes along the punch travel.
    lower: Option<GasFace>,
    /// On the die's side: pushes against the punch travel.
    upper: Option<GasFace>,
    /// Duration of a run without a punch.
    pub duration: Option<Positive<Time>>,
}

/// Pressure on one face.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "norm": ["strain_rate"], "max_pressure": ["strain_rate"], "max_pressure_rate": ["strain_rate"] }))]
struct GasFace {
    /// Pressure, or its history over time: [["0 s", "0 MPa"], ["10 s", "5 MPa"]]. Without a punch a single pressure is
    /// raised evenly over the duration, for a flat sheet cannot bear it at once.
    pressure: Option<History<NonNegative<Time>, NonNegative<Stress>>>,
    /// Superplastic forming, instead of a pressure: the strain rate that the pressure holds in every step.
    strain_rate: Option<Positive<StrainRate>>,
    /// Norm of the strain rate over the sheet's volume, 1 to 50: 1 is the mean, a large one the fastest place; default 10.
    norm: Option<Positive<Number>>,
    /// With a strain rate: largest pressure of the press; at it the rate falls below its target.
    max_pressure: Option<Positive<Stress>>,
    /// With a strain rate: fastest rise of the pressure of the press.
    max_pressure_rate: Option<Positive<StressRate>>,
    /// Distance of the seal from the axis or symmetry plane. Default: the holder's inner edge (lower face) or the end of the
    /// die's shoulder (upper face), or else the whole blank.
    within: Option<Positive<Length>>,
}

impl Gas {
    pub fn model(&self, tools: &[Tool], length: f64, source: &Source) -> Result<Vec<model::Gas>> {
        let tool = |role: Role| tools.iter().find(|t| t.role == role);
        let duration = self.duration.filter(|_| tool(Role::Punch).is_none()).map(Dimensioned::value);
        let lower = tool(Role::Holder).map(|holder| ("the holder's inner edge", extent(holder).0));
        let upper = tool(Role::Die).map(|die| ("the end of the die's shoulder", shoulder_end(die)));
        let faces = [(Face::Lower, "lower", &self.lower, lower), (Face::Upper, "upper", &self.upper, upper)];
        let mut gas = Vec::new();
        for (face, key, written, seal) in faces {
            let Some(written) = written else { continue };
            let pressure = written.pressure(key, duration, source)?;
            let within = written.within.map(Dimensioned::value).or_else(|| {
                let (what, r) = seal?;
                source.note(format!("pressure acts up to {what}, {}", Amount::size(r)));
                Some(r)
            });
            gas.push(model::Gas { face, pressure, within: within.unwrap_or(length) });
        }
        let held = gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count();
        let what = "both faces hold a strain rate, and there is one sheet";
        let help = "give one of the faces a pressure: the other follows";
        source.require(held < 2, "gas.upper.strain_rate", what, help)?;
        let help = "add lower = { pressure = \"5 MPa\" } or upper";
        source.require(!gas.is_empty(), "gas", "[gas] has no pressure", help)?;
        Ok(gas)
    }
}

impl GasFace {
    /// Pressure over time or for a strain rate; without a punch one pressure is raised over the `duration` \[s\].
    fn pressure(&self, key: &str, duration: Option<f64>, source: &Source) -> Result<Pressure> {
        let table = format!("gas.{key}");
        source.one_of(&table, &["pressure", "strain_rate"], "keep one: the other follows")?;
        if let Some(target) = self.strain_rate {
            let exponent = self.norm.map_or(NORM, Dimensioned::value);
            let what = format!("`norm` must lie between 1 and 50, found {exponent}");
            let is_norm = (1.0..=50.0).contains(&exponent);
            source.require(is_norm, &format!("{table}.norm"), what, "10 follows the fastest place closely")?;
            let mut control = RateControl::new(target.value(), exponent);
            control.max_pressure = self.max_pressure.map_or(f64::INFINITY, Dimensioned::value);
            control.max_rise = self.max_pressure_rate.map_or(f64::INFINITY, Dimensioned::value);
            return Ok(Pressure::Rate(control));
        }
        let why = "belongs to a pressure that holds a strain rate, and there is no `strain_rate`";
        let help = "drop it, or give a strain_rate instead of the pressure";
        source.refuse(&table, &["max_pressure", "max_pressure_rate", "norm"], why, help)?;
        let written = self.pressure.as_ref().ok_or_else(|| source.missing(&table, "pressure"))?;
        if let (History::Constant(pressure), Some(duration)) = (written, duration) {
            let (amount, time) = (Amount::given_stress(pressure.value()), Amount::time(duration));
            source.note(format!("the pressure of {amount} on the {key} face is raised evenly over the run's {time}"));
            let rise = PiecewiseLinear::new(vec![(0.0, 0.0), (duration, pressure.value())]);
            return Ok(Pressure::OverTime(rise.expect("a duration is above 0")));
        }
        let path = format!("{table}.pressure");
        Ok(Pressure::OverTime(written.curve(&path, "times", source, |pressure, _| Ok(pressure.value()))?))
    }
}
