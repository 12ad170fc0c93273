//! The part: its whole section coloured by thinning, its thinnest place and the place of a tear.

use super::StageView;
use super::chart::Chart;
use super::sections::{callout, cross, panel, whole_tools, whole_window};
use super::thinning::{Thinning, exaggeration, thickness_note};
use crate::assess::tears_at;
use crate::solver::solution::ElementRecord;
use crate::units::Amount;

/// Width of the section, and in a narrow column \[px\]: callouts that cover no sheet there cover none in a wide picture.
const WIDE: f64 = 680.0;
const NARROW: f64 = 430.0;
/// Half the width of the cross \[px\].
const CROSS: f64 = 9.0;
/// Share of the torn half that is left to the callout of the thinnest place.
const SHARED: f64 = 0.25;

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frame) = (view.model(), view.stage.frames.last()?);
    let window = whole_window(frame);
    let right = window[0].1;
    let (mm, narrow) = (2.0 * right / WIDE, 2.0 * right / NARROW);
    let initial = model.blank.thickness;
    let thinning = Thinning::new(initial, [frame]);
    let times = exaggeration(initial, 1.0 / mm);
    let is_released = model.release.is_some();
    let tools = whole_tools(model, frame, right).filter(|_| !is_released);
    let place = |element: &ElementRecord| (element.r, element.z);
    let least =
        |value: &dyn Fn(&ElementRecord) -> f64| frame.elements.iter().min_by(|a, b| value(a).total_cmp(&value(b)));
    let thinnest = least(&|element| element.thickness)?;
    let tear = tears_at(view.stage).and_then(|s0| least(&|element| (element.s0 - s0).abs()));
    let left = if tear.is_some() { -SHARED * right } else { -right };
    let text = thickness_text(initial, thinnest.thickness);
    let mut callouts = vec![callout(text, place(thinnest), (1.0, left), frame, window, [narrow, mm])];
    let mut section = panel(model.geometry, window).with(tools).with(thinning.section(frame, times, true));
    if let Some(torn) = tear {
        let side = (-1.0, SHARED * right);
        callouts.push(callout("tears here".to_owned(), place(torn), side, frame, window, [narrow, mm]));
        section = section.with(cross((-torn.r, torn.z), CROSS * mm));
    }
    let mut note = thickness_note(times);
    if !is_released {
        note += " Grey: the tools at the end.";
    }
    let panels = vec![section.annotated(callouts), thinning.scale()];
    Some(view.chart("the part and its thinning", panels, [note]))
}

/// `0.61 mm, 39 % thinner`
fn thickness_text(initial: f64, thickness: f64) -> String {
    let thinning = 1.0 - thickness / initial;
    let word = if thinning < 0.0 { "thicker" } else { "thinner" };
    format!("{}, {} {word}", Amount::thickness(thickness), Amount::share(thinning.abs()))
}
