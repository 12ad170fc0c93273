//! Whether as much of the sheet lies on its tools as was asked for.

use super::Finding;
use crate::solver::solution::{StageSolution, Stop};
use crate::table::Unit;
use crate::units::Amount;

/// A stage that ended before.
pub(super) fn missed(stage: &StageSolution) -> Option<Finding> {
    let share = stage.steps.last()?.contact_share;
    let asked = stage.model.stop.contact_share.filter(|_| !matches!(stage.stop, Stop::ContactShare { .. }))?;
    let found = format!(
        "{share} of the sheet lies on its tools at the end, not the {asked} that were to end the run",
        share = Amount::share(share),
        asked = Amount::given_share(asked)
    );
    Some(
        Finding::warning("contact_share", "Contact", found)
            .against(100.0 * share, Unit::Percent, Amount::given_share(asked))
            .at_least(100.0 * asked, None)
            .source("the case's stop.contact_share")
            .advice("more time, travel or pressure gets further"),
    )
}
