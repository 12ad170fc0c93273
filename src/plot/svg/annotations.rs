//! Texts inside a panel.

use super::shapes::{DOT, pen};
use super::text::{CALLOUT, MARK, SPACING, clean, style, width, wrapped};
use super::{Canvas, IN_MEMORY, rgb, units};
use crate::plot::chart::{Annotation, AnnotationKind, Panel};
use crate::plot::palette::{BLACK, GREY, WHITE};
use plotters::element::{Circle, PathElement, Rectangle};
use plotters::style::Color as _;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Row of flags.
const ROW: f64 = SPACING * MARK;
/// Distance between a flag's line and its text, and around texts.
const GAP: f64 = 5.0;
/// Space above and below all flags.
const AROUND: f64 = 6.0;
/// Share of the panel's width at which a flag's text is broken.
const WIDEST: f64 = 0.95;
/// Radii of a callout's dot and of its white rim.
const CALLOUT_DOT: f64 = 7.0;
const CALLOUT_RIM: f64 = 10.5;

/// Text above all curves with a vertical line to its point.
struct Flag {
    /// Distance of the line from the panel's left edge \[px\], and the point's y \[unit of the axis\].
    at: (f64, f64),
    lines: Vec<String>,
    left: f64,
    width: f64,
    /// Row of the first line, from the top.
    row: usize,
}

/// Flags of a panel.
pub(super) struct Flags {
    flags: Vec<Flag>,
    rows: usize,
}

impl Flags {
    /// Places the flags right of their lines, or left if there is no room, in the uppermost free row.
    pub fn new(panel: &Panel, x: (f64, f64), panel_width: f64) -> Self {
        let flag = |annotation: &Annotation| {
            let at = (panel_width * (annotation.at.0 - x.0) / (x.1 - x.0), annotation.at.1);
            let lines = wrapped(&annotation.text, MARK, WIDEST * panel_width);
            let wide = lines.iter().map(|line| width(line, MARK)).fold(0.0, f64::max);
            let right = at.0 + GAP;
            let left = if right + wide + GAP > panel_width { (at.0 - GAP - wide).max(GAP) } else { right };
            Flag { at, lines, left, width: wide, row: 0 }
        };
        let inside = |a: &&Annotation| a.kind == AnnotationKind::Flag && (x.0..=x.1).contains(&a.at.0);
        let mut flags: Vec<Flag> = panel.annotations.iter().filter(inside).map(flag).collect();
        flags.sort_by(|a, b| a.at.0.total_cmp(&b.at.0));
        for i in 0..flags.len() {
            let (before, flag) = (&flags[..i], &flags[i]);
            let (from, to) = (flag.left.min(flag.at.0) - GAP, flag.left + flag.width + GAP);
            let meets = |other: &&Flag| from < other.left + other.width && other.left < to;
            flags[i].row = before.iter().filter(meets).map(|other| other.row + other.lines.len()).max().unwrap_or(0);
        }
        let rows = flags.iter().map(|flag| flag.row + flag.lines.len()).max().unwrap_or(0);
        Self { flags, rows }
    }

    /// Height that the flags add to the panel.
    pub fn height(&self) -> f64 {
        if self.rows == 0 { 0.0 } else { ROW * self.rows as f64 + 2.0 * AROUND }
    }

    /// Draws the flags; `y_px` maps a value of the y axis to a distance from the panel's upper edge.
    pub fn draw(&self, plot: &Canvas, y_px: impl Fn(f64) -> f64, height: f64) {
        let place = |x: f64, y: f64| (units(x), units(y));
        for Flag { at, row, .. } in &self.flags {
            let line = [place(at.0, AROUND + ROW * *row as f64), place(at.0, height)];
            plot.draw(&PathElement::new(line, pen(GREY, 0.9))).expect(IN_MEMORY);
            let dot = Circle::new(place(at.0, y_px(at.1)), units(DOT + 0.8), rgb(BLACK).filled());
            plot.draw(&dot).expect(IN_MEMORY);
        }
        for Flag { at, lines, left, width, row } in &self.flags {
            let top = AROUND + ROW * *row as f64;
            let (side, x) = if left < &at.0 { (HPos::Right, left + width) } else { (HPos::Left, *left) };
            white(plot, (left - 2.0, top), (left + width + 1.0, top + ROW * lines.len() as f64));
            for (i, line) in lines.iter().enumerate() {
                text(plot, line, MARK, (x, top + ROW * (i as f64 + 0.5)), side);
            }
        }
    }
}

/// Draws texts and callouts; `to_px` maps a point of the axes to the panel.
pub(super) fn draw(plot: &Canvas, panel: &Panel, to_px: impl Fn((f64, f64)) -> (f64, f64)) {
    for Annotation { at, text: label, kind } in &panel.annotations {
        let (x, y) = to_px(*at);
        let wide = width(label, MARK);
        let (left, side) = match kind {
            AnnotationKind::Start => (x, HPos::Left),
            AnnotationKind::Middle => (x - 0.5 * wide, HPos::Center),
            AnnotationKind::End => (x - wide, HPos::Right),
            AnnotationKind::Flag => continue,
            AnnotationKind::Callout(label_at) => {
                callout(plot, label, (x, y), to_px(*label_at));
                continue;
            }
        };
        let half = 0.5 * SPACING * MARK;
        white(plot, (left - 2.0, y - half), (left + wide + 2.0, y + half));
        text(plot, label, MARK, (x, y), side);
    }
}

fn callout(plot: &Canvas, label: &str, at: (f64, f64), (x, y): (f64, f64)) {
    let whole = |(x, y): (f64, f64)| (units(x), units(y));
    plot.draw(&PathElement::new([whole(at), whole((x, y))], pen(BLACK, 1.4))).expect(IN_MEMORY);
    for (radius, color) in [(CALLOUT_RIM, WHITE), (CALLOUT_DOT, BLACK)] {
        plot.draw(&Circle::new(whole(at), units(radius), rgb(color).filled())).expect(IN_MEMORY);
    }
    let (half, high) = (0.5 * width(label, CALLOUT) + 3.0, 0.5 * SPACING * CALLOUT);
    white(plot, (x - half, y - high), (x + half, y + high));
    text(plot, label, CALLOUT, (x, y), HPos::Center);
}

fn white(plot: &Canvas, from: (f64, f64), to: (f64, f64)) {
    let corners = [from, to].map(|(x, y)| (units(x), units(y)));
    plot.draw(&Rectangle::new(corners, rgb(WHITE).filled())).expect(IN_MEMORY);
}

/// Draws a line of text centred vertically on a point.
fn text(plot: &Canvas, line: &str, size: f64, (x, y): (f64, f64), side: HPos) {
    let style = style(size, BLACK).pos(Pos::new(side, VPos::Top));
    plot.draw_text(&clean(line), &style, (units(x), units(y - 0.4 * size))).expect(IN_MEMORY);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Axis, Unit};

    /// Reference: every pair by hand; texts near each other, at the right edge, and one wider than the panel.
    #[test]
    fn flags_neither_overlap_nor_leave_the_panel() {
        let axis = Axis::named("X", Unit::Mm);
        let long = "holder comes to rest on its distance blocks, at a travel that is written in words";
        let texts =
            [(10.0, "rim meets the die"), (10.5, "ironing begins"), (60.0, long), (97.0, "peak"), (99.0, "tears")];
        let flags = texts.map(|(x, text)| Annotation::new(AnnotationKind::Flag, text, (x, 1.0)));
        let panel = Panel::fit(axis.clone(), axis, 350.0, 0.0).annotated(flags);
        for width in [250.0, 400.0, 700.0] {
            let Flags { flags, rows } = Flags::new(&panel, (0.0, 100.0), width);
            assert_eq!(flags.len(), 5);
            for (i, a) in flags.iter().enumerate() {
                assert!(a.left >= 0.0 && a.left + a.width <= width && a.row + a.lines.len() <= rows);
                for b in &flags[..i] {
                    let apart = a.left + a.width < b.left || b.left + b.width < a.left;
                    let stacked = a.row + a.lines.len() <= b.row || b.row + b.lines.len() <= a.row;
                    assert!(apart || stacked, "{:?} and {:?} in {width}", a.lines, b.lines);
                }
            }
        }
    }
}
