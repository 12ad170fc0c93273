//! The highest or lowest point of a profile over the sheet.

use super::crossing::common;
use super::{Piece, Point, Profile, Segment};

impl Profile {
    /// The highest (or lowest) point with r ≤ `within` \[mm\]; `None` when the profile lies beyond it.
    pub fn extreme(&self, highest: bool, within: f64) -> Option<Point> {
        let sign = if highest { 1.0 } else { -1.0 };
        let edge = Piece::Segment(Segment::new(Point::new(within, -1e6), Point::new(within, 1e6)));
        let points = self.pieces().iter().flat_map(|piece| {
            let mut points = common(piece, &edge);
            points.extend([piece.first(), piece.last()]);
            if let Piece::Arc(a) = piece {
                points.push(piece.closest_point(a.center + Point::new(0.0, sign * 2.0 * a.radius)));
            }
            points
        });
        points.filter(|p| p.x <= within + 1e-9).max_by(|a, b| (sign * a.y).total_cmp(&(sign * b.y)))
    }
}
