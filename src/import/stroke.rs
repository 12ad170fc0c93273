//! Entities as strokes: pieces in mm, x from the axis, in the drawing's sense of y.

use super::dxf::{MOST, Place};
use super::layers::{Layers, ToolId, exported, list};
use super::{ImportError, Result, blocks::Placed, chain::Chain, ensure, frame::Frame, options::Options, spline};
use crate::geometry::{Bounds, Piece, Point};
use crate::units::{Dimensioned, Length, rounded};
use std::{collections::BTreeMap, f64::consts::PI, f64::consts::TAU, fmt};

const ANNOTATIONS: &str = "TEXT MTEXT DIMENSION ARC_DIMENSION LEADER MULTILEADER TOLERANCE HATCH POINT ATTDEF XLINE RAY VIEWPORT \
                           IMAGE WIPEOUT";

/// Largest distance of coinciding points \[mm\].
const SHORTEST: f64 = 1e-7;
/// Largest thickness of a drawn blank over its edge's distance from the axis \[–\].
const THIN: f64 = 0.25;
/// Least height of a tube over its wall \[–\]: shorter ones are no shells.
const UPRIGHT: f64 = 5.0;
/// Largest bulge of a straight line \[–\].
const STRAIGHT: f64 = 1e-10;
const CLOSED: i64 = 1;
const MESH: i64 = 16 | 64;
const OFF_THE_CURVE: i64 = 16;

pub(super) fn strokes(entities: &[Placed], layers: &Layers, tool: ToolId, frame: &Frame) -> Result<Vec<Chain>> {
    let is_ours = |placed: &&Placed| !placed.source.on_paper && layers.get(&placed.source.layer) == Some(&tool);
    let (curves, others): (Vec<&Placed>, Vec<&Placed>) =
        entities.iter().filter(is_ours).partition(|placed| placed.entity.is_curve());
    let mut annotations: BTreeMap<&str, usize> = BTreeMap::new();
    for Placed { source, .. } in others {
        if !ANNOTATIONS.split(' ').any(|kind| kind == source.kind) {
            let help = match source.kind == "INSERT" {
                true => "its block is in another file, or lies across the drawing's plane: bind or explode it",
                false => "redraw or explode it to lines, arcs and polylines, or move it to another layer",
            };
            let place = frame.place(frame.point(source.at));
            return Err(source.error(format!("{source} at {place} cannot be part of the {tool}'s profile"), help));
        }
        *annotations.entry(&source.kind).or_default() += 1;
    }
    if !annotations.is_empty() {
        let annotations = annotations.iter().map(|(kind, count)| format!("{count} {kind}"));
        frame.note(format!("left out of the {tool}'s layer: {}", list(annotations)));
    }
    let splines = curves.iter().filter(|placed| placed.source.kind == "SPLINE").count();
    if splines > 0 {
        let within = format!("within {} mm", rounded(frame.tolerance));
        frame.note(format!("SPLINE in the {tool}'s line ({splines}) is followed by tangent arcs {within}"));
    }
    let (mut strokes, mut count) = (Vec::new(), 0);
    for placed in curves {
        let (source, pieces) = (&placed.source, Pen { placed, frame }.pieces()?);
        count += pieces.len();
        let what = || format!("the {tool} is drawn in more than {MOST} lines and arcs, {source} among them");
        let help = "a section has a few dozen: leave only what meets the sheet, thin its points out, or give splines a \
                    larger --tolerance";
        ensure(count <= MOST, || source.error(what(), help))?;
        strokes.push(Chain::stroke(pieces, source));
    }
    Ok(strokes)
}

pub(super) fn bounds(
    names: &[&str], operation: Option<u32>, entities: &[Placed], options: &Options, frame: &Frame,
) -> Option<Bounds> {
    let is_ours = |Placed { source, entity, .. }: &&Placed| {
        let is_named = exported(&source.layer).is_some_and(|(own, name)| own == operation && names.contains(&name));
        let is_free = !options.layers.iter().any(|(name, _)| name.eq_ignore_ascii_case(&source.layer));
        is_named && is_free && !source.on_paper && entity.is_curve()
    };
    let pieces = entities.iter().filter(is_ours).filter_map(|placed| Pen { placed, frame }.pieces().ok()).flatten();
    // A left half is the right one's image.
    let is_left = |piece: &Piece| piece.first().x + piece.last().x < 0.0;
    Bounds::around(pieces.map(|piece| if is_left(&piece) { piece.across_axis() } else { piece }))
}

/// Hole, edge and thickness \[mm\] of the blank of layer BLANK, a thin outline as `export` draws it; the bounds of a tube's, upright.
pub(super) fn blank(entities: &[Placed], options: &Options, frame: &Frame) -> Option<([f64; 3], Option<Bounds>)> {
    let outline = bounds(&["blank"], None, entities, options, frame)?;
    let (size, inner) = (outline.high - outline.low, outline.low.x.max(0.0));
    let is_tube = inner > frame.join && size.y > UPRIGHT * size.x;
    let (hole, thickness) = if is_tube { (0.0, size.x) } else { (inner, size.y) };
    let sizes = [hole, outline.high.x, thickness].map(rounded);
    (thickness > frame.join && (is_tube || thickness < THIN * sizes[1])).then_some((sizes, is_tube.then_some(outline)))
}

struct Pen<'a> {
    placed: &'a Placed<'a>,
    frame: &'a Frame,
}

impl Pen<'_> {
    fn pieces(&self) -> Result<Vec<Piece>> {
        let entity = self.placed.entity;
        match entity.source.kind.as_str() {
            "LINE" => self.polyline(&self.points(1.0, &[entity.point(10), entity.point(11)])?, &[0.0]),
            "ARC" => Ok(vec![self.arc()?]),
            "SPLINE" => {
                let control = self.points(1.0, &entity.vertices().iter().map(|v| v.at).collect::<Vec<_>>())?;
                spline::pieces(entity, &control, self.frame.tolerance).map_err(|what| self.error(what))
            }
            _ => self.vertices(),
        }
    }

    fn error(&self, what: impl fmt::Display) -> ImportError {
        let source = &self.placed.source;
        source.error(format!("{source} {what}"), "correct it in the drawing, or redraw it")
    }

    /// Points in mm, of one z; `side` is −1 in a coordinate system seen from behind.
    fn points(&self, side: f64, places: &[Place]) -> Result<Vec<Point>> {
        let heights = places.iter().map(|[.., z]| *z);
        let (low, high) = (heights.clone().fold(f64::INFINITY, f64::min), heights.fold(f64::NEG_INFINITY, f64::max));
        let what = || format!("leaves the x-y plane: its z goes from {low} to {high} drawing units");
        ensure(high - low <= SHORTEST, || self.error(what()))?;
        let point = |[x, y, _]: &Place| {
            let placed = self.placed.placement.at(Point::new(side * x, *y));
            let (point, largest) = (self.frame.point(placed), Length::KIND.largest);
            if point.iter().all(|c| c.abs() <= largest) {
                return Ok(point);
            }
            let [x, y] = placed.into();
            let what = format!("{} reaches x = {x}, y = {y}, beyond {largest} mm", self.placed.source);
            Err(self.placed.source.error(what, "is the unit right? Give it, such as --unit mm"))
        };
        places.iter().map(point).collect()
    }

    /// +1 in the drawing's plane, −1 seen from behind.
    fn side(&self) -> Result<f64> {
        let [x, y, z] = self.placed.entity.normal();
        let what = || format!("does not lie in the x-y plane: its normal is ({x}, {y}, {z})");
        ensure(x.abs() <= 1e-9 && y.abs() <= 1e-9 && z != 0.0, || self.error(what()))?;
        Ok(z.signum())
    }

    fn arc(&self) -> Result<Piece> {
        let (side, entity) = (self.side()?, self.placed.entity);
        let center = self.points(side, &[entity.point(10)])?[0];
        let (scale, rotation) = self.similarity()?;
        let drawn_radius = entity.number(40, 0.0);
        let radius = scale * drawn_radius * self.frame.unit.1;
        let [start, end] = [entity.number(50, 0.0), entity.number(51, 360.0)].map(f64::to_radians);
        let sweep = (end - start).rem_euclid(TAU);
        let place = self.frame.place(center);
        let fits = radius > SHORTEST && radius <= Length::KIND.largest && sweep.is_finite();
        ensure(fits, || self.error(format!("has a radius of {drawn_radius} drawing units about {place}")))?;
        ensure(sweep >= 1e-12, || self.error(format!("is a whole circle about {place}")))?;
        let (start, sweep) = if side > 0.0 { (start, sweep) } else { (PI - start, -sweep) };
        let sense = self.placed.placement.sense();
        Ok(Piece::arc(center, radius, rotation + sense * start, sense * sweep))
    }

    /// Scale and rotation \[rad\] of the placement, which has to leave circles round.
    fn similarity(&self) -> Result<(f64, f64)> {
        let elliptic = "is an arc in a block that is placed with different scales along x and y";
        self.placed.placement.similarity().ok_or_else(|| self.error(elliptic))
    }

    fn vertices(&self) -> Result<Vec<Piece>> {
        let entity = self.placed.entity;
        let (flags, mut vertices) = (entity.number(70, 0.0) as i64, entity.vertices());
        if entity.source.kind == "POLYLINE" {
            ensure(flags & MESH == 0, || self.error("is a mesh, not a line"))?;
            vertices.retain(|vertex| vertex.flags & OFF_THE_CURVE == 0);
        }
        let side = self.side()?;
        let mut points = self.points(side, &vertices.iter().map(|vertex| vertex.at).collect::<Vec<_>>())?;
        let sense = side * self.placed.placement.sense();
        let bulges: Vec<f64> = vertices.iter().map(|vertex| sense * vertex.bulge).collect();
        if bulges.iter().any(|bulge| bulge.abs() >= STRAIGHT) {
            self.similarity()?;
        }
        points.extend(points.first().copied().filter(|_| flags & CLOSED != 0));
        self.polyline(&points, &bulges)
    }

    fn polyline(&self, points: &[Point], bulges: &[f64]) -> Result<Vec<Piece>> {
        // Repeated points, which CAD programs leave behind, are one.
        let distinct = points.windows(2).zip(bulges).filter(|(pair, _)| (pair[1] - pair[0]).norm() > SHORTEST);
        let pieces: Vec<Piece> = distinct.map(|(pair, bulge)| bulged(pair[0], pair[1], *bulge)).collect();
        let at = || points.first().map(|p| format!(": it begins and ends at {}", self.frame.place(*p)));
        ensure(!pieces.is_empty(), || self.error(format!("has no length{}", at().unwrap_or_default())))?;
        Ok(pieces)
    }
}

fn bulged(from: Point, to: Point, bulge: f64) -> Piece {
    if bulge.abs() < STRAIGHT {
        return Piece::line(from, to);
    }
    let half = 0.5 * (to - from);
    let center = from + half + (1.0 - bulge * bulge) / (2.0 * bulge) * Point::new(-half.y, half.x);
    let radial = from - center;
    Piece::arc(center, radial.norm(), radial.y.atan2(radial.x), 4.0 * bulge.atan())
}
