//! How far the hardening law is used beyond what it was measured for.

use super::{Finding, Light};
use crate::solution::StageSolution;
use crate::table::Unit;

/// The largest equivalent strain of a layer, against the last point of a table; a formula does not say its range.
pub(super) fn judge(passes: &[StageSolution]) -> Option<Finding> {
    let last = passes.last()?;
    let strain = passes.iter().flat_map(|pass| pass.end.points.iter()).map(|point| point.strain).fold(0.0, f64::max);
    let range = last.model.material.hardening.valid_up_to();
    let light = range.map_or(Light::Grey, |end| Light::within(strain, end));
    let advice = match range {
        Some(_) => "points at larger strains, from a bulge test; else the stress is extrapolated",
        None => "hold that strain against the range of the fit in the law's source",
    };
    Some(Finding {
        key: "hardening_range",
        label: "Hardening law",
        light,
        value: Some(strain),
        unit: Unit::None,
        found: format!("used up to a true strain of {strain:.3}"),
        limit: match range {
            Some(end) => format!("its table ends at {end:.3}"),
            None => "a formula: the range of its fit is not in the case".into(),
        },
        source: "the case's material",
        advice: light.advice(advice),
    })
}
