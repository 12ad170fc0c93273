//! Thickness over the part itself: along the formed sheet, through the bands that a designer names.

use super::chart::{GREY, Look, Panel, Scale, Series};
use super::{StageView, font};
use crate::measure::{Stretch, along, bands};
use crate::table::fields::element::THICKNESS;
use crate::table::{Column, Unit};

/// Width of the panel in a narrow column, so that names that are apart there are in a wide one too, and size of its letters
/// \[px\].
const NARROW: f64 = 430.0;
const LETTERS: f64 = 15.0;
/// Between two names \[px\].
const GAP: f64 = 8.0;
/// Height of a row of names over that of the curve \[–\].
const ROW: f64 = 0.1;

/// The last frame's thickness over the length along the part, with the names of its bands above; `None` of a sheet that
/// lies against no tool.
pub(super) fn panel(view: &StageView, scale: Scale) -> Option<Panel> {
    let frame = view.stage.frames.last()?;
    let bands = Some(bands(view.stage)).filter(|bands| !bands.is_empty())?;
    let along = along(frame);
    let middles = along.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
    let curve: Vec<(f64, f64)> = middles.zip(frame.elements.iter().map(|e| e.thickness)).collect();
    let (low, high) =
        curve.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.1), high.max(p.1)));
    let Scale::Fit { least, .. } = scale else { return None };
    // The axis begins at zero where that is near.
    let foot = if low < 0.5 * high { 0.0 } else { low };
    let row = ROW * (high - foot).max(least);
    let named: Vec<String> = bands.iter().map(|stretch| view.tell(stretch.band.name())).collect();
    let names = names(&bands, &named, NARROW / along[along.len() - 1]);
    let top = high + row * (1.0 + names.iter().map(|name| name.1).max().unwrap_or(0) as f64);
    let named = names
        .into_iter()
        .zip(named)
        .map(|((x, at), name)| Series::new(name, vec![(x, high + row * (0.7 + at as f64))], Look::Text));
    let border = Look::Line { color: GREY, width: 1.2, dash: &[4.0, 3.0] };
    let borders = bands
        .iter()
        .skip(1)
        .map(|stretch| Series::silent(vec![(stretch.along[0], foot), (stretch.along[0], top)], border));
    // As the last frame's curve over the blank.
    let look = Look::curve(view.shown().count().saturating_sub(1));
    let curve = Series::silent(curve, look);
    let x = Column::new("along", "Length along the part from its middle", Unit::Mm, Vec::new());
    Some(Panel {
        x: x.axis(),
        y: THICKNESS.axis(view.extent()),
        series: borders.chain([curve]).chain(named).collect(),
        scale,
    })
}

/// Where the name of each band begins \[mm\], about its middle, and in which row, so that none covers another; a mm takes
/// so many px.
fn names(bands: &[Stretch], named: &[String], px: f64) -> Vec<(f64, usize)> {
    let whole = bands.last().map_or(0.0, |last| last.along[1]);
    let mut ends: Vec<f64> = Vec::new();
    let place = |(stretch, name): (&Stretch, &String)| {
        let width = LETTERS * font::width(name) / px;
        let from = (0.5 * (stretch.along[0] + stretch.along[1] - width)).min(whole - width).max(0.0);
        let row = ends.iter().position(|end| *end <= from).unwrap_or(ends.len());
        if row == ends.len() {
            ends.push(0.0);
        }
        ends[row] = from + width + GAP / px;
        (from, row)
    };
    bands.iter().zip(named).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Band;

    /// Trust: every pair is held against each other; 100 mm of a hat of 435 mm are bands of two letters' width.
    #[test]
    fn names_do_not_cover_each_other() {
        let ends = [0.0, 320.0, 336.0, 365.0, 382.0, 435.0];
        let named = [Band::Bottom, Band::PunchRadius, Band::Wall, Band::DieRadius, Band::Flange];
        let stretch = |i: usize| Stretch { band: named[i], elements: i..i + 1, along: [ends[i], ends[i + 1]] };
        let bands: Vec<Stretch> = (0..named.len()).map(stretch).collect();
        let px = NARROW / 435.0;
        let words = named.map(|band| band.name().to_owned());
        let places = names(&bands, &words, px);
        assert!(places.iter().any(|place| place.1 > 0), "narrow bands need rows: {places:?}");
        for (i, (a, row)) in places.iter().enumerate() {
            let end = a + LETTERS * font::width(named[i].name()) / px;
            assert!(*a >= 0.0 && end <= 435.0 + 1e-9, "{}", named[i].name());
            let clear = places[i + 1..].iter().filter(|other| other.1 == *row).all(|other| other.0 >= end);
            assert!(clear, "{} in {places:?}", named[i].name());
        }
    }
}
