//! Whether the run came to its end.

use super::{Finding, Light, run::Run, thinning};
use crate::model::Role;
use crate::solution::Stop;

/// Red where a stage stopped early, amber where the cup left the die; the stop says why.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let (model, stop) = (&last.model, &last.stop);
    let words = match stop {
        Stop::FullTravel if model.release.is_some() => "the tools are taken away".to_owned(),
        Stop::FullTravel if model.stop.drawn_through => format!("{stop}, and the cup is not through the die"),
        stop => stop.to_string(),
    };
    let light = match stop {
        Stop::FullTravel if model.stop.drawn_through && model.release.is_none() => Light::Amber,
        stop if stop.is_complete() => Light::Green,
        // Many a cup leaves its die at the other end.
        Stop::DrawnThrough { .. } => Light::Amber,
        _ => Light::Red,
    };
    let stages = 1 + run.case.later().len();
    let mut at = if stages > 1 { format!("stage {} of {stages}: ", run.stages.len()) } else { String::new() };
    if last.closing.is_some() && model.tool(Role::Punch).is_none() {
        at += "while the holder closes: ";
    }
    let advice = match stop {
        Stop::FullTravel if model.stop.drawn_through => "more travel",
        Stop::FullTravel | Stop::ContactShare { .. } | Stop::HolderClosed { .. } | Stop::Interrupted { .. } => "",
        Stop::Refused(_) => "a value that the solver can take",
        Stop::Localised { .. } | Stop::Coalesced { .. } | Stop::LoadMaximum { .. } => thinning::ADVICE,
        Stop::PressureMaximum { .. } => {
            "a lower pressure, or a slower one with a rate-sensitive metal; a smaller height"
        }
        Stop::Mechanism { .. } => {
            "blank.theory = \"bending\"; or a holder with friction, a bead or a clamped edge that pulls the strip tight"
        }
        Stop::Arched { .. } => {
            "a holder that keeps the legs from swinging, a larger gap between punch and die, or a shorter travel"
        }
        Stop::DrawnThrough { .. } => {
            "[stop] drawn_through = true where it is wished; else a shorter travel or a larger blank, or more holder force, \
             which keeps the edge back"
        }
        Stop::ToolsClosed { .. } => "a shorter travel, or a larger gap between punch and die",
        Stop::Creeping { .. } => {
            "coarser elements there, a larger solver.min_step; or look at the shape: the sheet may snap"
        }
        Stop::NoEquilibrium { .. } => "what the stop names; else a finer mesh at the radii (blank.elements)",
    };
    Some(
        Finding::judged("stop", "Run", light, at + &words).limit("reaches its end").source("the solver").advice(advice),
    )
}
