//! Thinning as colours: one scale for all pictures of a stage, its zero marked; the thinner, the darker, in grey too. What has
//! become thicker has fewer and wider colours: it does no harm, and the thin places want to be told apart.

use super::chart::{BLACK, Color, Look, Panel, Scale, Series};
use super::sections::{self, sheet};
use super::viridis::viridis;
use crate::solver::solution::Frame;
use crate::table::{Column, Unit};
use crate::units::Amount;
use std::ops::Range;

/// How far up the map colours go \[–\]: the lightest ones are lost on paper.
const LIGHTEST: f64 = 0.92;

/// Widths of a colour that are tried \[%\], from the finest; the first is taken that needs no more colours than can be
/// told apart on the scale, for what is thinner than the blank and for what is thicker.
const STEPS: [f64; 6] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0];
const MOST_THINNER: usize = 8;
const MOST_THICKER: usize = 4;
/// As few colours as a scale has: a sheet that is level does not show its round-off.
const LEAST: i32 = 4;
/// What belongs to the colour before, over a colour's width: round-off.
const SLACK: f64 = 0.02;

/// The outline of the sheet: it stands out from the tools in grey print too.
const OUTLINE: Look = Look::Line { color: (70, 70, 70), width: 0.7, dash: &[] };
/// A sheet that comes out thinner than this is drawn thicker \[px of a picture 800 wide\], and the picture says so.
const VISIBLE: f64 = 3.0;

/// The scale of a stage's pictures.
pub(crate) struct Thinning {
    /// Thickness of the blank \[mm\].
    initial: f64,
    /// Width of a colour where the sheet is thinner than the blank, and where it is thicker \[%\].
    thinner: f64,
    thicker: f64,
    /// The colours go from so many steps of the thicker below zero to so many of the thinner above.
    levels: Range<i32>,
}

/// How much thinner than the blank \[%\]; negative where it is thicker.
pub(crate) fn percent(initial: f64, thickness: f64) -> f64 {
    100.0 * (1.0 - thickness / initial)
}

impl Thinning {
    /// The finest scale that has a colour for every element of these frames, and for what is as thick as the blank.
    pub fn of<'a>(initial: f64, frames: impl Iterator<Item = &'a Frame>) -> Self {
        let values = frames.flat_map(|frame| &frame.elements).map(|element| percent(initial, element.thickness));
        let (low, high) = values.fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        let colors = |side: f64, step: f64| (side / step - SLACK).ceil().max(0.0) as usize;
        let finest = |side: f64, least: f64, most: usize| {
            let fits = |step: &f64| *step >= least && colors(side, *step) <= most;
            STEPS.into_iter().find(fits).unwrap_or(STEPS[STEPS.len() - 1])
        };
        let thinner = finest(high, 0.0, MOST_THINNER);
        let thicker = finest(-low, thinner, MOST_THICKER);
        let start = -(colors(-low, thicker) as i32);
        Self { initial, thinner, thicker, levels: start..(colors(high, thinner) as i32).max(start + LEAST) }
    }

    fn level(&self, thickness: f64) -> i32 {
        let percent = percent(self.initial, thickness);
        let level = (percent / self.step(percent) + SLACK).floor() as i32;
        level.clamp(self.levels.start, self.levels.end - 1)
    }

    /// Width of a colour on the side of zero of a percent, or of a level \[%\].
    fn step(&self, side: f64) -> f64 {
        if side < 0.0 { self.thicker } else { self.thinner }
    }

    fn color(&self, level: i32) -> Color {
        let done = (f64::from(level - self.levels.start) + 0.5) / self.levels.len() as f64;
        viridis(LIGHTEST * (1.0 - done))
    }

    /// Stretches of one colour, from the axis outward. Each but the last goes an element under the next, so that no paper
    /// shines through between them.
    pub fn stretches(&self, frame: &Frame) -> Vec<(Range<usize>, Look)> {
        let levels: Vec<i32> = frame.elements.iter().map(|element| self.level(element.thickness)).collect();
        let mut from = 0;
        let stretches = levels.chunk_by(|a, b| a == b).map(|alike| {
            let stretch = from..(from + alike.len() + 1).min(levels.len());
            from += alike.len();
            (stretch, Look::Area { fill: self.color(alike[0]), edge: None })
        });
        stretches.collect()
    }

    /// One half of the section, its thickness drawn so many `times`.
    pub fn section(&self, frame: &Frame, times: f64) -> Vec<Series> {
        let stretches = self.stretches(frame).into_iter();
        let colored = stretches.map(|(elements, look)| Series::silent(sheet(frame, elements, times), look));
        let mut edge = sheet(frame, 0..frame.elements.len(), times);
        edge.extend(edge.first().copied());
        colored.chain([Series::silent(edge, OUTLINE)]).collect()
    }

    /// The section and its mirror image beyond the middle.
    pub fn whole(&self, frame: &Frame, times: f64) -> Vec<Series> {
        let stretches = self.stretches(frame).into_iter();
        let colored = stretches.flat_map(|(elements, look)| {
            let parts = sections::mirrored(sheet(frame, elements, times));
            parts.into_iter().map(move |part| Series::silent(part, look))
        });
        let edges = sections::mirrored(sheet(frame, 0..frame.elements.len(), times)).into_iter().map(|mut edge| {
            edge.extend(edge.first().copied());
            Series::silent(edge, OUTLINE)
        });
        colored.chain(edges).collect()
    }

    /// The colours over the percents that they stand for.
    pub fn scale(&self) -> Panel {
        let at = |level: i32| f64::from(level) * self.step(f64::from(level));
        let colors = self.levels.clone().map(|level| {
            let (from, to) = (at(level), at(level + 1));
            let look = Look::Area { fill: self.color(level), edge: None };
            Series::silent(vec![(from, 0.0), (to, 0.0), (to, 1.0), (from, 1.0)], look)
        });
        let zero = Look::Line { color: BLACK, width: 3.0, dash: &[] };
        let label = if self.levels.start < 0 { "Thinning, negative where thicker" } else { "Thinning" };
        let axis = Column::new("thinning", label, Unit::Percent, vec![]).axis();
        Panel {
            x: axis.clone(),
            y: axis,
            series: colors.chain([Series::silent(vec![(0.0, 0.0), (0.0, 1.0)], zero)]).collect(),
            scale: Scale::Bar,
        }
    }
}

/// How many times its thickness a sheet is drawn \[–\] where a mm takes so many px: once where it can be seen.
pub(crate) fn times(thickness: f64, px: f64) -> f64 {
    let px = thickness * px;
    if px >= VISIBLE { 1.0 } else { (VISIBLE / px).ceil() }
}

/// What a picture says of its sheet's thickness.
pub(crate) fn said(times: f64) -> String {
    match times {
        1.0 => "The sheet is true to thickness.".into(),
        _ => format!("The sheet is drawn {times} times as thick as it is.", times = Amount::number(times)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::solution::{ElementRecord, ThroughThickness};

    fn frame(thickness: &[f64]) -> Frame {
        let elements = thickness.iter().map(|t| ElementRecord { thickness: *t, ..ElementRecord::default() }).collect();
        let through = ThroughThickness::default();
        Frame { time: 0.0, travel: 0.0, elements, nodes: vec![], through, tool_displacement: vec![] }
    }

    fn lightness((r, g, b): Color) -> f64 {
        0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
    }

    /// Trust: lightness as grey print has it (ITU-R BT.601), over every scale from the finest to the coarsest.
    #[test]
    fn the_thinner_the_darker() {
        for thinnest in [0.999, 0.97, 0.9, 0.6, 0.1] {
            let scale = Thinning::of(1.0, [frame(&[1.1, thinnest])].iter());
            let shades: Vec<f64> = scale.levels.clone().map(|level| lightness(scale.color(level))).collect();
            assert!((LEAST as usize..=MOST_THINNER + MOST_THICKER).contains(&shades.len()), "{shades:?}");
            // A step of 8 of 255 is seen where two greys meet.
            assert!(shades.windows(2).all(|pair| pair[0] - pair[1] > 8.0), "{shades:?}");
        }
    }

    /// Trust: lightness as above, three of its steps. The rim of a cup, 38 % thicker, takes no more colours than its nose,
    /// 8.4 % thinner.
    #[test]
    fn what_thins_little_is_told_apart_beside_a_thick_rim() {
        let scale = Thinning::of(1.0, [frame(&[1.38, 0.916])].iter());
        assert_eq!((scale.thicker, scale.thinner, scale.levels.clone()), (10.0, 2.0, -4..5));
        let shade = |thickness: f64| lightness(scale.color(scale.level(thickness)));
        assert!(shade(0.98) - shade(0.93) > 24.0, "{} {}", shade(0.98), shade(0.93));
        assert_eq!(scale.scale().ranges()[0], (-40.0, 10.0));
    }

    /// Trust: colours by hand: of 10 % thicker to 39 % thinner, ten steps of 5 % do, from −10 to 40 %.
    #[test]
    fn zero_is_where_a_colour_begins_and_every_element_has_its_own() {
        let thickness = [0.61, 0.98, 1.0, 1.0 + 1e-12, 1.06, 1.1];
        let scale = Thinning::of(1.0, [frame(&thickness)].iter());
        assert_eq!((scale.thicker, scale.thinner, scale.levels.clone()), (5.0, 5.0, -2..8));
        assert_eq!(thickness.map(|t| scale.level(t)), [7, 0, 0, 0, -2, -2]);
        let stretches: Vec<Range<usize>> = scale.stretches(&frame(&thickness)).into_iter().map(|s| s.0).collect();
        assert_eq!(stretches, [0..2, 1..5, 4..6]);
        let bar = scale.scale().ranges();
        assert_eq!(bar, [(-10.0, 40.0), (0.0, 1.0)]);
    }

    #[test]
    fn a_sheet_too_thin_to_be_seen_is_drawn_thicker() {
        assert_eq!([1.0, 0.5, 0.1].map(|t| times(t, 6.0)), [1.0, 1.0, 5.0]);
    }
}
