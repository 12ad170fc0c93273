//! What the press must give, against its rating where the case names it.

use super::{Finding, Light, run::Run};
use crate::table::{JOULES, Unit};
use crate::units::four_digits;

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
            Unit::N => format!("{} kN", four_digits(1e-3 * force)),
            other => format!("{} {} of depth", four_digits(force), other.symbol()),
        },
        format!(" at {:.2} mm of travel{}", peak.travel, run.of_stage(i)),
    ))
}

/// External work of the stroke that needs most of it.
pub(super) fn energy(run: &Run) -> Option<Finding> {
    let unit = run.stages.first()?.model.extent().energy_unit();
    let strokes = run.stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
    let work = strokes.filter_map(|(i, stage)| Some((i, JOULES * stage.steps.last()?.work.external)));
    let (i, work) = work.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let per = if unit == Unit::Joule { "J" } else { "J per mm of depth" };
    let written = |work: f64| format!("{} {per}", four_digits(work));
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    Some(rated("energy", "Energy", (work, unit), rating, written, run.of_stage(i)))
}

/// A figure of the run against the press's rating, `written` with a unit.
fn rated(
    key: &'static str,
    label: &'static str,
    (value, unit): (f64, Unit),
    rating: Option<f64>,
    written: impl Fn(f64) -> String,
    at: String,
) -> Finding {
    let light = rating.map_or(Light::Grey, |rating| Light::of(value, [rating, rating]));
    let advice = match rating {
        Some(_) => "a stronger press; less friction or holder force, a smaller blank, a thinner sheet",
        None if matches!(unit, Unit::NPerMm | Unit::JoulePerMm) => {
            "give blank.depth, and [press] force and energy: the ratings on its data sheet"
        }
        None => "give [press] force and energy: the ratings on its data sheet",
    };
    Finding::judged(key, label, light, written(value) + &at)
        .against(value, unit, rating.map_or_else(|| "the press's rating, not in the case".into(), written))
        .source("the press's data sheet")
        .advice(advice)
}
