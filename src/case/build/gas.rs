//! `[gas]`: pressure on the faces of the sheet.

use super::tools::Sheet;
use super::values::history;
use crate::case::file::{self, Given};
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{extent, shoulder_end};
use crate::model::{Face, Gas, Pressure, RateControl, Role, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::{Amount, Dimensioned};

/// Default norm of the strain rate that a superplastic pressure holds \[–\].
const NORM: f64 = 10.0;

pub(super) fn convert(file: &file::Gas, tools: &[Tool], sheet: &Sheet, source: &Source) -> Result<Vec<Gas>, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let duration = file.duration.filter(|_| tool(Role::Punch).is_none()).map(Dimensioned::value);
    let lower = tool(Role::Holder).map(|holder| ("the holder's inner edge", extent(holder).0));
    let upper = tool(Role::Die).map(|die| ("the end of the die's shoulder", shoulder_end(die)));
    let mut gas = Vec::new();
    for (face, key, given, seal) in
        [(Face::Lower, "lower", &file.lower, lower), (Face::Upper, "upper", &file.upper, upper)]
    {
        let Some(given) = given else { continue };
        let pressure = pressure(given, key, duration, source)?;
        let within = given.within.map(Dimensioned::value).or_else(|| {
            let (what, r) = seal?;
            source.note(format!("gas acts up to {what}, {}", Amount::size(r)));
            Some(r)
        });
        gas.push(Gas { face, pressure, within: within.unwrap_or(sheet.length) });
    }
    let held = gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count();
    let help = "give one of the faces a pressure: the other follows";
    source.require(held < 2, "gas.upper.strain_rate", "both faces hold a strain rate, and there is one sheet", help)?;
    let help = "add lower = { pressure = \"5 MPa\" } or upper";
    source.require(!gas.is_empty(), "gas", "[gas] has no pressure", help)?;
    Ok(gas)
}

/// Pressure over time or for a strain rate; without a punch one pressure is raised over the `duration` \[s\].
fn pressure(face: &file::GasFace, key: &str, duration: Option<f64>, source: &Source) -> Result<Pressure, CaseError> {
    let table = format!("gas.{key}");
    source.one_of(&table, &["pressure", "strain_rate"], "keep one: the other follows")?;
    if let Some(target) = face.strain_rate {
        let exponent = face.norm.map_or(NORM, Dimensioned::value);
        let what = format!("`norm` must lie between 1 and 50, found {exponent}");
        let is_norm = (1.0..=50.0).contains(&exponent);
        source.require(is_norm, &format!("{table}.norm"), what, "10 follows the fastest place closely")?;
        let mut control = RateControl::new(target.value(), exponent);
        control.max_pressure = face.max_pressure.map_or(f64::INFINITY, Dimensioned::value);
        control.max_rise = face.max_pressure_rate.map_or(f64::INFINITY, Dimensioned::value);
        return Ok(Pressure::Rate(control));
    }
    let why = "belongs to a pressure that holds a strain rate, and there is no `strain_rate`";
    let help = "drop it, or give a strain_rate instead of the pressure";
    source.refuse(&table, &["max_pressure", "max_pressure_rate", "norm"], why, help)?;
    let given = face.pressure.as_ref().ok_or_else(|| source.missing(&table, "pressure"))?;
    if let (Given::Constant(pressure), Some(duration)) = (given, duration) {
        let pressure = pressure.value();
        let (amount, time) = (Amount::given_stress(pressure), Amount::time(duration));
        source.note(format!("the pressure of {amount} on the {key} face is raised evenly over the run's {time}"));
        let rise = PiecewiseLinear::new(vec![(0.0, 0.0), (duration, pressure)]).expect("a duration is above 0");
        return Ok(Pressure::OverTime(rise));
    }
    let path = format!("{table}.pressure");
    Ok(Pressure::OverTime(history(given, &path, "times", source, |pressure, _| Ok(pressure.value()))?))
}
