//! The sheet before and after the tools are taken away: both shapes in one picture, and what was measured on them.

use super::StageView;
use crate::measure::{self, Change, Shape};
use crate::solver::solution::StageSolution;

/// What was measured before and after, of a stage that takes its tools away.
pub fn changes(stage: &StageSolution) -> Option<Vec<Change>> {
    let [before, after] = stage.released()?;
    Some(measure::changes(&Shape::of(before), &Shape::of(after)))
}

pub(super) fn csv(view: &StageView) -> Option<String> {
    changes(view.stage).map(|changes| super::csv::springback(&changes, view.ring_opening()))
}
