//! The part: its whole section coloured by thinning, its thinnest place and the place of a tear.

use super::sections::{mirrored, panel, tools, whole_window};
use super::*;
use crate::assess::tears_at;
use crate::measure::element_at;

/// Width of the section \[px\].
const WIDTH: f64 = 680.0;

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frame) = (view.model(), view.stage.frames.last()?);
    let window = whole_window(frame);
    let right = window[0].1;
    let scale = Thinning::new(model.blank.thickness, 0.5 * WIDTH / right, [frame]);
    let is_released = model.release.is_some();
    let tools = tools(model, Some(frame), right).filter(|_| !is_released);
    let sides = |tool: Series| mirrored(tool.points).into_iter().map(move |body| Series::silent(body, tool.style));
    let tools = tools.flat_map(sides);
    let thinnest = frame.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    let thinned = 1e-4 * (100.0 * thinning::percent(thinnest)).round();
    let word = if thinned < 0.0 { "thicker" } else { "thinner" };
    let text = format!("{}, {} {word}", Amount::thickness(thinnest.thickness), Amount::share(thinned.abs()));
    let mut section = panel(model.geometry, window).with(tools).with(scale.section(frame, true));
    section.annotations.push(Annotation::flag(text, (thinnest.r, thinnest.z)));
    if let Some(torn) = tears_at(view.stage).and_then(|s0| element_at(frame, s0)) {
        let torn = &frame.elements[torn];
        section.annotations.push(Annotation::flag("tears here", (-torn.r, torn.z)));
    }
    let note = scale.note() + if is_released { "" } else { " Grey: the tools at the end." };
    Some(view.chart("the part and its thinning", vec![section, scale.scale()], [note]))
}
