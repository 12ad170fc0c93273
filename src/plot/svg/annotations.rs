//! Texts inside a panel.

use super::shapes::{blank, dot, line};
use super::text::{FLAG, MARK, SPACING, draw_line, width, wrapped};
use super::*;
use crate::plot::chart::AnnotationKind;
use plotters::style::text_anchor::HPos;

const GAP: f64 = 5.0;
const AROUND: f64 = 6.0;
const WIDEST: f64 = 0.95;
const DOT: f64 = 0.23;
const RIM: f64 = 0.36;

struct Flag {
    /// Distance of the line from the panel's left edge \[px\], and the point's y \[unit of the axis\].
    at: (f64, f64),
    lines: Vec<String>,
    left: f64,
    width: f64,
    /// Rows of the first line and behind the last one, from the top.
    rows: [usize; 2],
}

pub(super) struct Flags {
    flags: Vec<Flag>,
    /// Font size \[px\].
    size: f64,
}

impl Flags {
    /// Places the flags right of their lines, or left if there is no room, in the uppermost free row.
    pub fn new(panel: &Panel, x: (f64, f64), panel_width: f64) -> Self {
        let size = if panel.is_section() { FLAG } else { MARK };
        let mut annotations: Vec<_> = panel.annotations.iter().collect();
        annotations.retain(|a| a.kind == AnnotationKind::Flag && (x.0..=x.1).contains(&a.at.0));
        annotations.sort_by(|a, b| a.at.0.total_cmp(&b.at.0));
        let mut flags: Vec<Flag> = Vec::new();
        for annotation in annotations {
            let at = (panel_width * (annotation.at.0 - x.0) / (x.1 - x.0), annotation.at.1);
            let lines = wrapped(&annotation.text, size, WIDEST * panel_width);
            let width = lines.iter().map(|line| width(line, size)).fold(0.0, f64::max);
            let right = at.0 + GAP;
            let left = if right + width + GAP > panel_width { (at.0 - GAP - width).max(GAP) } else { right };
            let (from, to) = (left.min(at.0) - GAP, left + width + GAP);
            let meets = |other: &&Flag| from < other.left + other.width && other.left < to;
            let row = flags.iter().filter(meets).map(|other| other.rows[1]).max().unwrap_or(0);
            flags.push(Flag { at, left, width, rows: [row, row + lines.len()], lines });
        }
        Self { flags, size }
    }

    pub fn height(&self) -> f64 {
        let rows = self.flags.iter().map(|flag| flag.rows[1]).max();
        rows.map_or(0.0, |rows| SPACING * self.size * rows as f64 + 2.0 * AROUND)
    }

    /// Draws the flags; `y_px` maps a value of the y axis to a distance from the panel's upper edge.
    pub fn draw(&self, plot: &Canvas, y_px: impl Fn(f64) -> f64, height: f64, is_section: bool) {
        let (size, row) = (self.size, SPACING * self.size);
        let top = |flag: &Flag| AROUND + row * flag.rows[0] as f64;
        for flag in &self.flags {
            let (x, y) = (flag.at.0, y_px(flag.at.1));
            line(plot, &[(x, top(flag)), (x, if is_section { y } else { height })], GREY, 0.9);
            dot(plot, (x, y), RIM * size, WHITE);
            dot(plot, (x, y), DOT * size, BLACK);
        }
        for flag in &self.flags {
            let (left, right, top) = (flag.left, flag.left + flag.width, top(flag));
            let (side, x) = if left < flag.at.0 { (HPos::Right, right) } else { (HPos::Left, left) };
            blank(plot, (left - 2.0, top), (right + 1.0, top + row * flag.lines.len() as f64));
            for (i, line) in flag.lines.iter().enumerate() {
                draw_line(plot, line, size, (x, top + row * (i as f64 + 0.5)), side);
            }
        }
    }
}

pub(super) fn draw(plot: &Canvas, panel: &Panel, to_px: impl Fn((f64, f64)) -> (f64, f64)) {
    for annotation in &panel.annotations {
        let ((x, y), label) = (to_px(annotation.at), annotation.text.as_str());
        let (share, side) = match annotation.kind {
            AnnotationKind::Start => (0.0, HPos::Left),
            AnnotationKind::End => (1.0, HPos::Right),
            AnnotationKind::Flag => continue,
        };
        let (wide, half) = (width(label, MARK), 0.5 * SPACING * MARK);
        let left = x - share * wide;
        blank(plot, (left - 2.0, y - half), (left + wide + 2.0, y + half));
        draw_line(plot, label, MARK, (x, y), side);
    }
}
