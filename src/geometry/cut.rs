//! Pieces cut where they cross the axis.

use super::crossing::common;
use super::{Piece, Point, Segment};

/// How far the axis is followed \[mm\]: beyond any tool.
const FAR: f64 = 1e6;

impl Piece {
    /// The parts of the piece on either side of the axis r = 0, in order; crossings closer than `near` \[mm\] to an end
    /// do not cut.
    pub fn cut_at_axis(&self, near: f64) -> Vec<Piece> {
        let axis = Piece::Segment(Segment::new(Point::new(0.0, -FAR), Point::new(0.0, FAR)));
        let far_from_ends = |p: &Point| (p - self.first()).norm() > near && (p - self.last()).norm() > near;
        let mut parts = vec![*self];
        for point in common(self, &axis).into_iter().filter(far_from_ends) {
            let on = |part: &Piece| (part.closest_point(point) - point).norm() < 1e-6;
            if let Some(i) = parts.iter().position(on) {
                let halves = parts[i].split(point).into_iter().flatten();
                parts.splice(i..=i, halves.collect::<Vec<_>>());
            }
        }
        parts
    }
}
