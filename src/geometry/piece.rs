//! Pieces of a tool profile: straight segment and circular arc.

use super::{Point, turned};
use std::f64::consts::{PI, TAU};

/// Length up to which a piece has no direction \[mm\].
pub(super) const SHORTEST: f64 = 1e-9;

/// Straight segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// First point \[mm\].
    pub from: Point,
    /// Last point \[mm\].
    pub to: Point,
    direction: Point,
    length: f64,
}

/// Circular arc. The sheet lies on its left: a clockwise arc is a convex tool corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Centre of the circle \[mm\].
    pub center: Point,
    /// Radius \[mm\].
    pub radius: f64,
    /// Angle of the first point, from +r towards +z \[rad\].
    pub start: f64,
    /// Angle from the first point to the last, positive counter-clockwise \[rad\].
    pub sweep: f64,
    middle: Point,
    cos_half_sweep: f64,
    ends: [Point; 2],
}

/// Piece of a tool profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// Straight line.
    Segment(Segment),
    /// Part of a circle.
    Arc(Arc),
}

pub(super) enum Foot {
    /// Inside the piece, with signed distance \[mm\].
    Interior { distance: f64 },
    /// First or last point of the piece.
    End { first: bool, point: Point },
}

/// Unit vector at an angle from +r towards +z \[rad\].
fn direction(angle: f64) -> Point {
    Point::new(angle.cos(), angle.sin())
}

impl Segment {
    /// Segment between two different points \[mm\].
    pub fn new(from: Point, to: Point) -> Self {
        let length = (to - from).norm();
        Self { from, to, direction: (to - from) / length, length }
    }
}

impl Arc {
    /// Arc about `center` \[mm\] starting at angle `start` \[rad\] and turning by `sweep` \[rad\].
    pub fn new(center: Point, radius: f64, start: f64, sweep: f64) -> Self {
        let ends = [start, start + sweep].map(|angle| center + radius * direction(angle));
        let (middle, cos_half_sweep) = (direction(start + 0.5 * sweep), (0.5 * sweep).abs().min(PI).cos());
        Self { center, radius, start, sweep, middle, ends, cos_half_sweep }
    }

    /// Arc from `start` to `end` about `center` \[mm\], and how far the centre had to move to be equally far from both \[mm\].
    pub fn between(start: Point, end: Point, center: Point, counter_clockwise: bool) -> (Self, f64) {
        let (middle, chord) = (0.5 * (start + end), (end - start).normalize());
        let off = (center - middle).dot(&chord);
        let center = center - off * chord;
        let angle = |p: Point| (p.y - center.y).atan2(p.x - center.x);
        let sense = if counter_clockwise { 1.0 } else { -1.0 };
        let sweep = sense * (sense * (angle(end) - angle(start))).rem_euclid(TAU);
        (Self::new(center, (start - center).norm(), angle(start), sweep), off.abs())
    }

    pub(super) fn joined(&self, next: &Arc) -> Self {
        let sweep = self.sweep + next.sweep;
        let radius = 0.5 * (next.ends[1] - self.ends[0]).norm() / (0.5 * sweep).abs().sin();
        Self::new(self.ends[0] - radius * direction(self.start), radius, self.start, sweep)
    }

    /// Point at the fraction `f` (0..1) of the sweep.
    pub fn at(&self, f: f64) -> Point {
        self.center + self.radius * direction(self.start + f * self.sweep)
    }

    /// True if `x` lies within the angle of the arc.
    pub fn faces(&self, x: Point) -> bool {
        let from_center = x - self.center;
        from_center.dot(&self.middle) >= from_center.norm() * self.cos_half_sweep
    }

    /// 1 if the sheet lies outside the circle, −1 inside.
    fn side(&self) -> f64 {
        if self.sweep < 0.0 { 1.0 } else { -1.0 }
    }
}

impl Piece {
    /// Segment between two different points \[mm\].
    pub fn line(from: Point, to: Point) -> Self {
        Self::Segment(Segment::new(from, to))
    }

    /// Arc about `center` \[mm\] starting at angle `start` \[rad\] and turning by `sweep` \[rad\].
    pub fn arc(center: Point, radius: f64, start: f64, sweep: f64) -> Self {
        Self::Arc(Arc::new(center, radius, start, sweep))
    }

    /// First point \[mm\].
    pub fn first(&self) -> Point {
        match self {
            Piece::Segment(s) => s.from,
            Piece::Arc(a) => a.ends[0],
        }
    }

    /// Last point \[mm\].
    pub fn last(&self) -> Point {
        match self {
            Piece::Segment(s) => s.to,
            Piece::Arc(a) => a.ends[1],
        }
    }

    /// Arc of a hollow of the tool, with the sheet inside its circle.
    pub fn hollow(&self) -> Option<Arc> {
        if let Self::Arc(arc) = self { Some(*arc).filter(|arc| arc.sweep > 0.0) } else { None }
    }

    /// Length along the piece \[mm\].
    pub fn length(&self) -> f64 {
        match self {
            Piece::Segment(s) => s.length,
            Piece::Arc(a) => a.radius * a.sweep.abs(),
        }
    }

    /// Point at a length along the piece \[mm\] and the unit tangent there.
    pub fn at(&self, length: f64) -> (Point, Point) {
        match self {
            Piece::Segment(s) => (s.from + length * s.direction, s.direction),
            Piece::Arc(a) => {
                let turn = length / self.length() * a.sweep;
                (a.center + a.radius * direction(a.start + turn), a.sweep.signum() * turned(direction(a.start + turn)))
            }
        }
    }

    /// Unit tangent at the first (`false`) or last (`true`) point.
    pub fn tangent(&self, last: bool) -> Point {
        match self {
            Piece::Segment(s) => s.direction,
            Piece::Arc(a) => a.sweep.signum() * turned(direction(a.start + if last { a.sweep } else { 0.0 })),
        }
    }

    /// Points along the piece in `n` ≥ 1 intervals, both ends included.
    pub fn sample(&self, n: usize) -> Vec<Point> {
        let at = |f: f64| match self {
            Piece::Segment(s) => s.from + f * (s.to - s.from),
            Piece::Arc(a) => a.at(f),
        };
        (0..=n).map(|i| at(i as f64 / n as f64)).collect()
    }

    /// Points along the piece with both ends, an arc every `step` \[rad\] or finer.
    pub fn polyline(&self, step: f64) -> Vec<Point> {
        self.sample(if let Piece::Arc(a) = self { (a.sweep.abs() / step).ceil().max(1.0) as usize } else { 1 })
    }

    /// Closest point to `x` \[mm\].
    pub fn closest_point(&self, x: Point) -> Point {
        match self.foot(x) {
            Foot::Interior { distance } => x - distance * self.facing(x).0,
            Foot::End { point, .. } => point,
        }
    }

    /// Piece moved to other ends near its own; an arc keeps its centre.
    pub(crate) fn with_ends(&self, from: Point, to: Point) -> Self {
        match self {
            _ if (from, to) == (self.first(), self.last()) => *self,
            Self::Segment(_) => Self::line(from, to),
            Self::Arc(arc) => Self::Arc(Arc::between(from, to, arc.center, arc.sweep > 0.0).0),
        }
    }

    /// Parts before and after a point of the piece, none shorter than `least`.
    pub(crate) fn split_within(&self, at: Point, least: f64) -> [Option<Self>; 2] {
        match [self.first(), self.last()].map(|end| (at - end).norm() <= least) {
            [true, _] => [None, Some(*self)],
            [_, true] => [Some(*self), None],
            _ => self.split(at),
        }
    }

    /// Parts before and after a point of the piece; one without length is left out.
    pub(crate) fn split(&self, point: Point) -> [Option<Piece>; 2] {
        let halves = match self {
            Piece::Segment(s) => [Piece::line(s.from, point), Piece::line(point, s.to)],
            Piece::Arc(a) => {
                let from_center = point - a.center;
                let sense = a.sweep.signum();
                let swept = (sense * (from_center.y.atan2(from_center.x) - a.start)).rem_euclid(TAU);
                // Just before the first point is just after a full turn.
                let before = if swept > 0.5 * (TAU + a.sweep.abs()) { 0.0 } else { swept.min(a.sweep.abs()) * sense };
                let [after, rest] = [a.start + before, a.sweep - before];
                [Piece::arc(a.center, a.radius, a.start, before), Piece::arc(a.center, a.radius, after, rest)]
            }
        };
        halves.map(|half| (half.length() > SHORTEST).then_some(half))
    }

    /// Parallel piece at the distance `by` on the left \[mm\]; `None` when an arc's radius is used up.
    pub(super) fn parallel(&self, by: f64) -> Option<Piece> {
        match self {
            Piece::Segment(s) => {
                let shift = by * turned(s.direction);
                Some(Piece::line(s.from + shift, s.to + shift))
            }
            Piece::Arc(a) => {
                let radius = a.radius - by * a.sweep.signum();
                (radius > 0.0).then(|| Piece::arc(a.center, radius, a.start, a.sweep))
            }
        }
    }

    pub(super) fn foot(&self, x: Point) -> Foot {
        match self {
            Piece::Segment(s) => {
                let from_start = x - s.from;
                let along = from_start.dot(&s.direction);
                if along > 0.0 && along < s.length {
                    return Foot::Interior { distance: s.direction.perp(&from_start) };
                }
                let first = along <= 0.0;
                Foot::End { first, point: if first { s.from } else { s.to } }
            }
            Piece::Arc(a) => {
                let from_center = x - a.center;
                let distance = from_center.norm();
                if distance > 1e-12 && from_center.dot(&a.middle) >= distance * a.cos_half_sweep {
                    return Foot::Interior { distance: a.side() * (distance - a.radius) };
                }
                let first = (x - a.ends[0]).norm_squared() <= (x - a.ends[1]).norm_squared();
                Foot::End { first, point: a.ends[usize::from(!first)] }
            }
        }
    }

    /// Outward normal, and curvature of the distance \[1/mm\], at a point whose foot lies inside the piece.
    pub(super) fn facing(&self, x: Point) -> (Point, f64) {
        match self {
            Piece::Segment(s) => (turned(s.direction), 0.0),
            Piece::Arc(a) => {
                let from_center = x - a.center;
                let curvature = a.side() / from_center.norm();
                (from_center * curvature, curvature)
            }
        }
    }

    pub(super) fn image(&self, point: impl Fn(Point) -> Point, angle: impl Fn(f64) -> f64, turn: f64) -> Self {
        match self {
            Piece::Segment(s) => Piece::line(point(s.from), point(s.to)),
            Piece::Arc(a) => Piece::arc(point(a.center), a.radius, angle(a.start), turn * a.sweep),
        }
    }

    /// Piece walked the other way.
    pub fn reversed(&self) -> Self {
        match self {
            Piece::Segment(s) => Piece::line(s.to, s.from),
            Piece::Arc(a) => Piece::arc(a.center, a.radius, a.start + a.sweep, -a.sweep),
        }
    }

    /// Mirror image in the axis r = 0.
    pub fn across_axis(&self) -> Self {
        self.image(|p| Point::new(-p.x, p.y), |angle| PI - angle, -1.0)
    }

    /// Mirror image in the plane z = 0.
    pub fn upside_down(&self) -> Self {
        self.image(|p| Point::new(p.x, -p.y), |angle| -angle, -1.0)
    }

    pub(crate) fn bounds(&self) -> Bounds {
        self.poles().fold(Bounds { low: self.first(), high: self.first() }.with(self.last()), Bounds::with)
    }

    pub(crate) fn poles(&self) -> impl Iterator<Item = Point> + use<> {
        let arc = if let Piece::Arc(arc) = *self { Some(arc) } else { None };
        let poles = [Point::x(), Point::y(), -Point::x(), -Point::y()].map(|way| {
            arc.map(|arc| arc.center + arc.radius * way).filter(|pole| arc.is_some_and(|arc| arc.faces(*pole)))
        });
        poles.into_iter().flatten()
    }
}

/// Bounding box \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub low: Point,
    pub high: Point,
}

impl Bounds {
    pub fn around(pieces: impl Iterator<Item = Piece>) -> Option<Self> {
        pieces.map(|piece| piece.bounds()).reduce(|a, b| Self { low: a.low.inf(&b.low), high: a.high.sup(&b.high) })
    }

    pub fn with(self, p: Point) -> Self {
        Self { low: self.low.inf(&p), high: self.high.sup(&p) }
    }

    /// True if a point lies farther away than `margin` \[mm\] along an axis.
    pub fn is_beyond(&self, p: Point, margin: f64) -> bool {
        self.is_apart(&Self { low: p, high: p }, margin)
    }

    /// True if two boxes lie farther apart than `margin` \[mm\] along an axis.
    pub fn is_apart(&self, other: &Self, margin: f64) -> bool {
        (self.low - other.high).sup(&(other.low - self.high)).max() > margin
    }
}
