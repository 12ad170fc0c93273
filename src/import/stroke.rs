//! Entities as strokes: pieces in mm, x from the axis, in the drawing's sense of y.

use super::frame::Frame;
use super::layers::{Roles, is_part};
use super::listing::Listed;
use super::read::{Reading, is_curve};
use super::{ImportError, spline};
use crate::geometry::{Arc, Piece, Point, Segment};
use crate::model::Role;
use crate::units::{Kind, Length, Quantity, rounded};
use dxf::Vector;
use dxf::entities::{Entity, EntityType, LwPolyline, Polyline};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Kinds that say something about a drawing and are no part of an outline.
const SAID: [&str; 15] = [
    "TEXT",
    "MTEXT",
    "DIMENSION",
    "ARC_DIMENSION",
    "LEADER",
    "MULTILEADER",
    "TOLERANCE",
    "HATCH",
    "POINT",
    "ATTDEF",
    "XLINE",
    "RAY",
    "VIEWPORT",
    "IMAGE",
    "WIPEOUT",
];

/// Ends that are not farther apart are one point \[mm\]: no drawing is finer.
const SHORTEST: f64 = 1e-7;

/// A bulge that is smaller is a straight line's \[–\]: its arc leaves the chord by half of this share.
const STRAIGHT: f64 = 1e-10;

/// An entity, or the part of one on one side of the axis.
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

    /// The same stroke drawn the other way.
    pub fn reversed(&self) -> Self {
        Self { pieces: self.pieces.iter().rev().map(Piece::reversed).collect(), from: self.from.clone() }
    }
}

/// The strokes of a tool, from all of its layers.
pub(super) fn of_role(
    drawing: &Reading,
    listed: &[Listed],
    roles: &Roles,
    role: Role,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Vec<Stroke>, ImportError> {
    let ours = |entry: &Listed| roles.get(&entry.layer) == Some(&role);
    let mut said: BTreeMap<&str, usize> = BTreeMap::new();
    for entry in listed.iter().filter(|entry| ours(entry) && !is_curve(entry) && !is_part(entry) && !entry.on_paper) {
        if !SAID.contains(&entry.kind.as_str()) {
            let help = "redraw or explode it to lines, arcs and polylines, or move it to another layer";
            let place = frame.place(frame.point(entry.at[0], entry.at[1]));
            let what = format!("{entry} at {place} cannot be part of the {}'s profile", role.name());
            return Err(ImportError::new(what, help).at(entry.line));
        }
        *said.entry(&entry.kind).or_default() += 1;
    }
    if !said.is_empty() {
        let said: Vec<String> = said.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
        notes.push(format!("left out of the {}'s layer: {}", role.name(), said.join(", ")));
    }
    let ours: Vec<_> = drawing.curves(listed).filter(|(_, entry)| ours(entry)).collect();
    let splines = ours.iter().filter(|(_, entry)| entry.kind == "SPLINE").count();
    if splines > 0 {
        let (name, tolerance) = (role.name(), rounded(frame.tolerance));
        notes
            .push(format!("SPLINE in the {name}'s line ({splines}) is followed by tangent arcs within {tolerance} mm"));
    }
    ours.into_iter().map(|(entity, entry)| stroke(entity, entry, frame)).collect()
}

fn stroke(entity: &Entity, entry: &Listed, frame: &Frame) -> Result<Stroke, ImportError> {
    let pen = Pen { entry, frame };
    let pieces = match &entity.specific {
        EntityType::Line(line) => {
            pen.flat([line.p1.z, line.p2.z])?;
            pen.polyline(&[pen.point(1.0, line.p1.x, line.p1.y)?, pen.point(1.0, line.p2.x, line.p2.y)?], &[0.0])?
        }
        EntityType::Arc(arc) => pen.arc(arc)?,
        EntityType::LwPolyline(line) => pen.light(line)?,
        EntityType::Polyline(line) => pen.old(line)?,
        EntityType::Spline(curve) => {
            pen.flat(curve.control_points.iter().map(|p| p.z))?;
            let control =
                curve.control_points.iter().map(|p| pen.point(1.0, p.x, p.y)).collect::<Result<Vec<_>, _>>()?;
            spline::pieces(curve, &control, frame.tolerance).map_err(|what| pen.error(what))?
        }
        _ => unreachable!("only curves are read"),
    };
    Ok(Stroke { pieces, from: entry.clone() })
}

/// Draws the pieces of one entity, and names it where it cannot.
struct Pen<'a> {
    entry: &'a Listed,
    frame: &'a Frame,
}

impl Pen<'_> {
    fn error(&self, what: String) -> ImportError {
        ImportError::new(format!("{} {what}", self.entry), "correct it in the drawing, or redraw it")
            .at(self.entry.line)
    }

    /// A point in mm; `side` is −1 in a coordinate system seen from behind.
    fn point(&self, side: f64, x: f64, y: f64) -> Result<Point, ImportError> {
        let point = self.frame.point(side * x, y);
        let Kind { largest, .. } = Length::KIND;
        if point.iter().all(|c| c.abs() <= *largest) {
            return Ok(point);
        }
        Err(self.error(format!("reaches x = {x}, y = {y}, beyond {largest} mm: is the unit right?")))
    }

    /// All heights above the drawing's plane have to be the same.
    fn flat(&self, heights: impl IntoIterator<Item = f64>) -> Result<(), ImportError> {
        let (low, high) =
            heights.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
        if high - low > SHORTEST {
            let what = format!("leaves the x-y plane: its z goes from {low} to {high} drawing units");
            return Err(self.error(what));
        }
        Ok(())
    }

    /// +1 for an entity that is drawn in the plane of the drawing, −1 for one that is seen from behind.
    fn side(&self, normal: &Vector) -> Result<f64, ImportError> {
        if normal.x.abs() > 1e-9 || normal.y.abs() > 1e-9 || normal.z == 0.0 {
            let what =
                format!("does not lie in the x-y plane: its normal is ({}, {}, {})", normal.x, normal.y, normal.z);
            return Err(self.error(what));
        }
        Ok(normal.z.signum())
    }

    fn arc(&self, arc: &dxf::entities::Arc) -> Result<Vec<Piece>, ImportError> {
        let side = self.side(&arc.normal)?;
        let center = self.point(side, arc.center.x, arc.center.y)?;
        let radius = self.frame.length(arc.radius);
        let (start, end) = (arc.start_angle.to_radians(), arc.end_angle.to_radians());
        let sweep = (end - start).rem_euclid(TAU);
        if !(radius > SHORTEST && radius <= Length::KIND.largest && sweep.is_finite()) {
            let place = self.frame.place(center);
            return Err(self.error(format!("has a radius of {} drawing units about {place}", arc.radius)));
        }
        if sweep < 1e-12 {
            return Err(self.error(format!("is a whole circle about {}", self.frame.place(center))));
        }
        let piece = Piece::Arc(Arc::new(center, radius, start, sweep));
        Ok(vec![if side > 0.0 { piece } else { Piece::Arc(Arc::new(center, radius, PI - start, -sweep)) }])
    }

    fn light(&self, line: &LwPolyline) -> Result<Vec<Piece>, ImportError> {
        let side = self.side(&line.extrusion_direction)?;
        let points = line.vertices.iter().map(|v| self.point(side, v.x, v.y)).collect::<Result<Vec<_>, _>>()?;
        let bulges: Vec<f64> = line.vertices.iter().map(|v| side * v.bulge).collect();
        self.closed_or_open(points, &bulges, line.is_closed())
    }

    fn old(&self, line: &Polyline) -> Result<Vec<Piece>, ImportError> {
        if line.is_3d_polygon_mesh() || line.is_polyface_mesh() {
            return Err(self.error("is a mesh, not a line".to_owned()));
        }
        let side = self.side(&line.normal)?;
        // The frame of a spline-fit polyline is not on the curve.
        let vertices: Vec<_> = line.vertices().filter(|v| !v.is_spline_frame_control_point()).collect();
        self.flat(vertices.iter().map(|v| v.location.z))?;
        let points = vertices.iter().map(|v| self.point(side, v.location.x, v.location.y));
        let bulges: Vec<f64> = vertices.iter().map(|v| side * v.bulge).collect();
        self.closed_or_open(points.collect::<Result<Vec<_>, _>>()?, &bulges, line.is_closed())
    }

    fn closed_or_open(&self, mut points: Vec<Point>, bulges: &[f64], closed: bool) -> Result<Vec<Piece>, ImportError> {
        points.extend(points.first().copied().filter(|_| closed));
        self.polyline(&points, bulges)
    }

    /// Lines and arcs through points; the bulge of each point but the last is the tangent of a quarter of the angle
    /// that the arc to the next one turns, positive to the left.
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
