//! `[gas]`: pressure on the faces of the sheet.

use super::values::History;
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{extent, shoulder_end};
use crate::model::{self, Face, Pressure, RateControl, Role, Tool};
use crate::numerics::PiecewiseLinear;
use crate::units::{Amount, Dimensioned, Length, NonNegative, Number, Positive, StrainRate, Stress, StressRate, Time};
use schemars::JsonSchema;
use serde::Deserialize;

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
    pub fn model(&self, tools: &[Tool], length: f64, source: &Source) -> Result<Vec<model::Gas>, CaseError> {
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
                source.note(format!("gas acts up to {what}, {}", Amount::size(r)));
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
    fn pressure(&self, key: &str, duration: Option<f64>, source: &Source) -> Result<Pressure, CaseError> {
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
