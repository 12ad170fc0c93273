//! Section before and after the release of the tools.

use super::*;
use crate::measure::{self, FLANGE_ANGLE, Leg, Shape, WALL_ANGLE};

const LONGER: f64 = 0.25;
const WALL: Style = Style::Line { color: BLACK, width: 1.4, dash: &[7.0, 3.5] };
const FLANGE: Style = Style::Line { color: BLACK, width: 1.4, dash: &[2.0, 3.0] };

/// Both sections, the tools before release, and the lines that give wall and flange angle.
pub fn plot(view: &StageView) -> Option<Chart> {
    let [before, after] = view.stage.released()?;
    let model = view.model();
    let shapes = [Shape::of(before), Shape::of(after)];
    let changes = measure::changes(&shapes[0], &shapes[1]);
    let text = |change: &measure::Change| format!("{}: {change}", change.quantity.label);
    let window = sections::window(before.nodes.iter().chain(&after.nodes), model.blank.thickness);
    let mut outline = sections::whole_sheet(after, 1.0);
    outline.extend(outline.first().copied());
    let filled = Style::Area { fill: pale(color(0)), edge: Some(color(0)) };
    let sheet = Series::new("Before", sections::whole_sheet(before, 1.0), filled);
    let sheets = [sheet, Series::new("After", outline, Style::solid(color(1), 2.0))];
    let legs: [fn(&Shape) -> Option<&Leg>; 2] = [|shape| shape.wall.as_ref(), |shape| shape.flange.as_ref()];
    let mut lines = Vec::new();
    for ((angle, style), leg) in [(WALL_ANGLE, WALL), (FLANGE_ANGLE, FLANGE)].into_iter().zip(legs) {
        let mut label = changes.iter().find(|change| change.quantity.key == angle.key).map(text);
        for leg in shapes.iter().rev().filter_map(leg) {
            let [[r0, z0], [r1, z1]] = leg.line;
            let points = [-LONGER, 1.0 + LONGER].map(|f| (r0 + f * (r1 - r0), z0 + f * (z1 - z0))).to_vec();
            lines.push(Series { label: label.take(), points, style });
        }
    }
    let is_in_legend = |key| key == WALL_ANGLE.key || key == FLANGE_ANGLE.key;
    let others = changes.iter().filter(|change| !is_in_legend(change.quantity.key)).map(|change| text(change) + ".");
    let note = "The sheet is true to thickness. Grey: the tools before release.".to_owned();
    let tools = sections::tools(model, Some(before), window[0].1);
    let panel = sections::panel(model.geometry, window).with(tools).with(sheets).with(lines);
    Some(view.chart("spring-back", vec![panel], std::iter::once(note).chain(others)))
}
