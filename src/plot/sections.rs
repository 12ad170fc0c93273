//! The sections of sheet and tools, as outlines that pictures are made of.

use super::chart::{GREY, Look, PALE, Panel, Scale, Series};
use crate::geometry::{Piece, Point, Profile, on_axis};
use crate::model::{Extent, Geometry, Model, Role};
use crate::solver::solution::{Frame, NodeRecord};
use crate::table::fields::element::{R, Z};
use std::ops::Range;

/// Arcs are drawn with chords of at most this many radians, and that leave the arc by at most this share of the width.
const CHORD: f64 = 0.03;
const SAGITTA: f64 = 1e-4;
/// What is shown around the sheet, over the section's width.
const AROUND: f64 = 0.06;

/// A section's plane, at least this window of it \[mm\].
pub(crate) fn panel(geometry: Geometry, series: impl IntoIterator<Item = Series>, [x, y]: [(f64, f64); 2]) -> Panel {
    let series = series.into_iter().collect();
    // Lengths are the same over any depth.
    let extent = Extent::of(geometry, None);
    Panel { x: R.axis(extent), y: Z.axis(extent), series, scale: Scale::Section { x, y } }
}

/// What is shown of a section: its nodes, or as much as a blank of this length, and something around them.
pub(crate) fn window<'a>(nodes: impl Iterator<Item = &'a NodeRecord>, length: f64) -> [(f64, f64); 2] {
    let (width, top, bottom) = nodes
        .fold((length, 0.0_f64, 0.0_f64), |(width, top, bottom), n| (width.max(n.r), top.min(n.z), bottom.max(n.z)));
    let around = AROUND * width;
    [(0.0, width + around), (top - 2.0 * around, bottom + around)]
}

/// The tools' bodies where they stand in a frame, or are drawn in the model without one, in a picture of this width \[mm\].
pub(crate) fn tools<'a>(model: &'a Model, at: Option<&'a Frame>, width: f64) -> impl Iterator<Item = Series> + 'a {
    model.tools.iter().enumerate().map(move |(i, tool)| {
        let moved = at.map_or_else(Point::default, |frame| place(frame, i));
        let body = body(tool.role, &tool.profile, moved, SAGITTA * width);
        Series::silent(body, Look::Area { fill: PALE, edge: Some(GREY) })
    })
}

/// The same with their mirror images beyond the middle.
pub(crate) fn whole_tools<'a>(model: &'a Model, at: &'a Frame, width: f64) -> impl Iterator<Item = Series> + 'a {
    model.tools.iter().enumerate().flat_map(move |(i, tool)| {
        let body = body(tool.role, &tool.profile, place(at, i), SAGITTA * width);
        let look = Look::Area { fill: PALE, edge: Some(GREY) };
        mirrored(body).into_iter().map(move |body| Series::silent(body, look))
    })
}

/// An outline and its mirror image beyond the middle: one outline where it has an edge there.
pub(crate) fn mirrored(mut outline: Vec<(f64, f64)>) -> Vec<Vec<(f64, f64)>> {
    let n = outline.len();
    let in_the_middle = |i: usize| on_axis(&Point::new(outline[i % n].0, 0.0));
    let seam = (0..n).find(|&i| in_the_middle(i) && in_the_middle(i + 1));
    outline.rotate_left(seam.map_or(0, |i| (i + 1) % n));
    let image = outline.iter().rev().map(|p| (-p.0, p.1)).collect();
    match seam {
        Some(_) => vec![[outline, image].concat()],
        None => vec![outline, image],
    }
}

/// How far tool `i` has moved from where it is drawn in the model \[mm\].
pub(crate) fn place(frame: &Frame, i: usize) -> Point {
    frame.tool_displacement.get(i).copied().unwrap_or_default()
}

/// The tool's profile, moved, as chords that leave its arcs by at most `sagitta` \[mm\].
pub(crate) fn outline(profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
    let points = profile.pieces().iter().flat_map(|piece| piece.sample(chords(piece, sagitta)));
    points.map(|p| (p.x + moved.x, p.y + moved.y)).collect()
}

/// The tool's profile closed through its body, which goes on away from the sheet.
pub(crate) fn body(role: Role, profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
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
pub(crate) fn flat(model: &Model) -> Vec<(f64, f64)> {
    let (length, half) = (model.blank.length, 0.5 * model.blank.thickness);
    vec![(0.0, half), (length, half), (length, -half), (0.0, -half)]
}

/// Both surfaces of some elements of the sheet, so many `times` as far apart as they are.
pub(crate) fn sheet(frame: &Frame, elements: Range<usize>, times: f64) -> Vec<(f64, f64)> {
    let part = elements.start..(elements.end + 1).min(frame.nodes.len());
    part.clone().map(|i| surface(frame, i, times)).chain(part.rev().map(|i| surface(frame, i, -times))).collect()
}

/// A surface of the sheet at node `i`: half a thickness from the mid-surface along its normal, on the die's side (+1) or
/// the punch's (−1). On the axis or the symmetry plane the sheet goes on as its own mirror image.
pub(crate) fn surface(frame: &Frame, i: usize, side: f64) -> (f64, f64) {
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
    use crate::solver::solution::ThroughThickness;

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
        assert_eq!(sheet(&frame, 0..1, 1.0), [(0.0, 3.4), (5.0, 3.4), (5.0, 2.6), (0.0, 2.6)]);
    }
    /// Trust: by hand: a rectangle at the middle becomes one of twice the width, one beside it stays two.
    #[test]
    fn what_lies_on_the_middle_is_one_with_its_image() {
        for start in 0..4 {
            let mut rectangle = vec![(0.0, 0.0), (0.0, 1.0), (3.0, 1.0), (3.0, 0.0)];
            rectangle.rotate_left(start);
            let [whole] = &mirrored(rectangle)[..] else { panic!("one outline") };
            let area = whole.iter().zip(whole.iter().cycle().skip(1)).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>();
            assert_eq!((whole.len(), area.abs()), (8, 12.0), "from corner {start}");
        }
        assert_eq!(mirrored(vec![(1.0, 0.0), (2.0, 1.0), (2.0, 0.0)]).len(), 2);
    }
}
