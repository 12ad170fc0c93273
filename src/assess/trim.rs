//! Where the sheet was cut before a stage.

use super::Finding;
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::Amount;

/// A cut, which falls between elements.
pub(super) fn cut(stage: &StageSolution) -> Option<Finding> {
    let cut = stage.trimmed?;
    let found = format!(
        "the sheet is cut to r = {edge} ({asked} asked for): whole elements go, {n} of them",
        edge = Amount::size(cut.edge),
        asked = Amount::size(cut.asked),
        n = cut.elements
    );
    Some(
        Finding::warning("trim", "Trim", found)
            .against(cut.edge, Unit::Mm, Amount::size(cut.asked))
            .source("the case's trim"),
    )
}
