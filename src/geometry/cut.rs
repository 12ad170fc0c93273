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

#[cfg(test)]
mod tests {
    use super::super::Arc;
    use super::*;
    use std::f64::consts::PI;

    /// Trust: by hand. Whole lengths are kept, and parts lie on one side each.
    #[test]
    fn parts_lie_on_one_side_each_and_add_up() {
        let line = Piece::Segment(Segment::new(Point::new(-3.0, 1.0), Point::new(6.0, 4.0)));
        let dome = Piece::Arc(Arc::new(Point::new(0.0, 0.0), 5.0, 0.0, PI));
        let twice = Piece::Arc(Arc::new(Point::new(1.0, 0.0), 2.0, -0.5 * PI, -PI));
        for (piece, parts) in [(line, 2), (dome, 2), (twice, 3)] {
            let cut = piece.cut_at_axis(1e-6);
            assert_eq!(cut.len(), parts, "{cut:?}");
            assert!((cut.iter().map(Piece::length).sum::<f64>() - piece.length()).abs() < 1e-9);
            for pair in cut.windows(2) {
                assert!((pair[0].last() - pair[1].first()).norm() < 1e-9);
                assert!(pair[0].last().x.abs() < 1e-9);
            }
        }
        assert_eq!(line.across_axis().cut_at_axis(4.0).len(), 1, "a crossing that is an end");
    }
}
