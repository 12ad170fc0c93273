//! Measures before and after a release of the tools.

use super::StageView;
use super::csv::{number, records};
use crate::measure::{self, Change, Shape};
use crate::solver::solution::StageSolution;
use crate::table::Unit;

/// Changes of a stage that takes its tools away.
pub fn changes(stage: &StageSolution) -> Option<Vec<Change>> {
    let [before, after] = stage.released()?;
    Some(measure::changes(&Shape::of(before), &Shape::of(after)))
}

/// One row per quantity; the opening of a slit ring \[mm\] stands after the release.
pub(super) fn csv(view: &StageView) -> Option<String> {
    let cells = |key: &str, unit: Unit, values: [Option<f64>; 3]| {
        let [before, after, change] = values.map(|value| value.map_or_else(String::new, number));
        [key.to_owned(), unit.spelled().to_owned(), before, after, change]
    };
    let mut rows = vec![["quantity", "unit", "before", "after", "change"].map(str::to_owned)];
    let changes = changes(view.stage)?;
    rows.extend(changes.iter().map(|c| cells(c.quantity.key, c.quantity.unit, [c.before, c.after, c.change()])));
    rows.extend(view.ring_opening().map(|opening| cells("ring_opening", Unit::Mm, [None, Some(opening), None])));
    String::from_utf8(records(rows)).ok()
}
