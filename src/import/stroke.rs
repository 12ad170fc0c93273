//! Entities as strokes: pieces in mm, x from the axis, in the drawing's sense of y.

use super::blocks::Placed;
use super::curve::{self, Curve, Place, Polyline, Vertex};
use super::error::ImportError;
use super::frame::Frame;
use super::listing::{Listed, MOST};
use super::parts::{Part, Parts};
use super::reference::Placement;
use super::spline;
use crate::geometry::{Arc, Bounds, Piece, Point, Segment};
use crate::units::{Dimensioned, Kind, Length, rounded};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Kinds of annotations, which are no part of an outline.
const ANNOTATIONS: &str = "TEXT MTEXT DIMENSION ARC_DIMENSION LEADER MULTILEADER TOLERANCE HATCH POINT ATTDEF XLINE RAY VIEWPORT \
                           IMAGE WIPEOUT";

/// Largest distance of coinciding points \[mm\].
const SHORTEST: f64 = 1e-7;

/// Largest bulge of a straight line \[–\].
const STRAIGHT: f64 = 1e-10;

/// Entity, or its part on one side of the axis.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    pub pieces: Vec<Piece>,
    pub from: Listed,
}

impl Stroke {
    pub fn first(&self) -> Point {
        self.pieces[0].first()
    }

    pub fn last(&self) -> Point {
        self.pieces[self.pieces.len() - 1].last()
    }

    pub fn bounds(&self) -> Bounds {
        Bounds::around(&self.pieces).expect("a stroke has pieces")
    }

    pub fn reversed(&self) -> Self {
        Self { pieces: self.pieces.iter().rev().map(Piece::reversed).collect(), from: self.from.clone() }
    }
}

pub(super) fn of_part(
    entities: &[Placed],
    parts: &Parts,
    part: Part,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Vec<Stroke>, ImportError> {
    let ours = |entity: &&Placed| !entity.listed.on_paper && parts.get(&entity.listed.layer) == Some(&part);
    let name = part.name();
    let mut annotations: BTreeMap<&str, usize> = BTreeMap::new();
    for Placed { listed, .. } in entities.iter().filter(ours).filter(|entity| entity.curve.is_none()) {
        if !ANNOTATIONS.split(' ').any(|kind| kind == listed.kind) {
            let help = match listed.kind.as_str() {
                "INSERT" => "its block is in another file, or lies across the drawing's plane: bind or explode it",
                _ => "redraw or explode it to lines, arcs and polylines, or move it to another layer",
            };
            let place = frame.place(frame.point(listed.at[0], listed.at[1]));
            let what = format!("{listed} at {place} cannot be part of the {name}'s profile");
            return Err(ImportError::new(what, help).at(listed.line));
        }
        *annotations.entry(&listed.kind).or_default() += 1;
    }
    if !annotations.is_empty() {
        let annotations: Vec<String> = annotations.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
        notes.push(format!("left out of the {name}'s layer: {}", annotations.join(", ")));
    }
    let curves = || entities.iter().filter(ours).filter_map(|placed| Some((placed.curve?, placed)));
    let splines = curves().filter(|(_, placed)| placed.listed.kind == "SPLINE").count();
    if splines > 0 {
        let tolerance = rounded(frame.tolerance);
        notes
            .push(format!("SPLINE in the {name}'s line ({splines}) is followed by tangent arcs within {tolerance} mm"));
    }
    let (mut strokes, mut pieces) = (Vec::new(), 0);
    for (curve, Placed { listed, placement, .. }) in curves() {
        let stroke = stroke(curve, listed, placement, frame)?;
        pieces += stroke.pieces.len();
        if pieces > MOST {
            let what = format!("the {name} is drawn in more than {MOST} lines and arcs, {listed} among them");
            let help = "a section has a few dozen: leave only what meets the sheet, thin its points out, or give splines a \
                        larger --tolerance";
            return Err(ImportError::new(what, help).at(listed.line));
        }
        strokes.push(stroke);
    }
    Ok(strokes)
}

fn stroke(curve: &Curve, from: &Listed, placement: &Placement, frame: &Frame) -> Result<Stroke, ImportError> {
    let pen = Pen { entry: from, placement, frame };
    let pieces = match curve {
        Curve::Line([from, to]) => {
            pen.flat([from[2], to[2]])?;
            pen.polyline(&[pen.point(1.0, *from)?, pen.point(1.0, *to)?], &[0.0])?
        }
        Curve::Arc(arc) => pen.arc(arc)?,
        Curve::Light(line) => pen.vertices(line, line.vertices.iter())?,
        Curve::Old(line) => pen.old(line)?,
        Curve::Spline(curve) => {
            pen.flat(curve.control.iter().map(|p| p[2]))?;
            let control = curve.control.iter().map(|p| pen.point(1.0, *p)).collect::<Result<Vec<_>, _>>()?;
            spline::pieces(curve, &control, frame.tolerance).map_err(|what| pen.error(what))?
        }
    };
    Ok(Stroke { pieces, from: from.clone() })
}

struct Pen<'a> {
    entry: &'a Listed,
    placement: &'a Placement,
    frame: &'a Frame,
}

impl Pen<'_> {
    fn error(&self, what: String) -> ImportError {
        ImportError::new(format!("{} {what}", self.entry), "correct it in the drawing, or redraw it")
            .at(self.entry.line)
    }

    /// Point in mm; `side` is −1 in a coordinate system seen from behind.
    fn point(&self, side: f64, [x, y, _]: Place) -> Result<Point, ImportError> {
        let [x, y] = self.placement.at(Point::new(side * x, y)).into();
        let point = self.frame.point(x, y);
        let Kind { largest, .. } = Length::KIND;
        if point.iter().all(|c| c.abs() <= *largest) {
            return Ok(point);
        }
        Err(self.error(format!("reaches x = {x}, y = {y}, beyond {largest} mm: is the unit right?")))
    }

    fn flat(&self, heights: impl IntoIterator<Item = f64>) -> Result<(), ImportError> {
        let (low, high) =
            heights.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
        if high - low > SHORTEST {
            let what = format!("leaves the x-y plane: its z goes from {low} to {high} drawing units");
            return Err(self.error(what));
        }
        Ok(())
    }

    /// +1 in the drawing's plane, −1 seen from behind.
    fn side(&self, [x, y, z]: Place) -> Result<f64, ImportError> {
        if x.abs() > 1e-9 || y.abs() > 1e-9 || z == 0.0 {
            return Err(self.error(format!("does not lie in the x-y plane: its normal is ({x}, {y}, {z})")));
        }
        Ok(z.signum())
    }

    fn arc(&self, arc: &curve::Arc) -> Result<Vec<Piece>, ImportError> {
        let side = self.side(arc.normal)?;
        let center = self.point(side, arc.center)?;
        let similarity = self.placement.similarity().ok_or_else(|| self.elliptic())?;
        let radius = self.frame.length(similarity.scale * arc.radius);
        let [start, end] = arc.angles.map(f64::to_radians);
        let sweep = (end - start).rem_euclid(TAU);
        if !(radius > SHORTEST && radius <= Length::KIND.largest && sweep.is_finite()) {
            let place = self.frame.place(center);
            return Err(self.error(format!("has a radius of {} drawing units about {place}", arc.radius)));
        }
        if sweep < 1e-12 {
            return Err(self.error(format!("is a whole circle about {}", self.frame.place(center))));
        }
        let (start, sweep) = if side > 0.0 { (start, sweep) } else { (PI - start, -sweep) };
        let start = similarity.rotation + similarity.sense * start;
        Ok(vec![Piece::Arc(Arc::new(center, radius, start, similarity.sense * sweep))])
    }

    fn elliptic(&self) -> ImportError {
        self.error("is an arc in a block that is placed with different scales along x and y".to_owned())
    }

    fn old(&self, line: &Polyline) -> Result<Vec<Piece>, ImportError> {
        if line.is_mesh() {
            return Err(self.error("is a mesh, not a line".to_owned()));
        }
        let vertices = line.vertices.iter().filter(|vertex| !vertex.is_off_the_curve());
        self.flat(vertices.clone().map(|vertex| vertex.at[2]))?;
        self.vertices(line, vertices)
    }

    fn vertices<'v>(
        &self,
        line: &Polyline,
        vertices: impl Iterator<Item = &'v Vertex> + Clone,
    ) -> Result<Vec<Piece>, ImportError> {
        let side = self.side(line.normal)?;
        let mut points = vertices.clone().map(|v| self.point(side, v.at)).collect::<Result<Vec<_>, _>>()?;
        let sense = side * self.placement.sense();
        let bulges: Vec<f64> = vertices.map(|v| sense * v.bulge).collect();
        if bulges.iter().any(|bulge| bulge.abs() >= STRAIGHT) && self.placement.similarity().is_none() {
            return Err(self.elliptic());
        }
        points.extend(points.first().copied().filter(|_| line.is_closed()));
        self.polyline(&points, &bulges)
    }

    /// Lines and arcs through points; a bulge is that of the arc to the next point.
    fn polyline(&self, points: &[Point], bulges: &[f64]) -> Result<Vec<Piece>, ImportError> {
        // Repeated points, which CAD programs leave behind, are one.
        let distinct = points.windows(2).zip(bulges).filter(|(pair, _)| (pair[1] - pair[0]).norm() > SHORTEST);
        let pieces: Vec<Piece> = distinct.map(|(pair, bulge)| bulged(pair[0], pair[1], *bulge)).collect();
        if pieces.is_empty() {
            let at =
                points.first().map_or(String::new(), |p| format!(": it begins and ends at {}", self.frame.place(*p)));
            return Err(self.error(format!("has no length{at}")));
        }
        Ok(pieces)
    }
}

fn bulged(from: Point, to: Point, bulge: f64) -> Piece {
    if bulge.abs() < STRAIGHT {
        return Piece::Segment(Segment::new(from, to));
    }
    let half = 0.5 * (to - from);
    let center = from + half + (1.0 - bulge * bulge) / (2.0 * bulge) * Point::new(-half.y, half.x);
    let radial = from - center;
    Piece::Arc(Arc::new(center, radial.norm(), radial.y.atan2(radial.x), 4.0 * bulge.atan()))
}
