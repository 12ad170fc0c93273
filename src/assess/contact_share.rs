//! Whether as much of the sheet lies on its tools as was asked for.

use super::Finding;
use crate::solution::{StageSolution, Stop};
use crate::table::Unit;

/// A stage that ended before.
pub(super) fn missed(stage: &StageSolution) -> Option<Finding> {
    let share = 100.0 * stage.steps.last()?.contact_share;
    let asked = stage.model.stop.contact_share.filter(|_| !matches!(stage.stop, Stop::ContactShare { .. }))?;
    let found = format!(
        "{share:.1} % of the sheet lies on its tools at the end, not the {:.1} % that were to end the run",
        100.0 * asked
    );
    Some(
        Finding::warning("contact_share", "Contact", found)
            .value(share, Unit::Percent)
            .limit(format!("{:.1} %", 100.0 * asked))
            .source("the case's stop.contact_share")
            .advice("more time, travel or pressure gets further"),
    )
}
