//! What the press must give, against its rating where the case names it.

use super::{Finding, Light, run::Run};
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
    let at = message!(" at {travel} of travel", travel = Amount::place(peak.travel));
    let at = Message::joined([at, run.of_stage(i).into()], "");
    Some(rated("punch_force", "Punch force", Amount::force(peak.punch_force, unit), run.case.press.force, at))
}

/// External work of the stroke that needs most of it.
pub(super) fn energy(run: &Run) -> Option<Finding> {
    let unit = run.stages.first()?.model.extent().energy_unit();
    let strokes = run.stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
    let work = strokes.filter_map(|(i, stage)| Some((i, JOULES * stage.steps.last()?.work.external)));
    let (i, work) = work.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    Some(rated("energy", "Energy", Amount::energy(work, unit), rating, run.of_stage(i).into()))
}

/// A figure of the run against the press's rating, in its unit.
fn rated(key: &'static str, label: &'static str, found: Amount, rating: Option<f64>, at: Message) -> Finding {
    let Amount { value, unit, .. } = found;
    let light = rating.map_or(Light::Grey, |rating| Light::of(value, [rating, rating]));
    let advice = match rating {
        Some(_) => "a stronger press; less friction or holder force, a smaller blank, a thinner sheet",
        None if matches!(unit, Unit::NPerMm | Unit::JoulePerMm) => {
            "give blank.depth, and [press] force and energy: the ratings on its data sheet"
        }
        None => "give [press] force and energy: the ratings on its data sheet",
    };
    let told = |amount: Amount| match unit {
        Unit::NPerMm | Unit::JoulePerMm => message!("{amount} of depth", amount = amount),
        _ => amount.into(),
    };
    let limit = match rating {
        Some(rating) => told(Amount::new(rating, unit, found.digits)),
        None => "the press's rating, not in the case".into(),
    };
    Finding::judged(key, label, light, Message::joined([told(found), at], ""))
        .against(value, unit, limit)
        .at_most(rating, rating)
        .source("the press's data sheet")
        .advice(advice)
}
