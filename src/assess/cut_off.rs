//! Whether much of the sheet strains so slowly that its stress is the cut-off's.

use super::finding::ACCURACY;
use super::run::{Run, formed};
use super::{Finding, Light};
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Plastic work in cut-off zones, over all of it, that puts stresses in doubt \[–\].
const LARGEST: f64 = 0.05;

/// The share of the plastic work of a stage that formed the sheet.
fn share(stage: &StageSolution) -> Option<f64> {
    let work = stage.steps.last().filter(|_| formed(stage))?.work;
    (work.plastic > 0.0).then(|| work.cutoff / work.plastic)
}

/// The largest share of a stage.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    run.steps().next()?;
    let share = run.stages.iter().filter_map(share).fold(0.0, f64::max);
    let found =
        format!("{share} of the plastic work is done in zones that hardly deform", share = Amount::share(share));
    Some(
        Finding::judged("cutoff", "Nearly rigid zones", Light::within(share, LARGEST), found)
            .share(share, LARGEST)
            .source(ACCURACY)
            .advice("a smaller solver.cutoff_strain: where the sheet strains more slowly than that its stress is not the true one"),
    )
}

/// A stage with more.
pub(super) fn large(stage: &StageSolution) -> Option<Finding> {
    let share = share(stage).filter(|share| *share > LARGEST)?;
    let found = format!(
        "{share} of the plastic work is done in zones that hardly deform, more slowly than solver.cutoff_strain: stresses there \
         are not the true ones",
        share = Amount::share(share)
    );
    Some(Finding::warning("cut_off", "Nearly rigid zones", found).share(share, LARGEST).source(ACCURACY))
}
