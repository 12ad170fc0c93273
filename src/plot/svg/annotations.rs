//! Texts inside a panel.

use super::Canvas;
use super::shapes::{DOT, blank, dot, line};
use super::text::{CALLOUT, MARK, SPACING, draw_line, width, wrapped};
use crate::plot::chart::{AnnotationKind, Panel};
use crate::plot::palette::{BLACK, GREY, WHITE};
use plotters::style::text_anchor::HPos;

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

pub(super) struct Flags(Vec<Flag>);

impl Flags {
    /// Places the flags right of their lines, or left if there is no room, in the uppermost free row.
    pub fn new(panel: &Panel, x: (f64, f64), panel_width: f64) -> Self {
        let mut annotations: Vec<_> = panel.annotations.iter().collect();
        annotations.retain(|a| a.kind == AnnotationKind::Flag && (x.0..=x.1).contains(&a.at.0));
        annotations.sort_by(|a, b| a.at.0.total_cmp(&b.at.0));
        let mut flags: Vec<Flag> = Vec::new();
        for annotation in annotations {
            let at = (panel_width * (annotation.at.0 - x.0) / (x.1 - x.0), annotation.at.1);
            let lines = wrapped(&annotation.text, MARK, WIDEST * panel_width);
            let width = lines.iter().map(|line| width(line, MARK)).fold(0.0, f64::max);
            let right = at.0 + GAP;
            let left = if right + width + GAP > panel_width { (at.0 - GAP - width).max(GAP) } else { right };
            let (from, to) = (left.min(at.0) - GAP, left + width + GAP);
            let meets = |other: &&Flag| from < other.left + other.width && other.left < to;
            let row = flags.iter().filter(meets).map(Flag::end).max().unwrap_or(0);
            flags.push(Flag { at, lines, left, width, row });
        }
        Self(flags)
    }

    /// Height that the flags add to the panel.
    pub fn height(&self) -> f64 {
        self.0.iter().map(Flag::end).max().map_or(0.0, |rows| ROW * rows as f64 + 2.0 * AROUND)
    }

    /// Draws the flags; `y_px` maps a value of the y axis to a distance from the panel's upper edge.
    pub fn draw(&self, plot: &Canvas, y_px: impl Fn(f64) -> f64, height: f64) {
        for flag in &self.0 {
            line(plot, &[(flag.at.0, flag.top()), (flag.at.0, height)], GREY, 0.9);
            dot(plot, (flag.at.0, y_px(flag.at.1)), DOT + 0.8, BLACK);
        }
        for flag in &self.0 {
            let (left, right, top) = (flag.left, flag.left + flag.width, flag.top());
            let (side, x) = if left < flag.at.0 { (HPos::Right, right) } else { (HPos::Left, left) };
            blank(plot, (left - 2.0, top), (right + 1.0, top + ROW * flag.lines.len() as f64));
            for (i, line) in flag.lines.iter().enumerate() {
                draw_line(plot, line, MARK, (x, top + ROW * (i as f64 + 0.5)), side);
            }
        }
    }
}

impl Flag {
    fn end(&self) -> usize {
        self.row + self.lines.len()
    }

    fn top(&self) -> f64 {
        AROUND + ROW * self.row as f64
    }
}

/// Draws texts and callouts; `to_px` maps a point of the axes to the panel.
pub(super) fn draw(plot: &Canvas, panel: &Panel, to_px: impl Fn((f64, f64)) -> (f64, f64)) {
    for annotation in &panel.annotations {
        let ((mut x, mut y), label) = (to_px(annotation.at), annotation.text.as_str());
        let (mut size, mut room) = (MARK, 2.0);
        let (share, side) = match annotation.kind {
            AnnotationKind::Start => (0.0, HPos::Left),
            AnnotationKind::Middle => (0.5, HPos::Center),
            AnnotationKind::End => (1.0, HPos::Right),
            AnnotationKind::Flag => continue,
            AnnotationKind::Callout(label_at) => {
                let at = (x, y);
                (x, y) = to_px(label_at);
                (size, room) = (CALLOUT, 3.0);
                line(plot, &[at, (x, y)], BLACK, 1.4);
                dot(plot, at, CALLOUT_RIM, WHITE);
                dot(plot, at, CALLOUT_DOT, BLACK);
                (0.5, HPos::Center)
            }
        };
        let (wide, half) = (width(label, size), 0.5 * SPACING * size);
        let left = x - share * wide;
        blank(plot, (left - room, y - half), (left + wide + room, y + half));
        draw_line(plot, label, size, (x, y), side);
    }
}
