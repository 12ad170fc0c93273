//! The line at a fixed distance from a profile, on the sheet's side: what a counter-tool follows.

use super::crossing::common;
use super::{Arc, Fold, Piece, Point, Profile, on_axis, turn, turn_on_axis, turned};
use std::f64::consts::PI;

/// A hollow that turns by less is the rounding of a drawing; the pieces beside it are cut where they meet \[rad\].
const KINK: f64 = 5.0 * PI / 180.0;

/// Why a profile has no offset.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OffsetError {
    /// A hollow has no room for the offset.
    #[error("the hollow of radius {radius:.4} mm at r = {:.4} mm, z = {:.4} mm is smaller than the offset", at.x, at.y)]
    TooTight {
        /// \[mm\], 0 at a sharp vertex
        radius: f64,
        /// Where the hollow is \[mm\].
        at: Point,
    },
    /// The offset meets itself.
    #[error("its walls are too close to each other: the offset runs into itself at r = {:.4} mm, z = {:.4} mm", at.x, at.y)]
    Crosses {
        /// Where the offset meets itself.
        at: Point,
    },
}

impl OffsetError {
    /// Where \[mm\].
    pub fn at(&self) -> Point {
        match self {
            Self::TooTight { at, .. } | Self::Crosses { at } => *at,
        }
    }
}

impl Profile {
    /// The line at the distance `by` > 0 \[mm\] on the left of the profile, walked the same way.
    ///
    /// Straight lines move, convex arcs grow, hollow arcs shrink, a sharp convex corner becomes an arc of radius `by`.
    /// A tip on the axis is such a corner too, with its mirror image beyond the axis.
    ///
    /// # Errors
    /// When a hollow is narrower than `by`: an arc of a smaller radius, a sharp vertex, or walls that face each other.
    pub fn offset(&self, by: f64) -> Result<Self, OffsetError> {
        let mut moved = Vec::new();
        for piece in self.pieces() {
            let middle = piece.sample(2)[1];
            match (piece.beside(by), piece) {
                (Some(beside), _) if beside.length() > super::profile::GAP => moved.push(beside),
                (_, Piece::Arc(a)) if a.radius < by * (1.0 - 1e-9) => {
                    return Err(OffsetError::TooTight { radius: a.radius, at: middle });
                }
                // Shrunk to a point, from which the next piece goes on.
                _ => {}
            }
        }
        self.tightest_vertex()?;
        let mut line = self.corner_on_axis(by, true).into_iter().collect::<Vec<_>>();
        for piece in moved {
            join(&mut line, piece, by);
        }
        if let Some(corner) = self.corner_on_axis(by, false) {
            join(&mut line, corner, by);
        }
        let offset = Self::new(line).map_err(|_| OffsetError::TooTight { radius: 0.0, at: self.first() })?;
        match offset.fold() {
            Some(Fold::Back { at, .. } | Fold::Crossing { at, .. }) => Err(OffsetError::Crosses { at }),
            None => Ok(offset),
        }
    }

    fn tightest_vertex(&self) -> Result<(), OffsetError> {
        let ends = [(self.first(), self.pieces()[0].tangent(false)), (self.last(), self.end_tangent())];
        let tips = ends.into_iter().filter(|(p, _)| on_axis(p)).map(|(p, t)| (p, turn_on_axis(t)));
        let inner = self.vertices().map(|v| (v.point, v.turn));
        match inner.chain(tips).find(|(_, turn)| *turn > KINK) {
            Some((at, _)) => Err(OffsetError::TooTight { radius: 0.0, at }),
            None => Ok(()),
        }
    }

    fn end_tangent(&self) -> Point {
        self.pieces()[self.pieces().len() - 1].tangent(true)
    }

    /// The half arc around a tip on the axis, at the first or the last point.
    fn corner_on_axis(&self, by: f64, at_first: bool) -> Option<Piece> {
        let (tip, tangent) = match at_first {
            true => (self.first(), self.pieces()[0].tangent(false)),
            false => (self.last(), self.end_tangent()),
        };
        let turn = turn_on_axis(tangent);
        if !on_axis(&tip) || -turn * by < super::profile::GAP {
            return None;
        }
        let normal = turned(tangent);
        let at_tangent = normal.y.atan2(normal.x);
        let start = if at_first { at_tangent - 0.5 * turn } else { at_tangent };
        Some(Piece::Arc(Arc::new(tip, by, start, 0.5 * turn)))
    }
}

/// Adds a piece to a line: with an arc about the vertex where they have come apart, cut where they overlap.
fn join(line: &mut Vec<Piece>, piece: Piece, by: f64) {
    let Some(last) = line.last().copied() else { return line.push(piece) };
    let (a, b) = (last.tangent(true), piece.tangent(false));
    let turn = turn(a, b);
    if (piece.first() - last.last()).norm() < super::profile::GAP {
        return line.push(piece);
    }
    if turn < 0.0 {
        let normal = turned(a);
        let vertex = last.last() - by * normal;
        line.push(Piece::Arc(Arc::new(vertex, by, normal.y.atan2(normal.x), turn)));
        return line.push(piece);
    }
    let near = |p: &Point| (p - last.last()).norm_squared();
    if let Some(cut) = common(&last, &piece).into_iter().min_by(|p, q| near(p).total_cmp(&near(q))) {
        line.pop();
        line.extend(last.split(cut)[0]);
        line.extend(piece.split(cut)[1]);
    } else {
        line.push(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Segment, fillet};
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn lines(list: &[[f64; 2]]) -> Profile {
        let segments =
            list.windows(2).map(|w| Segment::new(Point::new(w[0][0], w[0][1]), Point::new(w[1][0], w[1][1])));
        Profile::new(segments.map(Piece::Segment).collect()).unwrap()
    }

    /// Every point of the offset has the distance `by` from the profile (1e-7 mm: tangents agree to 1e-9 only, seen
    /// over lengths up to 1e2).
    fn assert_distance(profile: &Profile, by: f64) {
        let offset = profile.offset(by).unwrap();
        for p in offset.polyline(0.05) {
            assert_relative_eq!(profile.closest(p).distance, by, epsilon = 1e-7);
        }
    }

    /// Trust: the standard shapes know their own offsets.
    #[test]
    fn the_offset_of_a_punch_is_a_larger_punch() {
        let offset = Profile::flat_punch(50.0, 9.0, 1.0).offset(1.2).unwrap();
        let larger = Profile::flat_punch(51.2, 10.2, 1.0).shifted(1.2);
        for i in 0..200 {
            let x = Point::new(0.3 * f64::from(i), 4.0 - 0.1 * f64::from(i));
            assert_relative_eq!(offset.closest(x).distance, larger.closest(x).distance, epsilon = 1e-9);
        }
        assert_distance(&Profile::hemispherical_punch(25.0, 1.0), 2.0);
        assert_distance(&Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8), 1.0);
        assert_distance(&Profile::holder(60.0, 1.0), 1.5);
        assert_distance(&Profile::die(51.0, 7.0, 1.0), 1.5);
    }

    /// Trust: around a tip on the axis the offset is an arc of radius `by`, its top above the tip.
    #[test]
    fn a_tip_on_the_axis_is_a_corner() {
        let cone = lines(&[[0.0, 0.0], [10.0, -10.0], [10.0, -40.0]]);
        let offset = cone.offset(2.0).unwrap();
        assert_relative_eq!(offset.first(), Point::new(0.0, 2.0), epsilon = 1e-12);
        assert_distance(&cone, 2.0);
        let dish = lines(&[[0.0, -10.0], [10.0, 0.0]]);
        assert!(matches!(dish.offset(2.0), Err(OffsetError::TooTight { radius: 0.0, .. })));
        let from_outside = cone.mirrored();
        assert_relative_eq!(from_outside.offset(2.0).unwrap().last(), Point::new(0.0, -2.0), epsilon = 1e-12);
    }

    #[test]
    fn narrow_hollows_are_refused_with_their_place() {
        let slot = [[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [13.0, -8.0], [13.0, 0.0], [40.0, 0.0]];
        let points: Vec<Point> = slot.iter().map(|p| Point::new(p[0], p[1])).collect();
        let rounded = Profile::new(fillet(&points, &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0]).unwrap()).unwrap();
        let error = rounded.offset(1.2).unwrap_err();
        assert!(matches!(error, OffsetError::TooTight { radius, .. } if (radius - 1.0).abs() < 1e-9), "{error}");
        assert!((error.at() - Point::new(10.3, -7.7)).norm() < 0.1, "{error}");
        let soft = Profile::new(fillet(&points, &[0.0, 1.0, 1.5, 1.5, 1.0, 0.0]).unwrap()).unwrap();
        assert!(soft.offset(1.2).is_ok());
        let sharp = lines(&slot).offset(1.2).unwrap_err();
        assert!(matches!(sharp, OffsetError::TooTight { radius: 0.0, .. }), "{sharp}");
        // Two hollow bends of 4 mm with walls that come within 3 mm of each other further out.
        let neck = [[0.0, 0.0], [10.0, 0.0], [8.0, -30.0], [30.0, -30.0], [12.5, 0.5], [40.0, 0.5]];
        let points: Vec<Point> = neck.iter().map(|p| Point::new(p[0], p[1])).collect();
        let bottle = Profile::new(fillet(&points, &[0.0, 0.1, 4.0, 4.0, 0.1, 0.0]).unwrap()).unwrap();
        assert!(matches!(bottle.offset(2.0), Err(OffsetError::Crosses { .. })), "{:?}", bottle.offset(2.0));
    }

    proptest! {
        /// Trust: the definition. Any smooth chain that has an offset has it at the distance `by` everywhere, and the
        /// offset, turned round, has the profile at that distance.
        #[test]
        fn random_chains_have_their_offset_at_its_distance(
            steps in prop::collection::vec((12.0..30.0_f64, -1.2..0.9_f64), 2..6),
            by in 0.2..2.5_f64,
        ) {
            let (mut here, mut heading) = (Point::new(0.0, 0.0), 0.0_f64);
            let mut points = vec![here];
            for (length, turn) in steps {
                here += length * Point::new(heading.cos(), heading.sin());
                points.push(here);
                heading += turn;
            }
            let profile = Profile::new(fillet(&points, &vec![3.0; points.len()]).unwrap()).unwrap();
            let Ok(offset) = profile.offset(by) else { return Ok(()) };
            for p in offset.polyline(0.1) {
                prop_assert!((profile.closest(p).distance - by).abs() < 1e-7, "{p:?}");
            }
            for p in profile.polyline(0.1) {
                prop_assert!((offset.reversed().closest(p).distance - by).abs() < 1e-7, "{p:?}");
            }
        }
    }
}
