//! How near the sheet comes to its forming limit.

use super::nearest::Nearest;
use super::{Finding, Light, run::Run, thinning};
use crate::forming_limit::{CROOKED, Judged};
use crate::rules::design::THIN;
use crate::table::Unit;

/// Share of the limit strain above which scatter of metal and process may reach it \[–\].
pub const CAREFUL: f64 = 0.9;

/// Share of the limit that a path which is not straight may use: its own limit may be far lower \[–\].
const BENT: f64 = 0.5;

/// The least margin, where, and when the limit was first reached; not judged where no limit is given.
pub(super) fn margin(run: &Run) -> Option<Finding> {
    let Some(Nearest { name, stage, assessment }) = &run.nearest else { return Some(missing()) };
    let worst = assessment.worst();
    let bend = run.largest(|step| step.sharpest_bend).unwrap_or(0.0);
    let bent = bend * THIN > 1.0;
    let light = match assessment.reached {
        Some(_) => Light::Red,
        None if bent => Light::Amber,
        None => Light::within(worst.ratio(), CAREFUL),
    };
    let faces = match bent {
        true => format!("; of the mid-surface: bends strain the faces by up to {:.2}", (1.0 + 0.5 * bend).ln()),
        false => String::new(),
    };
    let reached = assessment.reached.map_or(String::new(), |reached| {
        let when = if stage.model.travel > 0.0 {
            format!("{:.2} mm of travel", reached.travel)
        } else {
            format!("{:.4} s", reached.time)
        };
        format!("; first reached at {when}, s0 = {:.1} mm", reached.s0)
    });
    let found = format!(
        "uses {:.0} % of the limit at s0 = {:.1} mm, {:.3} of major true strain {}{reached}{faces}",
        100.0 * worst.ratio(),
        worst.s0,
        worst.margin().abs(),
        if worst.margin() < 0.0 { "beyond it" } else { "left" }
    );
    Some(
        Finding::judged("forming_limit", "Forming limit", light, found)
            .against(worst.margin(), Unit::None, format!("{name}: not reached, below {:.0} % of it", 100.0 * CAREFUL))
            .source("the case's curve; the share is a declared rule of thumb")
            .advice(match light == Light::Amber && bent {
                true => "larger radii: a limit of stretched sheet says nothing of the faces of sharp bends",
                false => thinning::ADVICE,
            }),
    )
}

fn missing() -> Finding {
    Finding::judged("forming_limit", "Forming limit", Light::Grey, "no forming limit given")
        .limit("the strains are held against one")
        .advice("write [forming_limit] with hill = true (computed from the law), or the measured points of the coil")
}

/// Whether the curve can be taken at its word: it holds for straight strain paths.
pub(super) fn path(run: &Run) -> Option<Finding> {
    let assessment = &run.nearest.as_ref()?.assessment;
    let crooked = assessment.crooked();
    let used = assessment.elements.iter().filter(|judged| judged.is_crooked()).map(Judged::ratio).fold(0.0, f64::max);
    let found = match crooked {
        0 => "all straight".into(),
        n => format!(
            "{n} of {} elements not straight, they use up to {:.0} % of the limit",
            assessment.elements.len(),
            100.0 * used
        ),
    };
    let limit =
        format!("within {:.0} % of a straight line, or below {:.0} % of the limit", 100.0 * CROOKED, 100.0 * BENT);
    Some(
        Finding::judged("strain_paths", "Strain paths", Light::within(used, BENT), found)
            .against(crooked as f64, Unit::None, limit)
            .source("limit curves are measured on straight paths; the shares are declared rules of thumb")
            .advice("keep more margin there: look at strain_paths.csv of `run`"),
    )
}
