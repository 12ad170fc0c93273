//! Outlines of sheet and tools in a section.

use super::{palette::PALE, *};
use crate::bead::shapes;
use crate::geometry::on_axis;
use crate::plot::fields::element::{R, Z};
use crate::solver::solution::NodeRecord;
use std::ops::Range;

/// Largest angle of a chord of an arc \[rad\], and its largest distance from the arc over the picture's width.
const CHORD: f64 = 0.03;
pub(super) const SAGITTA: f64 = 1e-4;
const OUTLINED: usize = 200;
const AROUND: f64 = 0.06;
/// Outline of a tool far from the sheet \[mm\].
const FAR: f64 = 1e3;
const BEAD: [(Role, Color); 2] = [(Role::Die, WHITE), (Role::Holder, PALE)];
pub(super) const TOOL: Style = Style::Area { fill: PALE, edge: Some(GREY) };

/// Panel of the r-z plane that shows at least this window \[mm\].
pub(crate) fn panel(geometry: Geometry, [x, y]: [(f64, f64); 2]) -> Panel {
    let extent = Extent::of(geometry, None);
    Panel::new(R.axis(extent), Z.axis(extent), Scale::Section { x, y })
}

/// Window around some nodes, at least as wide as `length` \[mm\].
pub(crate) fn window<'a>(nodes: impl Iterator<Item = &'a NodeRecord>, length: f64) -> [(f64, f64); 2] {
    let least = (length, 0.0_f64, 0.0_f64);
    let (width, top, bottom) = nodes.fold(least, |(r, top, bottom), n| (r.max(n.r), top.min(n.z), bottom.max(n.z)));
    let around = AROUND * width;
    [(0.0, width + around), (top - 2.0 * around, bottom + around)]
}

/// Window around the whole section on both sides of the middle \[mm\].
pub(crate) fn whole_window(frame: &Frame) -> [(f64, f64); 2] {
    let width = bounds(frame.nodes.iter().map(|node| node.r)).1 * (1.0 + AROUND);
    let (top, bottom) = bounds(frame.nodes.iter().map(|node| node.z));
    [(-width, width), (top - 2.0 * AROUND * width, bottom + AROUND * width)]
}

/// Tool bodies as they stand in a frame, or in the model without one; `width` is that of the picture \[mm\].
pub(crate) fn tools(model: &Model, at: Option<&Frame>, width: f64) -> impl Iterator<Item = Series> {
    let moved = move |i: usize| at.map_or_else(Point::default, |frame| tool_displacement(frame, i));
    let bodies = model.tools.iter().enumerate().map(move |(i, tool)| {
        let outline = body(tool.role, &tool.profile, moved(i), SAGITTA * width);
        Series::silent(outline, TOOL)
    });
    let beads = shapes(model).flat_map(|beads| BEAD.into_iter().zip(beads)).map(move |((role, fill), shape)| {
        let moved = model.tool_index(role).map_or_else(Point::default, moved);
        Series::silent(outline(&shape, moved, SAGITTA * width), Style::Area { fill, edge: Some(GREY) })
    });
    bodies.chain(beads)
}

pub(super) fn mirrored(mut outline: Vec<(f64, f64)>) -> Vec<Vec<(f64, f64)>> {
    let n = outline.len();
    let in_the_middle = |i: usize| on_axis(&Point::new(outline[i % n].0, 0.0));
    let seam = (0..n).find(|&i| in_the_middle(i) && in_the_middle(i + 1));
    outline.rotate_left(seam.map_or(0, |i| (i + 1) % n));
    let image = outline.iter().rev().map(|p| (-p.0, p.1)).collect();
    if seam.is_some() { vec![[outline, image].concat()] } else { vec![outline, image] }
}

/// Displacement of tool `i` since the model's start \[mm\].
pub(crate) fn tool_displacement(frame: &Frame, i: usize) -> Point {
    frame.tool_displacement.get(i).copied().unwrap_or_default()
}

/// Moved profile as chords at most `sagitta` from its arcs \[mm\].
pub(crate) fn outline(profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
    let chords = |piece: &Piece| match piece {
        Piece::Arc(arc) => (arc.sweep.abs() / CHORD.min((8.0 * sagitta / arc.radius).sqrt())).ceil().max(1.0) as usize,
        Piece::Segment(_) => 1,
    };
    let points = profile.pieces().iter().flat_map(|piece| piece.sample(chords(piece)));
    points.map(|p| (p.x + moved.x, p.y + moved.y)).collect()
}

pub(crate) fn body(role: Role, profile: &Profile, moved: Point, sagitta: f64) -> Vec<(f64, f64)> {
    let mut outline = outline(profile, moved, sagitta);
    let (first, last) = (outline[0], outline[outline.len() - 1]);
    let (low, high) = bounds(outline.iter().map(|p| p.1));
    let far = if role.side() > 0.0 { high + FAR } else { low - FAR };
    // The tool is on the right of its profile: around a tube it goes on outward, not along the axis.
    let around = first.0.max(last.0) + FAR;
    let is_around = role.side() * (last.0 - first.0) > 0.0 && last.1 > first.1;
    outline.extend(if is_around { [(around, last.1), (around, first.1)] } else { [(last.0, far), (first.0, far)] });
    outline
}

pub(crate) fn flat(model: &Model) -> Vec<(f64, f64)> {
    let (blank, half) = (&model.blank, 0.5 * model.blank.thickness);
    let is_bent = |meridian: &Profile| !matches!(meridian.pieces(), [Piece::Segment(_)]);
    let along = |side: f64| {
        let [from, to] = blank.ends();
        let count = if blank.meridian.as_ref().is_some_and(is_bent) { OUTLINED } else { 1 };
        (0..=count).map(move |i| {
            let [r, z, slope] = blank.node(from + (to - from) * i as f64 / count as f64);
            (r - side * slope.sin(), z + side * slope.cos())
        })
    };
    along(half).chain(along(-half).rev()).collect()
}

pub(crate) fn sheet(frame: &Frame, elements: Range<usize>, times: f64) -> Vec<(f64, f64)> {
    let part = elements.start..(elements.end + 1).min(frame.nodes.len());
    part.clone().map(|i| surface(frame, i, times)).chain(part.rev().map(|i| surface(frame, i, -times))).collect()
}

pub(crate) fn whole_sheet(frame: &Frame, times: f64) -> Vec<(f64, f64)> {
    sheet(frame, 0..frame.elements.len(), times)
}

/// Point at node `i` half a thickness along the normal, on the die's side (+1) or the punch's (−1).
pub(crate) fn surface(frame: &Frame, i: usize, side: f64) -> (f64, f64) {
    let nodes = &frame.nodes;
    let at = |n: &NodeRecord| Point::new(n.r, n.z);
    let after = at(&nodes[(i + 1).min(nodes.len() - 1)]);
    // On the axis the sheet continues as its own mirror image.
    let before = if nodes[i].r == 0.0 { Point::new(-after.x, after.y) } else { at(&nodes[i.saturating_sub(1)]) };
    let along = (after - before).try_normalize(0.0).unwrap_or(Point::new(1.0, 0.0));
    let p = at(&nodes[i]) + 0.5 * side * nodes[i].thickness * Point::new(-along.y, along.x);
    (p.x, p.y)
}
