//! Thickness along the formed sheet, with the names of its bands: bottom, punch radius, wall, die radius, flange.

use super::*;
use crate::measure::{along, bands};
use crate::plot::fields::element::THICKNESS;

const HEIGHT: f64 = 270.0;
const BORDER: Style = Style::Line { color: GREY, width: 1.2, dash: &[4.0, 3.0] };

/// Panel of the last frame; `None` for a sheet that touches no tool. `least` is the least span of the thickness \[mm\].
pub(super) fn panel(view: &StageView, least: f64) -> Option<Panel> {
    let frame = view.stage.frames.last()?;
    let bands = Some(bands(view.stage)).filter(|bands| !bands.is_empty())?;
    let along = along(frame);
    let middles = along.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
    let curve: Vec<(f64, f64)> = middles.zip(frame.elements.iter().map(|e| e.thickness)).collect();
    let (low, high) = bounds(curve.iter().map(|p| p.1));
    let border = |x: f64| Series::silent(vec![(x, low), (x, high)], BORDER);
    let borders: Vec<Series> = bands.iter().skip(1).map(|band| border(band.along[0])).collect();
    let names = bands.iter().filter_map(|band| {
        let middle = 0.5 * (band.along[0] + band.along[1]);
        let at = curve.iter().min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs()))?;
        Some(Annotation::flag(&band.name, *at))
    });
    let x = Axis::named("Length along the part", Unit::Mm);
    let panel = Panel::fit(x, THICKNESS.axis(view.extent()), HEIGHT, least).with(borders).annotated(names);
    // The style of the last frame in the panel over the blank.
    Some(panel.with([Series::silent(curve, Style::curve(view.shown_frames().len().saturating_sub(1)))]))
}
