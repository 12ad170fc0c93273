//! Thickness along the formed sheet, with the names of its bands: bottom, punch radius, wall, die radius, flange.

use super::StageView;
use super::chart::{Annotation, AnnotationKind, Panel, Series, Style, bounds};
use super::palette::GREY;
use crate::measure::{Stretch, along, bands};
use crate::plot::Axis;
use crate::table::Unit;
use crate::table::fields::element::THICKNESS;

/// Width of the panel in a narrow column \[px\]: names that are apart there are apart in a wide one.
const NARROW: f64 = 430.0;
/// Mean width of a letter and the space between two names \[px\].
const LETTER: f64 = 9.3;
const GAP: f64 = 8.0;
/// Height of a row of names over that of the curve \[–\].
const ROW: f64 = 0.1;
const HEIGHT: f64 = 270.0;
const LEADER: Style = Style::Line { color: GREY, width: 0.8, dash: &[] };
const BORDER: Style = Style::Line { color: GREY, width: 1.2, dash: &[4.0, 3.0] };

/// Panel of the last frame; `None` for a sheet that touches no tool. `least` is the least span of the thickness \[mm\].
pub(super) fn panel(view: &StageView, least: f64) -> Option<Panel> {
    let frame = view.stage.frames.last()?;
    let bands = Some(bands(view.stage)).filter(|bands| !bands.is_empty())?;
    let along = along(frame);
    let middles = along.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
    let curve: Vec<(f64, f64)> = middles.zip(frame.elements.iter().map(|e| e.thickness)).collect();
    let (low, high) = bounds(curve.iter().map(|p| p.1));
    // The axis begins at zero if that is near.
    let foot = if low < 0.5 * high { 0.0 } else { low };
    let row = ROW * (high - foot).max(least);
    let names = place_names(&bands, NARROW / along[along.len() - 1]);
    let top = high + row * if names.iter().any(|name| name.1) { 3.6 } else { 1.4 };
    let borders =
        bands.iter().skip(1).map(|band| Series::silent(vec![(band.along[0], foot), (band.along[0], top)], BORDER));
    let leaders = bands.iter().zip(&names).filter(|(_, name)| name.1).map(|(band, name)| {
        let (x, bend) = (middle(band), high + 1.4 * row);
        Series::silent(vec![(x, high + 0.2 * row), (x, bend), (name.0, bend + 1.2 * row)], LEADER)
    });
    let texts = bands.iter().zip(&names).map(|(band, (x, is_above))| {
        let up = if *is_above { 3.0 } else { 0.7 };
        Annotation::new(AnnotationKind::Middle, band.band.name(), (*x, high + up * row))
    });
    // The style of the last frame in the panel over the blank.
    let curve = Series::silent(curve, Style::curve(view.shown_frames().len().saturating_sub(1)));
    let x = Axis::named("Length along the part from its middle", Unit::Mm);
    let panel = Panel::fit(x, THICKNESS.axis(view.extent()), HEIGHT, least);
    Some(panel.with(borders.chain([curve]).chain(leaders)).annotated(texts))
}

fn middle(band: &Stretch) -> f64 {
    0.5 * (band.along[0] + band.along[1])
}

/// Middle of each name \[mm\], and true if it is too wide for its band and stands in a row above; a mm is so many px.
fn place_names(bands: &[Stretch], px: f64) -> Vec<(f64, bool)> {
    let width = |band: &Stretch| (LETTER * band.band.name().chars().count() as f64 + GAP) / px;
    let is_above = |band: &Stretch| width(band) > band.along[1] - band.along[0];
    let mut names: Vec<(f64, bool)> = bands.iter().map(|band| (middle(band), is_above(band))).collect();
    // Names in the upper row are moved apart, from the left and back again.
    let mut end = 0.0;
    for (name, band) in names.iter_mut().zip(bands).filter(|(name, _)| name.1) {
        name.0 = name.0.max(end + 0.5 * width(band));
        end = name.0 + 0.5 * width(band);
    }
    let mut end = bands.last().map_or(0.0, |last| last.along[1]);
    for (name, band) in names.iter_mut().zip(bands).rev().filter(|(name, _)| name.1) {
        name.0 = name.0.min(end - 0.5 * width(band));
        end = name.0 - 0.5 * width(band);
    }
    names
}
