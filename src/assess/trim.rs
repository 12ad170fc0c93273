//! Where the sheet was cut before a stage.

use super::Finding;
use crate::solution::StageSolution;
use crate::table::Unit;

/// A cut, which falls between elements.
pub(super) fn cut(stage: &StageSolution) -> Option<Finding> {
    let cut = stage.trimmed?;
    let found = format!(
        "the sheet is cut to r = {:.3} mm ({} mm asked for): whole elements go, {} of them",
        cut.edge, cut.asked, cut.elements
    );
    Some(
        Finding::warning("trim", "Trim", found)
            .value(cut.edge, Unit::Mm)
            .limit(format!("{} mm", cut.asked))
            .source("the case's trim"),
    )
}
