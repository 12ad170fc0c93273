//! Whether a later draw narrows the cup by no more than a draw can.

use super::{Finding, Light, run::Run};
use crate::assess::design::REDRAW_RATIO;
use crate::model::tool_sizes::extent;
use crate::model::{Geometry, Role};
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::Amount;

/// The largest ratio of a stage's punch to the next one's.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let radius = |stage: &StageSolution| Some(extent(stage.model.tool(Role::Punch)?).1);
    let ratios = run.stages.windows(2).enumerate().filter_map(|(i, pair)| {
        let ratio = radius(&pair[0])? / radius(&pair[1])?;
        (pair[0].model.geometry == Geometry::Axisymmetric && ratio > 1.0).then_some((i + 1, ratio))
    });
    let (i, ratio) = ratios.max_by(|a, b| a.1.total_cmp(&b.1))?;
    // The template's own radii are rounded.
    let light = Light::within(ratio, REDRAW_RATIO + 1e-3);
    let found = format!("{ratio} from punch to punch", ratio = Amount::ratio(ratio));
    let limit = format!("{ratio}, of DC04 in a second draw without annealing", ratio = Amount::number(REDRAW_RATIO));
    Some(
        Finding::judged("redraw_ratio", "Redraw ratio", light, run.of_stage(found, i))
            .against(ratio, Unit::None, limit)
            .at_most(REDRAW_RATIO, None)
            .source("4ming, Forming handbook, table of draw ratios")
            .advice("a wider punch in the later draw, one more draw, or `anneal = true` before it"),
    )
}
