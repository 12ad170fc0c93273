//! `[heat]`: initial temperature of the flat sheet, and heat flow.

use super::lines::Named;
use crate::case::file::{self, InitialTemperature};
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::extent;
use crate::model::{Heat, HeatFlow, Role, Tool, ToolHeat};
use crate::numerics::PiecewiseLinear;
use crate::table::Unit;
use crate::units::{Dimensioned, Length, ZERO_CELSIUS};

/// Share of the plastic work that becomes heat, in common use for metals \[–\].
const PLASTIC_SHARE: f64 = 0.9;
/// Possible temperatures of a sheet \[K\].
const SHEET: std::ops::RangeInclusive<f64> = 70.0..=2500.0;
const KEY: &str = "heat.initial";
const EXAMPLE: &str = "write for example s0_mm,temperature_C in the first line and 30,230 below it";

pub(super) fn convert(file: &file::Heat, tools: &[Tool], source: &Source) -> Result<Heat, CaseError> {
    let initial = match &file.initial {
        InitialTemperature::Uniform(temperature) => temperature.value().into(),
        InitialTemperature::Zones(zones) => by_zones(zones, tools, source)?,
        InitialTemperature::File(name) => by_file(name, source)?,
    };
    for temperature in [initial.smallest(), initial.largest()] {
        let (least, most) = (SHEET.start(), SHEET.end());
        let what = format!("the sheet cannot be at {temperature:.0} K: between {least} and {most} K");
        source.require(SHEET.contains(&temperature), KEY, what, "write \"230 °C\" for degrees Celsius")?;
    }
    Ok(Heat { initial, flow: flow(file, tools, source)? })
}

fn flow(file: &file::Heat, tools: &[Tool], source: &Source) -> Result<Option<HeatFlow>, CaseError> {
    let capacity = match (file.density, file.specific_heat) {
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
    for (role, tool) in [(Role::Punch, file.punch), (Role::Die, file.die), (Role::Holder, file.holder)] {
        let Some(tool) = tool else { continue };
        let what = format!("there is no {} to exchange heat with", role.name());
        let is_there = tools.iter().any(|tool| tool.role == role);
        source.require(is_there, &format!("heat.{}", role.name()), what, "drop it, or add the tool")?;
        exchanging.push(ToolHeat { role, temperature: tool.temperature.value(), transfer: tool.transfer.value() });
    }
    Ok(Some(HeatFlow {
        capacity,
        plastic_share: file.plastic_share.map_or(PLASTIC_SHARE, Dimensioned::value),
        conductivity: file.conductivity.map_or(0.0, Dimensioned::value),
        tools: exchanging,
    }))
}

/// Temperature under the punch, and from the die's throat outward.
fn by_zones(zones: &file::Zones, tools: &[Tool], source: &Source) -> Result<PiecewiseLinear, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let Some((punch, die)) = tool(Role::Punch).zip(tool(Role::Die)) else {
        let help = "give one temperature, or a CSV file";
        return Err(source.error(KEY, "temperatures by zones need a punch and a die", help));
    };
    let (inner, outer) = (extent(punch).1, die.profile.least_r());
    let points = vec![(inner, zones.punch.value()), (outer.max(inner + 1e-6), zones.flange.value())];
    Ok(PiecewiseLinear::new(points).expect("two rising places"))
}

/// Temperature from the columns `s0_mm,temperature_C`.
fn by_file(name: &str, source: &Source) -> Result<PiecewiseLinear, CaseError> {
    let (lines, csv) = Named { file: name, what: "temperature", example: EXAMPLE, key: KEY }.open(source)?;
    let column = |name: &str, unit: Unit| {
        let is_it = |(i, field): (usize, &str)| {
            Some((i, csv.unit(i).ok().filter(|u| u.0 == unit && field.starts_with(name))?.1))
        };
        csv.header.fields.iter().enumerate().find_map(is_it).ok_or_else(|| {
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
        if !SHEET.contains(&kelvin) {
            return Err(fail(&format!("the sheet cannot be at {celsius} °C")));
        }
        if points.last().is_some_and(|last| place <= last.0) {
            return Err(fail("s0 must rise from row to row"));
        }
        points.push((place, kelvin));
    }
    let empty = || lines.error(csv.header.line, "the temperature file has no rows", EXAMPLE);
    PiecewiseLinear::new(points).ok_or_else(empty)
}
