//! Whether the work of the tools is found again in the sheet.

use super::{Finding, Light, Run, formed};
use crate::solution::StageSolution;
use crate::table::Unit;

/// Share of the external work that may be missing \[–\].
const LARGEST: f64 = 0.01;
const SOURCE: &str = "declared accuracy of the solver";

/// The largest share of the external work that a stage misses.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    run.steps().next()?;
    let missing = run.stages.iter().filter(|stage| formed(stage)).filter_map(|stage| stage.steps.last());
    let missing = missing.map(|step| step.work.imbalance().abs()).fold(0.0, f64::max);
    let found = format!("{:.2} % of the external work missing", 100.0 * missing);
    Some(
        Finding::judged("power_balance", "Power balance", Light::within(missing, LARGEST), found)
            .value(100.0 * missing, Unit::Percent)
            .limit(format!("{:.0} %", 100.0 * LARGEST))
            .source(SOURCE)
            .advice("smaller steps (solver.max_step)"),
    )
}

/// A stage that misses more.
pub(super) fn missed(stage: &StageSolution) -> Option<Finding> {
    let missing = stage.steps.last()?.work.imbalance();
    (formed(stage) && missing.abs() > LARGEST).then(|| {
        let found = format!("the power balance misses {:.2} % of the external work", 100.0 * missing);
        Finding::warning("power_missing", "Power balance", found)
            .value(100.0 * missing, Unit::Percent)
            .limit(format!("{:.0} %", 100.0 * LARGEST))
            .source(SOURCE)
            .advice("take smaller steps (solver.max_step)")
    })
}
