//! Whether the work of the tools is found again in the sheet.

use super::finding::ACCURACY;
use super::run::{Run, formed};
use super::{Finding, Light};
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Share of the external work that may be missing \[–\].
const LARGEST: f64 = 0.01;

/// What a stage misses at most, over the largest external work of any: of a stage that does little work, shares of its own
/// say nothing.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    run.steps().next()?;
    let largest = run.stages.iter().map(StageSolution::largest_work).fold(0.0, f64::max);
    let missing = run.stages.iter().filter_map(|stage| stage.steps.last()).map(|step| step.work.missing().abs());
    let missing = if largest > 0.0 { missing.fold(0.0, f64::max) / largest } else { 0.0 };
    let found = format!("{share} of the tools' work is missing in the balance", share = Amount::share(missing));
    Some(
        Finding::judged("power_balance", "Work balance", Light::within(missing, LARGEST), found)
            .share(missing, LARGEST)
            .source(ACCURACY)
            .advice("smaller steps (solver.max_step)"),
    )
}

/// A stage that misses more.
pub(super) fn missed(stage: &StageSolution) -> Option<Finding> {
    let missing = stage.steps.last()?.work.imbalance();
    (formed(stage) && missing.abs() > LARGEST).then(|| {
        let found =
            format!("{share} of the tools' work is missing in the balance", share = Amount::share(missing.abs()));
        Finding::warning("power_missing", "Work balance", found)
            .share(missing.abs(), LARGEST)
            .source(ACCURACY)
            .advice("take smaller steps (solver.max_step)")
    })
}
