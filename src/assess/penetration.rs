//! Whether the tools stay out of the sheet.

use super::finding::ACCURACY;
use super::run::{Run, largest};
use super::{Finding, Light};
use crate::model::{ContactMethod, Settings};
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Penetration that would show in the result, over the thickness \[–\].
const LARGEST: f64 = 0.05;

/// The deepest of all stages.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let deepest = run.largest(|step| step.penetration)?;
    let found =
        format!("tools sink into the sheet by {share} of its thickness at most", share = Amount::share(deepest));
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
        let found = format!("a tool sinks into the sheet by {share} of its thickness", share = Amount::share(deepest));
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
        let found = format!(
            "contact by the augmented Lagrangian let a tool sink into the sheet by {share} of its thickness",
            share = Amount::share(deepest)
        );
        Finding::warning("penetration_left", "Penetration", found)
            .share(deepest, Settings::PENETRATION)
            .source(ACCURACY)
    })
}
