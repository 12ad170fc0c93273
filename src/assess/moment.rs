//! Whether the layers resolve the moments that spring the sheet back.

use super::finding::ACCURACY;
use super::{Finding, Light, run::Run};
use crate::measure::moment_error;
use crate::model::Mode;
use crate::units::Amount;

/// Error of a section's moment that a spring-back may carry \[–\].
const LARGEST: f64 = 0.05;

/// The largest error of a stage that bends an elastic sheet.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    run.steps().next()?;
    let bent = run.stages.iter().filter(|stage| stage.model.mode != Mode::Flow && stage.model.release.is_none());
    let errors = bent.filter_map(|stage| moment_error(stage.frames.last()?)).map(|error| error.share);
    let missed = errors.reduce(f64::max)?;
    let found = format!("{share} of the largest bending moment missed, estimated", share = Amount::share(missed));
    Some(
        Finding::judged("moment_error", "Bending moment", Light::within(missed, LARGEST), found)
            .share(missed, LARGEST)
            .source(ACCURACY)
            .advice("more layers (blank.layers)"),
    )
}
