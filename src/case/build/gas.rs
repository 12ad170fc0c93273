//! `[gas]`: pressure on the faces of the sheet.

use super::holder::history;
use super::tools::Sheet;
use super::values::keys_present;
use crate::case::file::{self, Given};
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{extent, shoulder_end};
use crate::model::{Face, Gas, Pressure, RateControl, Role, Tool};
use crate::units::{Amount, Dimensioned};

/// Default norm of the strain rate that a superplastic pressure holds \[–\].
const NORM: f64 = 10.0;

pub(super) fn convert(file: &file::Gas, tools: &[Tool], sheet: &Sheet, source: &Source) -> Result<Vec<Gas>, CaseError> {
    let tool = |role: Role| tools.iter().find(|t| t.role == role);
    let mut gas = Vec::new();
    for (face, key, given) in [(Face::Lower, "lower", &file.lower), (Face::Upper, "upper", &file.upper)] {
        let Some(given) = given else { continue };
        let duration = file.duration.filter(|_| tool(Role::Punch).is_none()).map(Dimensioned::value);
        let pressure = pressure(given, key, duration, source)?;
        let seal = match face {
            Face::Lower => tool(Role::Holder).map(|holder| ("the holder's inner edge", extent(holder).0)),
            Face::Upper => tool(Role::Die).map(|die| ("the end of the die's shoulder", shoulder_end(die))),
        };
        let within = given.within.map(Dimensioned::value).or_else(|| {
            let (what, r) = seal?;
            source.note(format!("gas acts up to {what}, {}", Amount::size(r)));
            Some(r)
        });
        gas.push(Gas { face, pressure, within: within.unwrap_or(sheet.length) });
    }
    let held = gas.iter().filter(|gas| matches!(gas.pressure, Pressure::Rate(_))).count();
    let (what, help) = (
        "both faces hold a strain rate, and there is one sheet",
        "give one of the faces a pressure: the other follows",
    );
    source.require(held < 2, "gas.upper.strain_rate", what, help)?;
    let help = "add lower = { pressure = \"5 MPa\" } or upper";
    source.require(!gas.is_empty(), "gas", "[gas] has no pressure", help)?;
    Ok(gas)
}

/// Pressure over time or for a strain rate; without a punch one pressure is raised over the `duration` \[s\].
fn pressure(face: &file::GasFace, key: &str, duration: Option<f64>, source: &Source) -> Result<Pressure, CaseError> {
    let path = |name: &str| format!("gas.{key}.{name}");
    let for_rate = keys_present([
        ("max_pressure", face.max_pressure.is_some()),
        ("max_pressure_rate", face.max_pressure_rate.is_some()),
        ("norm", face.norm.is_some()),
    ]);
    if let Some(alone) = for_rate.first().filter(|_| face.strain_rate.is_none()) {
        let what = format!("`{alone}` belongs to a pressure that holds a strain rate, and there is no `strain_rate`");
        return Err(source.error(&path(alone), what, "drop it, or give a strain_rate instead of the pressure"));
    }
    match (&face.pressure, face.strain_rate) {
        (Some(given), None) => {
            let mut points: Vec<(f64, f64)> = given.points().into_iter().map(|(t, p)| (t, p.value())).collect();
            if let (Given::Constant(pressure), Some(duration)) = (given, duration) {
                points = vec![(0.0, 0.0), (duration, pressure.value())];
                let (pressure, time) = (Amount::given_stress(pressure.value()), Amount::time(duration));
                source.note(format!(
                    "the pressure of {pressure} on the {key} face is raised evenly over the run's {time}"
                ));
            }
            Ok(Pressure::OverTime(history(points, &path("pressure"), "times", source)?))
        }
        (None, Some(target)) => {
            let exponent = face.norm.map_or(NORM, Dimensioned::value);
            let what = format!("`norm` must lie between 1 and 50, found {exponent}");
            let help = "10 follows the fastest place closely";
            source.require((1.0..=50.0).contains(&exponent), &path("norm"), what, help)?;
            let mut control = RateControl::new(target.value(), exponent);
            control.max_pressure = face.max_pressure.map_or(f64::INFINITY, Dimensioned::value);
            control.max_rise = face.max_pressure_rate.map_or(f64::INFINITY, Dimensioned::value);
            Ok(Pressure::Rate(control))
        }
        (Some(_), Some(_)) => {
            let what = "both a pressure and a strain rate are given";
            Err(source.error(&path("strain_rate"), what, "keep one: the other follows"))
        }
        (None, None) => Err(source.missing(&format!("gas.{key}"), "pressure")),
    }
}
