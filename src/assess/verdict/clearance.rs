//! Whether the sheet fits between punch and die.

use super::nose::NoseEnd;
use super::{DECLARED, Finding, Light, largest, steps};
use crate::case::Case;
use crate::rules::estimate;
use crate::solution::StageSolution;
use crate::solver::warnings::IRONED;
use crate::table::Unit;

/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Gap over the thickness above which a wall is not straight: a rim of β = 2.2 is √β thicknesses thick \[–\].
const WIDE: f64 = 1.5;
/// Squeeze at which the sheet is ironed in earnest, which no shell describes \[–\].
const SQUEEZED: f64 = 0.1;

/// Gap between punch and die over the thickness; wide ones matter beside a straight wall only.
pub(super) fn gap(case: &Case, passes: &[StageSolution]) -> Option<Finding> {
    let gap = estimate::clearance(case.model())? / case.model().blank.thickness;
    let straight = passes.first().and_then(NoseEnd::of).is_some_and(NoseEnd::is_upright);
    let light = if gap < LEAST || straight && gap > WIDE { Light::Amber } else { Light::Green };
    let most = if straight { format!(", {WIDE} at most beside a straight wall") } else { String::new() };
    Some(Finding {
        key: "clearance",
        label: "Clearance",
        light,
        value: Some(gap),
        unit: Unit::None,
        found: format!("{gap:.2} thicknesses between punch and die"),
        limit: format!("one thickness at least{most}"),
        source: "a sheet that does not thin is squeezed in less; the upper one is a declared rule of thumb",
        advice: light.advice(if gap < LEAST {
            "a larger throat, a smaller punch or a shorter travel"
        } else {
            "a smaller throat: the wall leans, and puckers"
        }),
    })
}

/// By how much the sheet was too thick for its gap.
pub(super) fn ironing(passes: &[StageSolution]) -> Option<Finding> {
    let squeeze = largest(passes, |step| step.ironing);
    let light = Light::of(squeeze, [IRONED, SQUEEZED]);
    let first = steps(passes).find(|step| step.ironing > IRONED);
    let from = first.map_or(String::new(), |step| format!(", from {:.2} mm of travel", step.travel));
    passes.first()?.steps.last()?;
    Some(Finding {
        key: "ironing",
        label: "Ironing",
        light,
        value: Some(100.0 * squeeze),
        unit: Unit::Percent,
        found: format!("thicker than its gap by up to {:.1} %{from}", 100.0 * squeeze),
        limit: format!("{:.0} %, refused above {:.0} %: a shell is not ironed", 100.0 * IRONED, 100.0 * SQUEEZED),
        source: DECLARED,
        advice: light
            .advice("a clearance of t √β, the thickness of the rim (4ming), or forces there as an indication only"),
    })
}
