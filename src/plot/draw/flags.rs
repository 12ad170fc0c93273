//! Marks of single places along x: a thin line up to a label that stands above all curves.

use super::backend::units;
use super::canvas::{Canvas, NEVER, rgb};
use super::letters::{MARK, SPACING, text_width, wrapped};
use super::shape::{DOT, stroke};
use super::text::style;
use crate::plot::chart::{BLACK, GREY, Look, Panel, WHITE};
use plotters::element::{Circle, PathElement, Rectangle};
use plotters::style::Color as _;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// A row of labels.
const ROW: f64 = SPACING * MARK;
/// Between a line and its label, and around labels.
const GAP: f64 = 5.0;
/// Above and below all labels.
const AROUND: f64 = 6.0;
/// Share of the panel's width that a label may take before it is broken.
const WIDEST: f64 = 0.95;

/// One of them.
struct Flag {
    /// Distance of its line from the panel's left edge, and the value of its dot along y.
    at: (f64, f64),
    lines: Vec<String>,
    /// Left end and width of its label.
    left: f64,
    width: f64,
    /// The row of its first line, from the top.
    row: usize,
}

/// Those of a panel.
pub(super) struct Flags {
    flags: Vec<Flag>,
    rows: usize,
}

impl Flags {
    /// Of a panel with this range of x and this width. Labels stand right of their lines, or left where there is no room, in
    /// the uppermost row where they meet no other label and their line meets none below.
    pub fn of(panel: &Panel, x: (f64, f64), width: f64) -> Self {
        let series = panel.series.iter().filter(|series| series.look == Look::Flag);
        let label = |series| -> &str { Option::as_deref(series).unwrap_or("") };
        let mut flags: Vec<Flag> = series
            .flat_map(|series| series.points.iter().map(|point| (point, label(&series.label))))
            .filter(|((at, _), _)| (x.0..=x.1).contains(at))
            .map(|(&(at, y), label)| {
                let at = (width * (at - x.0) / (x.1 - x.0), y);
                let lines = wrapped(label, MARK, WIDEST * width);
                let wide = lines.iter().map(|line| text_width(line, MARK)).fold(0.0, f64::max);
                let right = at.0 + GAP;
                let left = if right + wide + GAP > width { (at.0 - GAP - wide).max(GAP) } else { right };
                Flag { at, lines, left, width: wide, row: 0 }
            })
            .collect();
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

    /// Height that the labels take.
    pub fn height(&self) -> f64 {
        if self.rows == 0 { 0.0 } else { ROW * self.rows as f64 + 2.0 * AROUND }
    }

    /// Draws on a panel's inside of this height; `up` is the distance of a value along y from its upper edge.
    pub fn draw(&self, plot: &Canvas, up: impl Fn(f64) -> f64, height: f64) {
        let place = |x: f64, y: f64| (units(x), units(y));
        for Flag { at, row, .. } in &self.flags {
            let line = [place(at.0, AROUND + ROW * *row as f64), place(at.0, height)];
            plot.draw(&PathElement::new(line, stroke(GREY, 0.9))).expect(NEVER);
            plot.draw(&Circle::new(place(at.0, up(at.1)), units(DOT + 0.8), rgb(BLACK).filled())).expect(NEVER);
        }
        for Flag { at, lines, left, width, row } in &self.flags {
            let top = AROUND + ROW * *row as f64;
            let corners = [(left - 2.0, top), (left + width + 1.0, top + ROW * lines.len() as f64)];
            plot.draw(&Rectangle::new(corners.map(|(x, y)| place(x, y)), rgb(WHITE).filled())).expect(NEVER);
            // Next to its line, whatever font it comes out in.
            let (side, x) = if left < &at.0 { (HPos::Right, left + width) } else { (HPos::Left, *left) };
            let style = style(MARK, BLACK).pos(Pos::new(side, VPos::Top));
            for (i, line) in lines.iter().enumerate() {
                plot.draw_text(line, &style, place(x, top + ROW * i as f64 + 0.2 * MARK)).expect(NEVER);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::chart::{Scale, Series};
    use crate::table::{Column, Unit};

    /// Trust: rectangles by hand; labels near each other, at the right edge, and one wider than the panel.
    #[test]
    fn no_label_lies_on_another_or_leaves_the_panel() {
        let axis = Column::new("x", "X", Unit::Mm, vec![]).axis();
        let long = "holder comes to rest on its distance blocks, at a travel that is told in words";
        let flags =
            [(10.0, "rim meets the die"), (10.5, "ironing begins"), (60.0, long), (97.0, "peak"), (99.0, "tears")];
        let series = flags.map(|(x, label)| Series::new(label, vec![(x, 1.0)], Look::Flag)).to_vec();
        let panel = Panel { x: axis.clone(), y: axis, series, scale: Scale::Fit { height: 350.0, least: 0.0 } };
        for width in [250.0, 400.0, 700.0] {
            let Flags { flags, rows } = Flags::of(&panel, (0.0, 100.0), width);
            assert_eq!(flags.len(), 5);
            for (i, a) in flags.iter().enumerate() {
                assert!(a.left >= 0.0 && a.left + a.width <= width && a.row + a.lines.len() <= rows);
                for b in &flags[..i] {
                    let beside = a.left + a.width < b.left || b.left + b.width < a.left;
                    let apart = a.row + a.lines.len() <= b.row || b.row + b.lines.len() <= a.row;
                    assert!(beside || apart, "{:?} and {:?} in {width}", a.lines, b.lines);
                }
            }
        }
    }
}
