//! Whether the tools stay out of the sheet.

use super::finding::ACCURACY;
use super::run::{Run, largest};
use super::{Finding, Light};
use crate::model::{ContactMethod, Settings};
use crate::solution::StageSolution;
use crate::table::Unit;

/// Penetration that would show in the result, over the thickness \[–\].
const LARGEST: f64 = 0.05;

/// The deepest of all stages.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let deepest = run.largest(|step| step.penetration)?;
    let found = format!("{:.2} % of the thickness", 100.0 * deepest);
    Some(
        Finding::judged("penetration", "Penetration", Light::within(deepest, LARGEST), found)
            .share(deepest, LARGEST)
            .source(ACCURACY)
            .advice("a larger solver.contact_stiffness, or contact by the augmented Lagrangian"),
    )
}

/// A stage whose tools go deeper.
pub(super) fn deep(stage: &StageSolution) -> Option<Finding> {
    let deepest = largest(stage, |step| step.penetration);
    (deepest > LARGEST).then(|| {
        let found = format!("a tool penetrates the sheet by {:.1} % of its thickness", 100.0 * deepest);
        Finding::warning("deep_penetration", "Penetration", found)
            .share(deepest, LARGEST)
            .source(ACCURACY)
            .advice("raise solver.contact_stiffness")
    })
}

/// What the augmented Lagrangian, which should leave none, has left.
pub(super) fn left(stage: &StageSolution) -> Option<Finding> {
    let deepest = largest(stage, |step| step.penetration);
    let augmented = stage.model.settings.contact == ContactMethod::AugmentedLagrangian;
    (augmented && deepest > 1.01 * Settings::PENETRATION).then(|| {
        let found = format!("the augmented Lagrangian left a penetration of {deepest:.1e} thicknesses");
        Finding::warning("penetration_left", "Penetration", found)
            .against(100.0 * deepest, Unit::Percent, format!("{:e} thicknesses", Settings::PENETRATION))
            .source(ACCURACY)
    })
}
