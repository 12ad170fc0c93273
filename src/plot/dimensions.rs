//! Section at the start with its dimensions, as on a drawing.

use super::chart::{Annotation, AnnotationKind, Chart, Series, Style, bounds};
use super::palette::{BLACK, GREY, color};
use super::sections::{flat, panel, tools, whole_sheet};
use crate::geometry::Point;
use crate::model::Model;
use crate::solver::solution::Frame;
use crate::units::Amount;
use std::f64::consts::PI;

/// Size of the section, and its place in the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// Name in a table: `Punch diameter`.
    pub name: String,
    /// Text on a drawing: `Punch Ø 60 mm`.
    pub text: String,
    /// Value.
    pub amount: Amount,
    /// Place in the drawing.
    pub mark: Mark,
}

/// Place of a dimension \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// Line below the section over both halves, up to this distance from the axis.
    Across(f64),
    /// Vertical line.
    Along {
        /// Distance from the axis.
        r: f64,
        /// Start.
        from: f64,
        /// End, with the arrow head.
        to: f64,
    },
    /// Leader from this point to a text beside the section.
    At(Point),
}

/// Height of a row below the section and beside it, and mean width of a letter \[px\].
const ROW: f64 = 34.0;
const LINE: f64 = 30.0;
const LETTER: f64 = 9.2;
/// Width of a panel for section and texts, and its largest height \[px\].
const PANEL: [f64; 2] = [640.0, 540.0];
/// Length and half width of an arrow head \[px\].
const HEAD: [f64; 2] = [9.0, 3.0];
/// Radius of a draw bead's sign \[px\], and its number of chords.
const BEAD: f64 = 7.0;
const CHORDS: usize = 16;
/// Space around the section over the blank's length, and beyond the axis \[px\].
const AROUND: f64 = 0.05;
const BEYOND: f64 = 22.0;

const THIN: Style = Style::Line { color: BLACK, width: 1.0, dash: &[] };
const CENTRE: Style = Style::Line { color: BLACK, width: 0.9, dash: &[14.0, 3.5, 2.5, 3.5] };
const EXTENSION: Style = Style::Line { color: GREY, width: 0.8, dash: &[4.0, 3.0] };

/// Sheet and tools before the first step of a stage with dimensions; `start` is the sheet that a later stage begins with.
/// No text lies on another: widths have a row each below the section, texts at its side a row each.
pub fn dimensioned(title: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Chart {
    let mut across: Vec<(f64, String)> = Vec::new();
    let mut beside: Vec<(Point, String)> = Vec::new();
    let mut along: Vec<([f64; 3], String)> = Vec::new();
    for dimension in dimensions {
        match dimension.mark {
            Mark::Across(r) => across.push((r, dimension.text.clone())),
            Mark::At(point) => beside.push((point, dimension.text.clone())),
            Mark::Along { r, from, to } => along.push(([r, from, to], dimension.text.clone())),
        }
    }
    across.sort_by(|a, b| a.0.total_cmp(&b.0));

    let around = AROUND * model.blank.length;
    let sheet = start.map_or_else(|| flat(model), |frame| whole_sheet(frame, 1.0));
    let heights = beside.iter().map(|b| b.0.y).chain(along.iter().map(|a| a.0[2])).chain(sheet.iter().map(|p| p.1));
    let (low, high) = bounds(heights.chain([-4.0 * around, 4.0 * around]));
    let (top, bottom) = (low - around, high + around);
    let width = bounds(across.iter().map(|a| a.0).chain([model.blank.length])).1 + around;
    let text_width = LETTER * beside.iter().map(|b| b.1.chars().count()).max().unwrap_or(0) as f64 + 40.0;
    let below = ROW * across.len() as f64;
    // Length of a px, by the direction with less room.
    let px = (width / (PANEL[0] - text_width - BEYOND)).max((bottom - top) / (PANEL[1] - below));
    // Texts at the side may need more height than the section.
    let short = (LINE * px * (1.0 + beside.len() as f64) - (bottom - top)).max(0.0);
    let (top, bottom) = (top - 0.5 * short, bottom + 0.5 * short);

    let mut series = tools(model, start, width);
    series.push(Series::silent(sheet, Style::area(color(0))));
    let face = -0.5 * model.blank.thickness;
    series.extend(model.beads.iter().map(|bead| Series::silent(ridge(bead.at, face, BEAD * px), Style::area(BLACK))));
    series.push(Series::silent(vec![(0.0, top), (0.0, bottom + px * below)], CENTRE));
    let mut texts = Vec::new();
    let mut text = |text: &String, at| texts.push(Annotation::new(AnnotationKind::Start, text.clone(), at));
    for (i, (x, label)) in across.iter().enumerate() {
        let z = bottom + px * ROW * (i as f64 + 0.8);
        series.push(Series::silent(vec![(*x, 0.0), (*x, z + 4.0 * px)], EXTENSION));
        series.extend(arrow([(-BEYOND * px, z), (*x, z)], px));
        text(label, (14.0 * px, z - 12.0 * px));
    }
    let step = (bottom - top) / (1.0 + beside.len() as f64);
    let side = |i: usize| Point::new(width + 20.0 * px, top + step * (i as f64 + 1.0));
    untangle(&mut beside, side);
    for (i, (from, label)) in beside.iter().enumerate() {
        series.push(Series::silent(vec![(from.x, from.y), (side(i).x - 4.0 * px, side(i).y)], THIN));
        text(label, (side(i).x, side(i).y));
    }
    for ([r, from, to], label) in &along {
        series.extend(arrow([(*r, *from), (*r, *to)], px));
        // Beside a short arrow the text would lie on the sheet.
        let middle = from + (0.5 * (to - from).abs()).max(0.5 * LINE * px).copysign(to - from);
        text(label, (r + 8.0 * px, middle));
    }
    let window = [(-BEYOND * px, width + text_width * px), (top, bottom + px * below)];
    let mut note = match start {
        Some(_) => "Blue: the sheet that the stage begins with. Grey: the tools.".to_owned(),
        None => "Blue: the blank. Grey: the tools, where they touch the flat sheet.".to_owned(),
    };
    if !model.beads.is_empty() {
        note += " Black: draw beads, lines that hold the sheet back.";
    }
    let panel = panel(model.geometry, window).with(series).annotated(texts);
    Chart::new(title, vec![panel], vec![note])
}

/// Orders texts so that no two leaders, which end at `side` of their number, cross; each swap shortens both together.
fn untangle(texts: &mut [(Point, String)], side: impl Fn(usize) -> Point) {
    texts.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    let left_of = |[from, to]: [Point; 2], p: Point| (to - from).perp(&(p - from));
    let cross = |a: [Point; 2], b: [Point; 2]| {
        left_of(a, b[0]) * left_of(a, b[1]) < 0.0 && left_of(b, a[0]) * left_of(b, a[1]) < 0.0
    };
    let crossed = |texts: &[(Point, String)]| {
        let mut pairs = (0..texts.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
        pairs.find(|&(j, i)| cross([texts[j].0, side(j)], [texts[i].0, side(i)]))
    };
    while let Some((j, i)) = crossed(texts) {
        texts.swap(j, i);
    }
}

fn ridge(at: f64, face: f64, radius: f64) -> Vec<(f64, f64)> {
    let point = |i: usize| {
        let (sin, cos) = (PI * i as f64 / CHORDS as f64).sin_cos();
        (at + radius * cos, face - radius * sin)
    };
    (0..=CHORDS).map(point).collect()
}

/// Line with a head at its end; `px` is the length of a px \[mm\].
fn arrow([from, to]: [(f64, f64); 2], px: f64) -> [Series; 2] {
    let (a, b) = (Point::new(from.0, from.1), Point::new(to.0, to.1));
    let along = (b - a).try_normalize(0.0).unwrap_or_default();
    let (back, side) = (b - HEAD[0] * px * along, HEAD[1] * px * Point::new(-along.y, along.x));
    let head = [b, back + side, back - side].map(|p| (p.x, p.y)).to_vec();
    [Series::silent(vec![from, to], THIN), Series::silent(head, Style::area(BLACK))]
}
