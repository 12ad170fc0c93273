//! Thinning as colours: one scale for all pictures of a stage, the thinner the darker.

use super::{palette::viridis, sections::mirrored, sections::sheet, sections::whole_sheet, *};
use std::ops::Range;

/// Largest share of the colour map: lighter colours are lost on paper.
const LIGHTEST: f64 = 0.92;
const UNCHANGED: f64 = 0.55;
/// Widths of a colour that are tried \[%\], and the most colours.
const STEPS: [f64; 6] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0];
const MOST: i32 = 40;
/// Least number of colours, so that a level sheet does not show its round-off.
const LEAST: i32 = 4;
const SLACK: f64 = 0.02;
const OUTLINE: Style = Style::Line { color: (70, 70, 70), width: 0.7, dash: &[] };
/// Least thickness of a drawn sheet \[px\].
const VISIBLE: f64 = 3.0;

pub(super) struct Thinning {
    /// Width of a colour \[%\].
    step: f64,
    /// Colours, in steps from zero, a border between two.
    levels: Range<i32>,
    /// Factor on the drawn thickness that makes the sheet visible.
    times: f64,
}

/// Reduction of the thickness \[%\]; negative if thicker.
pub(crate) fn percent(element: &ElementRecord) -> f64 {
    -100.0 * element.strain_thickness.exp_m1()
}

impl Thinning {
    /// Finest scale that covers every element of these frames; a mm is drawn as so many `px`.
    pub fn new<'a>(initial: f64, px: f64, frames: impl IntoIterator<Item = &'a Frame>) -> Self {
        let (px, elements) = (initial * px, frames.into_iter().flat_map(|frame| &frame.elements));
        Self { times: if px >= VISIBLE { 1.0 } else { (VISIBLE / px).ceil() }, ..Self::over(elements.map(percent)) }
    }

    fn over(thinning: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = bounds(thinning.into_iter().chain([0.0]));
        let levels = |step: f64| (low / step + SLACK).floor() as i32..(high / step - SLACK).ceil() as i32;
        let fits = |step: &f64| levels(*step).len() as i32 <= MOST;
        let step = STEPS.into_iter().find(fits).unwrap_or(STEPS[STEPS.len() - 1]);
        let Range { start, end } = levels(step);
        Self { step, levels: start..end.max(start + LEAST), times: 1.0 }
    }

    fn level(&self, thinning: f64) -> i32 {
        ((thinning / self.step + SLACK).floor() as i32).clamp(self.levels.start, self.levels.end - 1)
    }

    fn color(&self, level: i32) -> Color {
        let (start, end) = (f64::from(self.levels.start), f64::from(self.levels.end));
        let (zero, middle) = (if start < 0.0 { UNCHANGED } else { LIGHTEST }, f64::from(level) + 0.5);
        viridis(if level < 0 { zero + (LIGHTEST - zero) * middle / start } else { zero * (1.0 - middle / end) })
    }

    pub fn section(&self, frame: &Frame, is_whole: bool) -> Vec<Series> {
        let parts = |outline| if is_whole { mirrored(outline) } else { vec![outline] };
        let levels: Vec<i32> = frame.elements.iter().map(|element| self.level(percent(element))).collect();
        let (mut series, mut from) = (Vec::new(), 0);
        for equal in levels.chunk_by(|a, b| a == b) {
            // One element under the next colour, so that no paper shines through.
            let elements = from..(from + equal.len() + 1).min(levels.len());
            let style = Style::area(self.color(equal[0]));
            series.extend(parts(sheet(frame, elements, self.times)).into_iter().map(|one| Series::silent(one, style)));
            from += equal.len();
        }
        for mut edge in parts(whole_sheet(frame, self.times)) {
            edge.extend(edge.first().copied());
            series.push(Series::silent(edge, OUTLINE));
        }
        series
    }

    pub fn scale(&self) -> Panel {
        let at = |level: i32| f64::from(level) * self.step;
        let colors = self.levels.clone().map(|level| {
            let (from, to) = (at(level), at(level + 1));
            Series::silent(vec![(from, 0.0), (to, 0.0), (to, 1.0), (from, 1.0)], Style::area(self.color(level)))
        });
        let label = if self.levels.start < 0 { "Thinning, negative where thicker" } else { "Thinning" };
        let axis = Axis::named(label, Unit::Percent);
        let zero = Series::silent(vec![(0.0, 0.0), (0.0, 1.0)], Style::solid(BLACK, 3.0));
        Panel::new(axis.clone(), axis, Scale::Bar).with(colors.chain([zero]))
    }

    pub fn note(&self) -> String {
        match self.times {
            1.0 => "The sheet is true to thickness.".to_owned(),
            times => format!("The sheet is drawn {times} times as thick as it is."),
        }
    }
}

/// Reference: by hand: 10 % thicker to 39 % thinner are 49 steps of 1 %, 25 of 2 %.
#[cfg(test)]
#[test]
fn zero_is_a_border_between_colours() {
    let thinning = [39.0, 2.0, 0.0, -1e-10, -6.0, -10.0];
    let scale = Thinning::over(thinning);
    assert_eq!((scale.step, scale.levels.clone()), (2.0, -5..20));
    assert_eq!(thinning.map(|t| scale.level(t)), [19, 1, 0, 0, -3, -5]);
    assert_eq!(scale.scale().ranges(), [(-10.0, 40.0), (0.0, 1.0)]);
}
