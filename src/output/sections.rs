//! The section of the sheet, true to thickness, at the kept frames, and the tools where the run ended.

use super::StageView;
use super::chart::{Chart, Color, GREY, Look, PALE, Panel, Scale, Series, color, pale};
use crate::geometry::{Piece, Point, Profile};
use crate::model::{Extent, Geometry, Model, Role, Theory};
use crate::solution::{Frame, NodeRecord};
use crate::table::fields::element::{R, Z};
use std::ops::Range;

/// Arcs are drawn with chords of at most this many radians, and that leave the arc by at most this share of the width.
const CHORD: f64 = 0.03;
const SAGITTA: f64 = 1e-4;
/// What is shown around the sheet, over the section's width.
const AROUND: f64 = 0.06;

pub(super) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frames) = (view.model(), &view.stage.frames);
    let [x, y] = window(frames.iter().flat_map(|f| &f.nodes), model.blank.length);
    let last = frames.last();
    let selective = model.blank.theory == Theory::Selective;
    let sheets = view.shown().enumerate().flat_map(|(i, frame)| {
        let whole = Series::new(view.reached(frame), sheet(frame, 0..frame.elements.len()), filled(color(i)));
        let membranes = if selective { membranes(frame) } else { Vec::new() };
        let paler = membranes.into_iter().map(move |part| Series::silent(sheet(frame, part), filled(pale(color(i)))));
        std::iter::once(whole).chain(paler)
    });
    // A run that never started shows where it would have.
    let flat = last.is_none().then(|| Series::new("0 mm", flat(model), filled(color(0))));
    let tools_at = if last.is_some() { "the end" } else { "the start" };
    Some(Chart {
        title: view.titled("sections"),
        legend: view.progress(),
        panels: vec![panel(model.geometry, tools(model, last, x.1).chain(sheets).chain(flat), [x, y])],
        notes: std::iter::once(format!("The sheet is true to thickness. Grey: the tools at {tools_at}."))
            .chain(selective.then(|| "Pale: elements that were membranes; the others bent.".to_owned()))
            .chain(view.notes_of_frames())
            .collect(),
    })
}

/// A section's plane, at least this window of it \[mm\].
pub(super) fn panel(geometry: Geometry, series: impl IntoIterator<Item = Series>, [x, y]: [(f64, f64); 2]) -> Panel {
    let series = series.into_iter().collect();
    // Lengths are the same over any depth.
    let extent = Extent::of(geometry, None);
    Panel { x: R.axis(extent), y: Z.axis(extent), series, scale: Scale::Section { x, y } }
}

/// What is shown of a section: its nodes, or as much as a blank of this length, and something around them.
pub(super) fn window<'a>(nodes: impl Iterator<Item = &'a NodeRecord>, length: f64) -> [(f64, f64); 2] {
    let (width, top, bottom) = nodes
        .fold((length, 0.0_f64, 0.0_f64), |(width, top, bottom), n| (width.max(n.r), top.min(n.z), bottom.max(n.z)));
    let around = AROUND * width;
    [(0.0, width + around), (top - 2.0 * around, bottom + around)]
}

/// The tools' bodies where they stand in a frame, or are drawn in the model without one, in a picture of this width \[mm\].
pub(super) fn tools<'a>(model: &'a Model, at: Option<&'a Frame>, width: f64) -> impl Iterator<Item = Series> + 'a {
    model.tools.iter().enumerate().map(move |(i, tool)| {
        let moved = at.map_or_else(Point::default, |frame| place(frame, i));
        let body = body(tool.role, &tool.profile, moved, SAGITTA * width);
        Series::silent(body, Look::Area { fill: PALE, edge: Some(GREY) })
    })
}

/// How far tool `i` has moved from where it is drawn in the model \[mm\].
pub(super) fn place(frame: &Frame, i: usize) -> Point {
    frame.tool_displacement.get(i).copied().unwrap_or_default()
}

/// The tool's profile, moved, as chords that leave its arcs by at most `sagitta` \[mm\].
pub(super) fn outline(profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
    let points = profile.pieces().iter().flat_map(|piece| piece.sample(chords(piece, sagitta)));
    points.map(|p| (p.x + moved.x, p.y + moved.y)).collect()
}

/// The tool's profile closed through its body, which goes on away from the sheet.
pub(super) fn body(role: Role, profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
    let mut outline = outline(profile, moved, sagitta);
    let (first, last) = (outline[0], outline[outline.len() - 1]);
    let ends = outline.iter().map(|p| p.1);
    let far = match role {
        Role::Punch | Role::Holder => ends.fold(f64::INFINITY, f64::min) - 1e3,
        Role::Die => ends.fold(f64::NEG_INFINITY, f64::max) + 1e3,
    };
    outline.extend([(last.0, far), (first.0, far)]);
    outline
}

/// Into how many chords a piece is cut: a chord over the angle φ leaves its arc by R φ²/8.
fn chords(piece: &Piece, sagitta: f64) -> usize {
    let Piece::Arc(arc) = piece else { return 1 };
    let chord = CHORD.min((8.0 * sagitta / arc.radius).sqrt());
    (arc.sweep.abs() / chord).ceil().max(1.0) as usize
}

/// The sheet before forming.
pub(super) fn flat(model: &Model) -> Vec<(f64, f64)> {
    let (length, half) = (model.blank.length, 0.5 * model.blank.thickness);
    vec![(0.0, half), (length, half), (length, -half), (0.0, -half)]
}

fn filled(fill: Color) -> Look {
    Look::Area { fill, edge: None }
}

/// Stretches of the sheet whose elements are membranes.
fn membranes(frame: &Frame) -> Vec<Range<usize>> {
    let mut from = 0;
    let alike = frame.elements.chunk_by(|a, b| a.bends == b.bends);
    let stretches = alike.map(|stretch| {
        let elements = from..from + stretch.len();
        from = elements.end;
        (stretch[0].bends, elements)
    });
    stretches.filter(|(bends, _)| !bends).map(|(_, elements)| elements).collect()
}

/// Both surfaces of some elements of the sheet.
pub(super) fn sheet(frame: &Frame, elements: Range<usize>) -> Vec<(f64, f64)> {
    let part = elements.start..(elements.end + 1).min(frame.nodes.len());
    part.clone().map(|i| surface(frame, i, 1.0)).chain(part.rev().map(|i| surface(frame, i, -1.0))).collect()
}

/// A surface of the sheet at node `i`: half a thickness from the mid-surface along its normal, on the die's side (+1) or
/// the punch's (−1). On the axis or the symmetry plane the sheet goes on as its own mirror image.
pub(super) fn surface(frame: &Frame, i: usize, side: f64) -> (f64, f64) {
    let nodes = &frame.nodes;
    let at = |n: &NodeRecord| Point::new(n.r, n.z);
    let after = at(&nodes[(i + 1).min(nodes.len() - 1)]);
    let before = if nodes[i].r == 0.0 { Point::new(-after.x, after.y) } else { at(&nodes[i.saturating_sub(1)]) };
    let along = (after - before).try_normalize(0.0).unwrap_or(Point::new(1.0, 0.0));
    let half = 0.5 * side * nodes[i].thickness;
    let p = at(&nodes[i]) + half * Point::new(-along.y, along.x);
    (p.x, p.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::ThroughThickness;

    /// Trust: a crown of R 2800 mm over 330 mm, its points compared with the circle half-way between them.
    #[test]
    fn large_radii_are_drawn_smoothly() {
        let crown = crate::geometry::Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8);
        let outline = body(Role::Punch, &crown, Point::zeros(), 0.042);
        for pair in outline.windows(2).filter(|pair| pair[1].0 < 300.0 && pair[1].1 > -100.0) {
            let middle = Point::new(0.5 * (pair[0].0 + pair[1].0), 0.5 * (pair[0].1 + pair[1].1));
            assert!(crown.closest(middle).distance.abs() < 0.0421, "{middle}");
        }
    }

    #[test]
    fn a_flat_sheet_is_a_rectangle_of_its_thickness() {
        let node = |r| NodeRecord { r, z: 3.0, theta: 0.0, thickness: 0.8 };
        let frame = Frame {
            time: 0.0,
            travel: 0.0,
            elements: vec![],
            nodes: vec![node(0.0), node(5.0)],
            through: ThroughThickness::default(),
            tool_displacement: vec![],
        };
        assert_eq!(sheet(&frame, 0..1), [(0.0, 3.4), (5.0, 3.4), (5.0, 2.6), (0.0, 2.6)]);
    }
}
