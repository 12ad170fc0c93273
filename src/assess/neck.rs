//! Whether one place of the sheet takes all the stretching.

use super::{Finding, Light, run::Run, thinning};
use crate::solver::solution::neck::{Neck, neck};
use crate::solver::solution::{StageSolution, Stop};
use crate::table::Unit;
use crate::units::Amount;

/// Thickness over the initial one that no sheet metal, superplastic alloys apart, is drawn to in one piece \[–\].
const TORN: f64 = 0.5;
const LIMIT: &str = "no place thins alone";
const SOURCE: &str = "the solver's watch for necks; declared thresholds";

/// Red where the solver saw a neck or grown-together voids, or where the sheet is too thin to be whole.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let thinnest = last.steps.last()?.thinnest_s0;
    let seen = match &last.stop {
        stop @ (Stop::Localised { .. } | Stop::Coalesced { .. }) => {
            Some(format!("the run ended by it: {kind}", kind = stop.kind()))
        }
        _ => seen(last).map(|finding| finding.found()),
    };
    let light = if seen.is_some() { Light::Red } else { Light::Green };
    Some(
        Finding::judged("localisation", "Neck", light, seen.unwrap_or_else(|| "none".into()))
            .limit(LIMIT)
            .source(SOURCE)
            .advice(thinning::advice(run, last, thinnest)),
    )
}

/// A neck, or a sheet that is too thin to be whole; a run that ended by it has said so.
pub(super) fn seen(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    if matches!(stage.stop, Stop::Localised { .. } | Stop::Coalesced { .. }) {
        return None;
    }
    let neck = torn(stage)?;
    let (s0, left) = (Amount::place(neck.s0), Amount::share(neck.share));
    let found = if neck.stands_out {
        format!(
            "all thinning has gathered at s0 = {s0}, down to {left} of the thickness: the sheet tears there, and what is \
             computed after that depends on the mesh"
        )
    } else {
        format!("the sheet is down to {left} of its thickness at s0 = {s0}: it has torn before")
    };
    Some(Finding::warning("neck", "Neck", found).against(left.value, Unit::Percent, LIMIT).source(SOURCE))
}

/// The thinnest place of a stage that has taken a step, where it is a neck or too thin to be whole.
pub(super) fn torn(stage: &StageSolution) -> Option<Neck> {
    let neck = neck(&stage.model, &stage.end, None);
    let superplastic = stage.model.material.rate.is_some_and(|rate| rate.is_superplastic());
    (neck.stands_out || neck.share < TORN && !superplastic).then_some(neck)
}
