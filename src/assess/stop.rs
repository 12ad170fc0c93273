//! Whether the run came to its end.

use super::{Finding, Light, run::Run, thinning};
use crate::model::Role;
use crate::solver::solution::Stop;
use crate::units::joined;

/// Red where a stage stopped early, amber where the cup left the die; the stop says why.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let (model, stop) = (&last.model, &last.stop);
    let words = match stop {
        Stop::FullTravel if model.release.is_some() => "the tools are taken away".into(),
        Stop::FullTravel if model.stop.drawn_through => {
            format!("{stop}, and the cup is not through the die", stop = stop.to_string())
        }
        stop => stop.to_string(),
    };
    let light = match stop {
        Stop::FullTravel if model.stop.drawn_through && model.release.is_none() => Light::Amber,
        stop if stop.is_complete() => Light::Green,
        // Many a cup leaves its die at the other end.
        Stop::DrawnThrough { .. } => Light::Amber,
        // The user knows.
        Stop::Interrupted { .. } => Light::Amber,
        _ => Light::Red,
    };
    let stages = 1 + run.case.later().len();
    let at = match stages {
        1 => String::new(),
        all => format!("stage {n} of {all}", n = run.stages.len()),
    };
    let advice: String = match stop {
        Stop::FullTravel if model.stop.drawn_through => "more travel".into(),
        Stop::FullTravel | Stop::ContactShare { .. } | Stop::HolderClosed { .. } => "".into(),
        Stop::Interrupted { .. } => "let it run to its end".into(),
        Stop::Refused(_) => "a value that the solver can take".into(),
        Stop::Localised { .. } | Stop::Coalesced { .. } | Stop::LoadMaximum { .. } => {
            thinning::advice(run, last, last.steps.last().map_or(0.0, |step| step.thinnest_s0))
        }
        Stop::PressureMaximum { .. } => {
            "a lower pressure, or a slower one with a rate-sensitive metal; a smaller height".into()
        }
        Stop::Mechanism { .. } => {
            "blank.theory = \"bending\"; or a holder with friction, a bead or a clamped edge that pulls the strip tight".into()
        }
        Stop::Arched { .. } => {
            "a holder that keeps the legs from swinging, a larger gap between punch and die, or a shorter travel".into()
        }
        Stop::DrawnThrough { .. } => {
            "[stop] drawn_through = true where it is wished; else a shorter travel or a larger blank, or more holder force, \
             which keeps the edge back".into()
        }
        Stop::ToolsClosed { .. } => "a shorter travel, or a larger gap between punch and die".into(),
        Stop::Creeping { .. } => {
            "coarser elements there, a larger solver.min_step; or look at the shape: the sheet may snap".into()
        }
        Stop::NoEquilibrium { .. } => "what the stop names; else a finer mesh at the radii (blank.elements)".into(),
    };
    let closes = last.closing.is_some() && model.tool(Role::Punch).is_none();
    let closing = if closes { "while the holder closes".into() } else { String::new() };
    let found = joined([at, closing, words], ": ");
    Some(Finding::judged("stop", "Run", light, found).limit("reaches its end").source("the solver").advice(advice))
}
