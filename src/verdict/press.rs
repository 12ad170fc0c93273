//! What the press must give, against its rating where the case names it.

use super::{Finding, Light};
use crate::case::Case;
use crate::output::{JOULES, energy_unit, force_unit};
use crate::solver::Pass;
use crate::table::{Unit, four_digits};

/// Largest punch force and its travel, over all stages.
pub(super) fn force(case: &Case, passes: &[Pass]) -> Option<Finding> {
    let steps = passes.iter().enumerate().filter(|(_, pass)| pass.model.release.is_none());
    let steps = steps.flat_map(|(i, pass)| pass.run.history.iter().map(move |step| (i, pass, step)));
    let (i, pass, peak) = steps.max_by(|a, b| a.2.punch_force.total_cmp(&b.2.punch_force))?;
    if peak.punch_force <= 0.0 {
        return None;
    }
    let unit = force_unit(pass.model.geometry);
    let stage = if passes.len() > 1 { format!(", stage {}", i + 1) } else { String::new() };
    Some(rated(
        "punch_force",
        "Punch force",
        (peak.punch_force, unit),
        case.press.force,
        |force| match unit {
            Unit::N => format!("{} kN", four_digits(1e-3 * force)),
            other => format!("{} {}", four_digits(force), other.symbol()),
        },
        format!(" at {:.2} mm of travel{stage}", peak.travel),
    ))
}

/// External work of all stages.
pub(super) fn energy(case: &Case, passes: &[Pass]) -> Option<Finding> {
    let unit = energy_unit(passes.first()?.model.geometry);
    let forming = passes.iter().filter(|pass| pass.model.release.is_none());
    let work: f64 = forming.filter_map(|pass| pass.run.history.last()).map(|last| JOULES * last.work.external).sum();
    let per = if unit == Unit::Joule { "J" } else { "J per mm of depth, of the half that is modelled" };
    let written = |work: f64| format!("{} {per}", four_digits(work));
    Some(rated(
        "energy",
        "Energy",
        (work, unit),
        case.press.energy.map(|energy| JOULES * energy),
        written,
        String::new(),
    ))
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
        None => "give [press] force and energy, the ratings on its data sheet",
    };
    Finding {
        key,
        label,
        light,
        value: Some(value),
        unit,
        found: written(value) + &at,
        limit: rating.map_or_else(|| "the press's rating, not in the case".into(), written),
        source: "the press's data sheet",
        advice: light.advice(advice),
    }
}
