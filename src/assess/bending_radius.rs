//! Whether the sheet is bent over radii that a thin shell follows.

use super::{Finding, Light, run::Run};
use crate::model::{Model, Theory, Tool};
use crate::rules::design::THIN;
use crate::table::Unit;
use crate::units::mm;

/// Bending radius over the thickness at which a fibre's strain is as large as plastic ones in deep draws, and a shell is none
/// \[–\].
const SHARP: f64 = 2.0;

/// A tool's smallest radius over the thickness.
pub(super) fn small(model: &Model, tool: &Tool) -> Option<Finding> {
    let smallest = tool.profile.corners().min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let ratio = smallest.radius / model.blank.thickness;
    let what = match model.blank.theory {
        Theory::Bending | Theory::Selective => "beyond thin-shell theory",
        Theory::Membrane => "bending, which membrane theory leaves out, matters there",
    };
    (smallest.radius < THIN * model.blank.thickness).then(|| {
        let found = format!(
            "the {}'s radius of {} mm is {ratio:.1} thicknesses (below {THIN}): {what}",
            tool.role.name(),
            mm(smallest.radius)
        );
        Finding::warning("tool_radius", "Tool radius", found).against(
            ratio,
            Unit::None,
            format!("{THIN} thicknesses at least"),
        )
    })
}

/// Smallest bending radius of the mid-surface over the thickness.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let sharpest = run.largest(|step| step.sharpest_bend).filter(|sharpest| *sharpest > 0.0)?;
    let ratio = 1.0 / sharpest;
    let light = match ratio {
        r if r < SHARP => Light::Red,
        r if r < THIN => Light::Amber,
        _ => Light::Green,
    };
    let found = format!("{ratio:.2} thicknesses at the sharpest");
    Some(
        Finding::judged("bend_radius", "Bending radius", light, found)
            .against(
                ratio,
                Unit::None,
                format!("{THIN} thicknesses at least, refused below {SHARP}: thin-shell theory"),
            )
            .advice("larger radii; else take strains and spring-back there with care"),
    )
}
