//! Mid-surface strains over the blank at the last frame, with earlier frames thin behind them.

use super::StageView;
use super::chart::{Chart, Panel, Series, Style};
use crate::solver::solution::{ElementRecord, Frame};
use crate::table::Field;
use crate::table::fields::element::{S0, STRAIN_HOOP, STRAIN_MERIDIONAL, STRAIN_THICKNESS};

const STRAINS: [Field<ElementRecord>; 3] = [STRAIN_MERIDIONAL, STRAIN_HOOP, STRAIN_THICKNESS];
/// Least span of the axis \[–\].
const LEAST: f64 = 0.02;

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (extent, last) = (view.extent(), view.stage.frames.last()?);
    let values = STRAINS.iter().flat_map(|field| last.elements.iter().map(field.value));
    if view.is_level(0.0, values, LEAST) {
        return None;
    }
    let curves = |frame: &Frame| STRAINS.map(|field| S0.against(&field, &frame.elements)).into_iter().enumerate();
    let mut panel = Panel::fit(S0.axis(extent), Field::shared_axis(&STRAINS, extent), 350.0, LEAST);
    for frame in view.shown_frames().rev().skip(1) {
        panel = panel.with(curves(frame).map(|(i, points)| Series::silent(points, Style::curve(i).faint())));
    }
    let panel =
        panel.with(curves(last).map(|(i, points)| Series::new(STRAINS[i].label(extent), points, Style::curve(i))));
    let note = "Thin: the earlier frames. Logarithmic strains of the mid-surface.".to_owned();
    let title = view.titled(&format!("strains, {} {}", view.progress(), view.progress_at(last)));
    Some(Chart::new(title, vec![panel], std::iter::once(note).chain(view.notes_on_frames()).collect()))
}
