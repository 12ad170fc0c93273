//! The section at the start with its dimensions, as a drawing has them.

use super::chart::{BLACK, Chart, Color, GREY, Look, PALE, Series, color};
use super::outline::clipped;
use super::sections::{self, body, flat, panel, place};
use crate::geometry::Point;
use crate::model::Model;
use crate::solver::solution::Frame;
use crate::units::{Amount, joined};
use std::f64::consts::PI;

/// A size of the section, and where it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// What is that large: `Punch`.
    pub of: String,
    /// Which of its sizes it is.
    pub size: Size,
    /// The size as it is told.
    pub amount: Amount,
    /// Where it is drawn.
    pub mark: Mark,
}

/// Sizes that drawings have a sign for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Of a round part: Ø.
    Diameter,
    /// Of a strip, over both halves.
    Width,
    /// Of a rounding: R; so many are alike.
    Radius(usize),
    /// Any other: its name says all.
    Plain,
}

/// How a size is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// Over both halves, of which one is drawn: from beyond the axis to this distance from it \[mm\], below the section.
    Across(f64),
    /// Along z at this distance from the axis, from one z to another \[mm\].
    Along {
        /// Distance from the axis or symmetry plane \[mm\].
        r: f64,
        /// Where the size begins \[mm\].
        from: f64,
        /// Where it ends \[mm\].
        to: f64,
    },
    /// By a leader to this point \[mm\].
    At(Point),
}

/// Room that labels take [px of a picture 800 wide]: a row below the section, a row at its side, a letter.
const ROW: f64 = 34.0;
const LINE: f64 = 30.0;
const LETTER: f64 = 9.2;
/// Width that a panel has for its section and the labels at its side, and its largest height [px].
const PANEL: [f64; 2] = [640.0, 540.0];
/// Length and half width of an arrow's head [px].
const HEAD: [f64; 2] = [9.0, 3.0];
/// Radius of a bead's sign [px], and its chords.
const BEAD: f64 = 7.0;
const RIDGE: usize = 16;
/// Space around the section, over the blank's length.
const AROUND: f64 = 0.05;

const THIN: Look = Look::Line { color: BLACK, width: 1.0, dash: &[] };
/// As far beyond the axis begins the line of a size over both halves [px].
const BEYOND: f64 = 22.0;
/// The axis or symmetry plane, as drawings have it.
const CENTRE: Look = Look::Line { color: BLACK, width: 0.9, dash: &[14.0, 3.5, 2.5, 3.5] };
const EXTENSION: Look = Look::Line { color: GREY, width: 0.8, dash: &[4.0, 3.0] };
const SHEET: Color = (0, 114, 178);

impl Dimension {
    /// In words, for a table: `Punch diameter`.
    pub fn name(&self) -> String {
        let of = self.of.clone();
        match self.size {
            Size::Diameter => format!("{of} diameter"),
            Size::Width => format!("{of} width"),
            Size::Radius(1) => format!("{of} radius"),
            Size::Radius(alike) => format!("{of} radius, {alike} times"),
            Size::Plain => of,
        }
    }

    /// As on a drawing: `Punch Ø 60 mm`.
    fn text(&self) -> String {
        let (of, size) = (self.of.clone(), self.amount);
        match self.size {
            Size::Diameter => format!("{of} Ø {size}"),
            Size::Width => format!("{of} width {size}"),
            Size::Radius(1) => format!("{of} R {size}"),
            Size::Radius(alike) => format!("{of} {alike} × R {size}"),
            Size::Plain => format!("{of} {size}"),
        }
    }
}

/// The sheet and the tools before the first step of a stage with their dimensions; `start` is what a later stage begins
/// with. Widths stand below the section, a row each; heights beside their arrows; all others at the section's side, a row
/// each, in the order in which their leaders do not cross: no label lies on another.
pub fn dimensioned(title: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Chart {
    let text = |dimension: &Dimension| String::from(dimension.text());
    let that = |is: fn(&Mark) -> bool| dimensions.iter().filter(move |d| is(&d.mark));
    let mut across: Vec<_> = that(|mark| matches!(mark, Mark::Across(_))).collect();
    let mut aside: Vec<_> = that(|mark| matches!(mark, Mark::At(_))).collect();
    across.sort_by(|a, b| reach(a).x.total_cmp(&reach(b).x));

    let around = AROUND * model.blank.length;
    let sheet = start.map_or_else(|| flat(model), |frame| sections::sheet(frame, 0..frame.elements.len(), 1.0));
    let of_sheet = || sheet.iter().map(|p| Point::new(p.0, p.1));
    let marked = || aside.iter().map(|d| reach(d)).chain(dimensions.iter().filter_map(lower_end)).chain(of_sheet());
    let width = across.iter().map(|d| reach(d).x).fold(model.blank.length, f64::max) + around;
    let (low, high) = marked().fold((-4.0 * around, 4.0 * around), |(low, high), p| (p.y.min(low), p.y.max(high)));
    let (top, bottom) = (low - around, high + around);
    let letters = aside.iter().map(|d| text(d).chars().count()).max().unwrap_or(0) as f64;
    let beside = LETTER * letters + 40.0;
    // mm per px, whichever direction has less room.
    let below = ROW * across.len() as f64;
    let px = (width / (PANEL[0] - beside - BEYOND)).max((bottom - top) / (PANEL[1] - below));
    // The labels at the side may need more height than the section.
    let short = (LINE * px * (1.0 + aside.len() as f64) - (bottom - top)).max(0.0);
    let (top, bottom) = (top - 0.5 * short, bottom + 0.5 * short);

    let mut series: Vec<Series> = Vec::new();
    for (i, tool) in model.tools.iter().enumerate() {
        let moved = start.map_or_else(Point::zeros, |frame| place(frame, i));
        let whole = body(tool.role, &tool.profile, moved, 1e-4 * width);
        let look = Look::Area { fill: PALE, edge: Some(GREY) };
        series.push(Series::silent(clipped(&whole, (0.0, width), (top, bottom)), look));
    }
    series.push(Series::silent(sheet.clone(), Look::Area { fill: SHEET, edge: Some(color(0)) }));
    for bead in &model.beads {
        series.push(Series::silent(
            ridge(bead.at, -0.5 * model.blank.thickness, BEAD * px),
            Look::Area { fill: BLACK, edge: None },
        ));
    }
    series.push(Series::silent(vec![(0.0, top), (0.0, bottom + px * below)], CENTRE));
    for (i, dimension) in across.iter().enumerate() {
        let (x, z) = (reach(dimension).x, bottom + px * ROW * (i as f64 + 0.8));
        series.push(Series::silent(vec![(x, 0.0), (x, z + 4.0 * px)], EXTENSION));
        series.extend(arrow([(-BEYOND * px, z), (x, z)], px));
    }
    // Labels after all lines: they lie on white.
    for (i, dimension) in across.iter().enumerate() {
        let z = bottom + px * ROW * (i as f64 + 0.8);
        series.push(Series::new(text(dimension), vec![(14.0 * px, z - 12.0 * px)], Look::Text));
    }
    let step = (bottom - top) / (1.0 + aside.len() as f64);
    let side = |i: usize| Point::new(width + 20.0 * px, top + step * (i as f64 + 1.0));
    untangle(&mut aside, side);
    for (i, dimension) in aside.iter().enumerate() {
        let (from, at) = (reach(dimension), (side(i).x, side(i).y));
        series.push(Series::silent(vec![(from.x, from.y), (at.0 - 4.0 * px, at.1)], THIN));
        series.push(Series::new(text(dimension), vec![at], Look::Text));
    }
    for dimension in dimensions {
        if let Mark::Along { r, from, to } = dimension.mark {
            series.extend(arrow([(r, from), (r, to)], px));
            // Beside a short arrow the label would lie on the sheet.
            let middle = from + (0.5 * (to - from).abs()).max(0.5 * LINE * px).copysign(to - from);
            series.push(Series::new(text(dimension), vec![(r + 8.0 * px, middle)], Look::Text));
        }
    }
    let chart = Chart {
        title,
        legend: String::new(),
        panels: vec![panel(model.geometry, series, [(-BEYOND * px, width + beside * px), (top, bottom + px * below)])],
        notes: vec![String::from(legend(model, start))],
    };
    chart.displayed()
}

/// What the colours mean.
fn legend(model: &Model, start: Option<&Frame>) -> String {
    let sheet = match start {
        Some(_) => "Blue: the sheet that the stage begins with. Grey: the tools.",
        None => "Blue: the blank. Grey: the tools, where they touch the flat sheet.",
    };
    let beads = if model.beads.is_empty() { "" } else { "Black: draw beads, lines that hold the sheet back." };
    joined([sheet, beads].map(String::from), " ")
}

/// Puts labels, whose leaders end at `side` of their number, in an order in which no two leaders cross: two that do change
/// places, which makes both together shorter, so that this ends.
fn untangle(labels: &mut [&Dimension], side: impl Fn(usize) -> Point) {
    labels.sort_by(|a, b| reach(a).y.total_cmp(&reach(b).y));
    let crossed = |labels: &[&Dimension]| {
        let pairs = (0..labels.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
        pairs.into_iter().find(|&(j, i)| cross([reach(labels[j]), side(j)], [reach(labels[i]), side(i)]))
    };
    while let Some((j, i)) = crossed(labels) {
        labels.swap(j, i);
    }
}

/// Whether two lines cross inside of both.
fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let side = |[from, to]: [Point; 2], p: Point| (to - from).perp(&(p - from));
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}

/// A half circle that stands on a face of the sheet, as a bead does.
fn ridge(at: f64, face: f64, radius: f64) -> Vec<(f64, f64)> {
    let point = |i: usize| {
        let (sin, cos) = (PI * i as f64 / RIDGE as f64).sin_cos();
        (at + radius * cos, face - radius * sin)
    };
    (0..=RIDGE).map(point).collect()
}

/// The point that a dimension leads to.
fn reach(dimension: &Dimension) -> Point {
    match dimension.mark {
        Mark::Across(r) => Point::new(r, 0.0),
        Mark::Along { r, from, to } => Point::new(r, 0.5 * (from + to)),
        Mark::At(point) => point,
    }
}

/// The far end of a line along z.
fn lower_end(dimension: &Dimension) -> Option<Point> {
    match dimension.mark {
        Mark::Along { r, to, .. } => Some(Point::new(r, to)),
        _ => None,
    }
}

/// A line with a head at its end, `px` mm per px.
fn arrow([from, to]: [(f64, f64); 2], px: f64) -> [Series; 2] {
    let (a, b) = (Point::new(from.0, from.1), Point::new(to.0, to.1));
    let along = (b - a).try_normalize(0.0).unwrap_or_default();
    let (back, side) = (b - HEAD[0] * px * along, HEAD[1] * px * Point::new(-along.y, along.x));
    let head = [b, back + side, back - side].map(|p| (p.x, p.y)).to_vec();
    [Series::silent(vec![from, to], THIN), Series::silent(head, Look::Area { fill: BLACK, edge: None })]
}
