//! Intersections of pieces, and folds of a profile.

use super::{Bounds, Piece, Point, Profile};
use std::f64::consts::PI;

/// Largest distance of touching pieces \[mm\].
const TOUCH: f64 = 1e-7;
/// Turn at a vertex above which a chain goes back on itself \[rad\].
const BACK: f64 = 175.0 * PI / 180.0;
/// Distance from their vertex within which neighbours may meet a second time \[mm\]: drawings are rounded.
const ROUNDED: f64 = 0.05;

/// Self-intersection of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fold {
    /// It turns back on itself.
    Back {
        /// The vertex \[mm\].
        at: Point,
        /// Index of the piece before.
        after: usize,
        /// \[rad\], positive to the left.
        turn: f64,
    },
    /// Two pieces cross or touch, or neighbours do so away from their vertex.
    Crossing {
        /// Meeting point \[mm\].
        at: Point,
        /// Indices of both pieces, rising.
        pieces: [usize; 2],
    },
}

impl Profile {
    /// Finds the first place where the profile turns back, crosses or touches itself.
    pub fn fold(&self) -> Option<Fold> {
        if let Some(v) = self.vertices().find(|v| v.turn.abs() > BACK) {
            return Some(Fold::Back { at: v.point, after: v.after, turn: v.turn });
        }
        // In the order of their boxes along the chain's longer way, a piece meets only those that begin before it ends.
        let boxes: Vec<Bounds> = self.pieces().iter().map(Piece::bounds).collect();
        let size = Bounds::around(self.pieces().iter().copied()).map_or(Point::zeros(), |all| all.high - all.low);
        let way = if size.x >= size.y { 0 } else { 1 };
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        order.sort_by(|a, b| boxes[*a].low[way].total_cmp(&boxes[*b].low[way]));
        let mut first: Option<([usize; 2], Point)> = None;
        for (k, &a) in order.iter().enumerate() {
            let reach = boxes[a].high[way] + 2.0 * TOUCH;
            for &b in order[k + 1..].iter().take_while(|b| boxes[**b].low[way] <= reach) {
                let pair = [a.min(b), a.max(b)];
                if !boxes[a].is_apart(&boxes[b], 2.0 * TOUCH) && first.is_none_or(|(found, _)| pair < found) {
                    first = self.meeting(pair).map(|at| (pair, at)).or(first);
                }
            }
        }
        first.map(|(pieces, at)| Fold::Crossing { at, pieces })
    }

    fn meeting(&self, [i, j]: [usize; 2]) -> Option<Point> {
        let (a, b) = (&self.pieces()[i], &self.pieces()[j]);
        // Round-off δ of the distance moves the point where a line touches an arc by √(2 R δ).
        let radius = [a, b].map(|piece| if let Piece::Arc(arc) = piece { arc.radius } else { 0.0 });
        let near = ROUNDED + (8.0 * radius[0].max(radius[1]) * TOUCH).sqrt();
        common(a, b).into_iter().find(|p| j > i + 1 || (p - a.last()).norm() > near)
    }
}

impl Piece {
    /// Cuts the piece at the axis r = 0, but not closer than `near` \[mm\] to an end.
    pub fn cut_at_axis(&self, near: f64) -> Vec<Piece> {
        let axis = Piece::line(Point::new(0.0, -1e6), Point::new(0.0, 1e6));
        let far_from_ends = |p: &Point| (p - self.first()).norm() > near && (p - self.last()).norm() > near;
        let mut parts = vec![*self];
        for point in common(self, &axis).into_iter().filter(far_from_ends) {
            if let Some(i) = parts.iter().position(|part| (part.closest_point(point) - point).norm() < 1e-6) {
                parts.splice(i..=i, parts[i].split(point).into_iter().flatten().collect::<Vec<_>>());
            }
        }
        parts
    }
}

/// Common points of two pieces: crossings, touching points and ends on the other; the ends of a common stretch.
pub(super) fn common(a: &Piece, b: &Piece) -> Vec<Point> {
    let on = |piece: &Piece, p: &Point| (piece.closest_point(*p) - p).norm() <= TOUCH;
    let mut points: Vec<Point> = carriers(a, b).into_iter().filter(|p| on(a, p) && on(b, p)).collect();
    points.extend([a.first(), a.last()].into_iter().filter(|p| on(b, p)));
    points.extend([b.first(), b.last()].into_iter().filter(|p| on(a, p)));
    points
}

pub(super) fn carriers(a: &Piece, b: &Piece) -> Vec<Point> {
    match (a, b) {
        (Piece::Segment(s), Piece::Segment(t)) => {
            let (d, e) = (a.tangent(false), b.tangent(false));
            let sine = d.perp(&e);
            if sine.abs() < 1e-12 { vec![] } else { vec![s.from + (t.from - s.from).perp(&e) / sine * d] }
        }
        (Piece::Segment(s), Piece::Arc(c)) | (Piece::Arc(c), Piece::Segment(s)) => {
            let along = (s.to - s.from).normalize();
            let foot = s.from + (c.center - s.from).dot(&along) * along;
            either_side(foot, along, c.radius, (c.center - foot).norm())
        }
        (Piece::Arc(c), Piece::Arc(d)) => {
            let between = d.center - c.center;
            let distance = between.norm();
            if distance < TOUCH {
                return Vec::new();
            }
            let along = between / distance;
            let to_chord = (distance * distance + c.radius * c.radius - d.radius * d.radius) / (2.0 * distance);
            either_side(c.center + to_chord * along, super::turned(along), c.radius, to_chord.abs())
        }
    }
}

/// Points of a circle on a chord whose middle lies at `distance` from the centre.
fn either_side(middle: Point, along: Point, radius: f64, distance: f64) -> Vec<Point> {
    if distance > radius + TOUCH {
        return Vec::new();
    }
    let half = (radius * radius - distance * distance).max(0.0).sqrt();
    vec![middle + half * along, middle - half * along]
}
