//! Whether one place of the sheet takes all the stretching.

use super::{Finding, Light};
use crate::solution::StageSolution;
use crate::solution::Stop;
use crate::solver::warnings::thinned;
use crate::table::Unit;

/// Red where the solver saw a neck or grown-together voids, or found the sheet too thin to be whole.
pub(super) fn judge(passes: &[StageSolution]) -> Option<Finding> {
    let run = passes.last()?;
    let (model, state) = (&run.model, &run.end);
    run.steps.last()?;
    let seen = match &run.stop {
        stop @ (Stop::Localised { .. } | Stop::Coalesced { .. }) => {
            Some(format!("the run ended by it: {}", stop.kind()))
        }
        _ => thinned(model, state, run),
    };
    let light = if seen.is_some() { Light::Red } else { Light::Green };
    Some(Finding {
        key: "localisation",
        label: "Neck",
        light,
        value: None,
        unit: Unit::None,
        found: seen.unwrap_or_else(|| "none".into()),
        limit: "no place thins alone".into(),
        source: "the solver's watch for necks; declared thresholds",
        advice: light.advice(super::thinning::ADVICE),
    })
}
