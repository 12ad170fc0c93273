//! Whether the run came to its end.

use super::{Finding, Light};
use crate::case::Case;
use crate::record::Stop;
use crate::solver::Pass;
use crate::table::Unit;

/// Red where a stage stopped early; the stop says why.
pub(super) fn judge(case: &Case, passes: &[Pass]) -> Option<Finding> {
    let stop = &passes.last()?.run.stop;
    let light = if stop.is_complete() { Light::Green } else { Light::Red };
    let stages = 1 + case.later.len();
    let at = if stages > 1 { format!("stage {} of {stages}: ", passes.len()) } else { String::new() };
    let advice = match stop {
        Stop::FullTravel | Stop::ContactShare { .. } => "",
        Stop::Localised { .. } | Stop::Coalesced { .. } | Stop::LoadMaximum { .. } => super::thinning::ADVICE,
        Stop::PressureMaximum { .. } => {
            "a lower pressure, or a slower one with a rate-sensitive metal; a smaller height"
        }
        Stop::DrawnThrough { .. } => "a shorter travel or a larger blank; more holder force keeps the edge back",
        Stop::ToolsClosed { .. } => "a shorter travel, or a larger gap between punch and die",
        Stop::NoEquilibrium { .. } => "what the stop names; else a finer mesh at the radii (blank.elements)",
    };
    Some(Finding {
        key: "stop",
        label: "Run",
        light,
        value: None,
        unit: Unit::None,
        found: format!("{at}{stop}"),
        limit: "reaches its end".into(),
        source: "the solver",
        advice: advice.into(),
    })
}
