//! What the press must give: figures to hold against its rating, which a case does not know.

use super::{Finding, Light};
use crate::output::{force_unit, work_unit};
use crate::solver::Pass;
use crate::table::{Unit, four_digits};

/// Largest punch force and its travel, over all stages.
pub(super) fn force(passes: &[Pass]) -> Option<Finding> {
    let steps = passes.iter().enumerate().filter(|(_, pass)| pass.model.release.is_none());
    let steps = steps.flat_map(|(i, pass)| pass.run.history.iter().map(move |step| (i, pass, step)));
    let (i, pass, peak) = steps.max_by(|a, b| a.2.punch_force.total_cmp(&b.2.punch_force))?;
    if peak.punch_force <= 0.0 {
        return None;
    }
    let unit = force_unit(pass.model.geometry);
    let (shown, symbol) = match unit {
        Unit::N => (1e-3 * peak.punch_force, "kN"),
        other => (peak.punch_force, other.symbol()),
    };
    let stage = if passes.len() > 1 { format!(", stage {}", i + 1) } else { String::new() };
    Some(rated(
        "punch_force",
        "Punch force",
        (peak.punch_force, unit),
        format!("{} {symbol} at {:.2} mm of travel{stage}", four_digits(shown), peak.travel),
    ))
}

/// External work of all stages.
pub(super) fn energy(passes: &[Pass]) -> Option<Finding> {
    let unit = work_unit(passes.first()?.model.geometry);
    let forming = passes.iter().filter(|pass| pass.model.release.is_none());
    let work: f64 = forming.filter_map(|pass| pass.run.history.last()).map(|last| last.work.external).sum();
    let per = if unit == Unit::Millijoule { "J" } else { "J per mm of depth, of the half that is modelled" };
    Some(rated("energy", "Energy", (work, unit), format!("{} {per}", four_digits(1e-3 * work))))
}

fn rated(key: &'static str, label: &'static str, (value, unit): (f64, Unit), found: String) -> Finding {
    Finding {
        key,
        label,
        light: Light::Green,
        value: Some(value),
        unit,
        found,
        limit: "the press's rating: not in the case".into(),
        source: "the press's data sheet",
        advice: String::new(),
    }
}
