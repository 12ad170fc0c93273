//! One pair of axes: their ranges, labels and what is drawn between them.

use super::shape::{draw_shape, rectangle};
use super::text::{CAP, LABEL, SPACING, TICK, label, text_width};
use super::ticks::{tick, tick_count, ticks};
use super::{Anchor, MARGIN, Mark, Point, WIDTH};
use crate::output::chart::{BLACK, Color, Look, Panel, Scale};
use crate::output::outline::clipped;

const TICK_MARK: f64 = 6.0;
/// Width of axes and of their grid.
const AXIS: f64 = 1.2;
const GRID: f64 = 0.8;
const GRID_COLOR: Color = (215, 215, 215);
/// The middle of a line of text above its baseline, over the font size.
const MIDDLE: f64 = 0.25;

/// The rectangle and ranges of one panel.
pub(super) struct Frame {
    pub(super) height: f64,
    x: (f64, f64),
    y: (f64, f64),
}

impl Frame {
    pub(super) fn of(panel: &Panel, width: f64) -> Self {
        let [mut x, mut y] = panel.ranges();
        let height = match panel.scale {
            Scale::Fit { height, .. } => height,
            Scale::Section { .. } => {
                let height = (width * (y.1 - y.0) / (x.1 - x.0)).clamp(290.0, 560.0);
                // Whichever direction has room to spare shows more of its surroundings.
                x.1 = x.1.max(x.0 + (y.1 - y.0) * width / height);
                let more = 0.5 * ((x.1 - x.0) * height / width - (y.1 - y.0)).max(0.0);
                y = (y.0 - more, y.1 + more);
                height
            }
        };
        Self { height, x, y }
    }

    /// Draws the panel; `corner` is the upper left one between its axes.
    pub(super) fn draw(&self, panel: &Panel, marks: &mut Vec<Mark>, corner: Point) {
        let (left, top) = corner;
        let (right, bottom) = (WIDTH - MARGIN, top + self.height);
        let share = |v: f64, (low, high): (f64, f64)| (v - low) / (high - low);
        let x_at = |x: f64| left + (right - left) * share(x, self.x);
        let y_at = |y: f64| match panel.scale {
            Scale::Section { .. } => top + (bottom - top) * share(y, self.y),
            Scale::Fit { .. } => bottom - (bottom - top) * share(y, self.y),
        };
        let (x_ticks, y_ticks) = (ticks(self.x, 8), ticks(self.y, tick_count(self.height)));
        let line = |pieces, color, width| Mark::Line { pieces, color, width };
        let upright = x_ticks.iter().map(|&x| vec![(x_at(x), bottom), (x_at(x), top)]);
        let level = y_ticks.iter().map(|&y| vec![(left, y_at(y)), (right, y_at(y))]);
        marks.push(line(upright.chain(level).collect(), GRID_COLOR, GRID));

        let away = 2.0 * TICK_MARK;
        for &x in &x_ticks {
            let at = (x_at(x), bottom + away + CAP * TICK);
            marks.push(label(&tick(x, &x_ticks), TICK, at, Anchor::Middle));
            marks.push(line(vec![vec![(at.0, bottom), (at.0, bottom + TICK_MARK)]], BLACK, AXIS));
        }
        for &y in &y_ticks {
            let at = (left - away, y_at(y) + MIDDLE * TICK);
            marks.push(label(&tick(y, &y_ticks), TICK, at, Anchor::End));
            marks.push(line(vec![vec![(left - TICK_MARK, y_at(y)), (left, y_at(y))]], BLACK, AXIS));
        }
        let at = (0.5 * (left + right), bottom + x_labels_height() - MIDDLE * LABEL);
        marks.push(label(&panel.x.text(), LABEL, at, Anchor::Middle));
        marks
            .push(label(&panel.y.text(), LABEL, (MARGIN + CAP * LABEL, 0.5 * (top + bottom)), Anchor::Middle).turned());

        for series in &panel.series {
            let points = match series.look {
                Look::Area { .. } => &clipped(&series.points, self.x, self.y),
                _ => &series.points,
            };
            let finite = points.iter().filter(|p| p.0.is_finite() && p.1.is_finite());
            let points = finite.map(|p| (x_at(p.0), y_at(p.1))).collect();
            draw_shape(marks, series.look, series.label.as_deref().unwrap_or(""), points);
        }
        // From the middle of a side, so that all corners are joined.
        let mut border = rectangle((left, top), (right, bottom));
        border.push((left, 0.5 * (top + bottom)));
        border.insert(0, border[4]);
        marks.push(line(vec![border], BLACK, AXIS));
    }
}

pub(super) fn x_labels_height() -> f64 {
    TICK_MARK + SPACING * (TICK + LABEL) + 4.0
}

pub(super) fn y_labels_width(range: &(f64, f64), panel: &Panel) -> f64 {
    let height = if let Scale::Fit { height, .. } = panel.scale { height } else { 400.0 };
    let values = ticks(*range, tick_count(height));
    let widest = values.iter().map(|v| text_width(&tick(*v, &values), TICK)).fold(0.0, f64::max);
    SPACING * LABEL + widest + TICK_MARK + 14.0
}
