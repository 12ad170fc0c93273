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
/// From a name to its band.
const LEADER: Look = Look::Line { color: GREY, width: 0.8, dash: &[] };

/// The last frame's thickness over the length along the part, with the names of its bands above; `None` of a sheet that
/// lies against no tool.
pub(crate) fn panel(view: &StageView, scale: Scale) -> Option<Panel> {
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
    let named: Vec<String> = bands.iter().map(|stretch| String::from(stretch.band.name())).collect();
    let names = names(&bands, &named, NARROW / along[along.len() - 1]);
    let top = high + row * if names.iter().any(|name| name.is_above) { 3.6 } else { 1.4 };
    let leaders = bands.iter().zip(&names).filter(|(_, name)| name.is_above).map(|(stretch, name)| {
        let bend = high + 1.4 * row;
        Series::silent(
            vec![(middle(stretch), high + 0.2 * row), (middle(stretch), bend), (name.at, bend + 1.2 * row)],
            LEADER,
        )
    });
    let leaders: Vec<Series> = leaders.collect();
    let named = names.iter().zip(named).map(|(name, text)| {
        let up = if name.is_above { 3.0 } else { 0.7 };
        Series::new(text, vec![(name.at, high + up * row)], Look::Name)
    });
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
        series: borders.chain([curve]).chain(leaders).chain(named).collect(),
        scale,
    })
}

/// Where the name of a band stands.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Name {
    /// Its middle \[mm\].
    at: f64,
    /// Whether it has no room in its band: then it stands above those that have, with a leader to its band.
    is_above: bool,
}

fn middle(stretch: &Stretch) -> f64 {
    0.5 * (stretch.along[0] + stretch.along[1])
}

/// The names of the bands in their middles, or as near to them as they have room beside each other above; a mm takes so many
/// px.
fn names(bands: &[Stretch], named: &[String], px: f64) -> Vec<Name> {
    let whole = bands.last().map_or(0.0, |last| last.along[1]);
    let width = |name: &String| (LETTERS * font::width(name) + GAP) / px;
    let fits = |stretch: &Stretch, name: &String| width(name) <= stretch.along[1] - stretch.along[0];
    let mut names: Vec<Name> =
        bands.iter().zip(named).map(|(s, name)| Name { at: middle(s), is_above: !fits(s, name) }).collect();
    // From the left and back again each is moved no further than it must.
    let mut end = 0.0;
    for (name, text) in names.iter_mut().zip(named).filter(|(name, _)| name.is_above) {
        name.at = name.at.max(end + 0.5 * width(text));
        end = name.at + 0.5 * width(text);
    }
    let mut end = whole;
    for (name, text) in names.iter_mut().zip(named).rev().filter(|(name, _)| name.is_above) {
        name.at = name.at.min(end - 0.5 * width(text));
        end = name.at - 0.5 * width(text);
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Band;

    /// Trust: every pair is held against each other; 100 mm of a hat of 435 mm are bands of two letters' width. Names keep the
    /// order of their bands, so that leaders do not cross.
    #[test]
    fn names_stand_in_their_bands_or_above_them_in_order() {
        let ends = [0.0, 320.0, 336.0, 365.0, 382.0, 435.0];
        let named = [Band::Bottom, Band::PunchRadius, Band::Wall, Band::DieRadius, Band::Flange];
        let stretch = |i: usize| Stretch { band: named[i], elements: i..i + 1, along: [ends[i], ends[i + 1]] };
        let bands: Vec<Stretch> = (0..named.len()).map(stretch).collect();
        let px = NARROW / 435.0;
        let words = named.map(|band| band.name().to_owned());
        let names = names(&bands, &words, px);
        assert_eq!(names.iter().map(|name| name.is_above).collect::<Vec<_>>(), [false, true, true, true, true]);
        assert_eq!(names[0].at, 160.0);
        let half = |i: usize| 0.5 * LETTERS * font::width(&words[i]) / px;
        for i in 1..names.len() {
            assert!(names[i].at - half(i) >= 0.0 && names[i].at + half(i) <= 435.0, "{} in {names:?}", words[i]);
            let apart = i == 1 || names[i - 1].at + half(i - 1) < names[i].at - half(i);
            assert!(apart, "{} in {names:?}", words[i]);
        }
    }
}
