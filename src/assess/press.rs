//! What the press must give, against its rating where the case names it.

use super::run::{Run, at_event};
use super::{Finding, Light};
use crate::message::{Amount, Message, message};
use crate::table::{JOULES, Unit};

/// Largest punch force and its travel, over all stages.
pub(super) fn force(run: &Run) -> Option<Finding> {
    let steps = run.stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
    let steps = steps.flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, stage, step)));
    let (i, stage, peak) = steps.max_by(|a, b| a.2.punch_force.total_cmp(&b.2.punch_force))?;
    if peak.punch_force <= 0.0 {
        return None;
    }
    let unit = stage.model.extent().force_unit();
    Some(rated(
        "punch_force",
        "Punch force",
        (peak.punch_force, unit),
        run.case.press.force,
        |force| match unit {
            Unit::N => Amount::force(force, unit).into(),
            _ => message!("{force} of depth", force = Amount::force(force, unit)),
        },
        |force| {
            let found = message!("{force} at {travel} of travel", force = force, travel = Amount::place(peak.travel));
            run.of_stage(Message::joined([found, at_event(stage, peak)], " "), i)
        },
    ))
}

/// External work of the stroke that needs most of it.
pub(super) fn energy(run: &Run) -> Option<Finding> {
    let unit = run.stages.first()?.model.extent().energy_unit();
    let strokes = run.stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
    let work = strokes.filter_map(|(i, stage)| Some((i, JOULES * stage.steps.last()?.work.external)));
    let (i, work) = work.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let told = |work: f64| match unit {
        Unit::Joule => Amount::energy(work, unit).into(),
        _ => message!("{work} of depth", work = Amount::energy(work, unit)),
    };
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    Some(rated("energy", "Energy", (work, unit), rating, told, |work| run.of_stage(work, i)))
}

/// A figure of the run, as it is `told` and where it was `found`, against the press's rating.
fn rated(
    key: &'static str,
    label: &'static str,
    (value, unit): (f64, Unit),
    rating: Option<f64>,
    told: impl Fn(f64) -> Message,
    found: impl Fn(Message) -> Message,
) -> Finding {
    let light = rating.map_or(Light::Grey, |rating| Light::of(value, [rating, rating]));
    let advice = match rating {
        Some(_) => "a stronger press; less friction or holder force, a smaller blank, a thinner sheet",
        None if matches!(unit, Unit::NPerMm | Unit::JoulePerMm) => {
            "give blank.depth, and [press] force and energy: the ratings on its data sheet"
        }
        None => "give [press] force and energy: the ratings on its data sheet",
    };
    let judged = Finding::judged(key, label, light, found(told(value)));
    let judged = match rating {
        Some(rating) => judged.against(value, unit, told(rating)).at_most(None, rating),
        None => judged.against(value, unit, "the press's rating, not in the case"),
    };
    judged.source("the press's data sheet").advice(advice)
}
