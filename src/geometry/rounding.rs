//! Rounding of chains of chords by arcs with common tangents: a node that slides over bare chords feels every vertex.
//!
//! # References
//! The idea of interpolating vertex normals for tool contact: D. M. Neto, M. C. Oliveira, L. F. Menezes, J. L. Alves,
//! Applying Nagata patches to smooth discretized surfaces used in 3D frictional contact problems, Comput. Methods Appl.
//! Mech. Engrg. 271 (2014) 296–320; biarcs: K. M. Bolton, Computer-Aided Design 7 (1975) 89–92.

use super::{Arc, Piece, Point, Profile, on_axis, turn, turn_on_axis, turned};
use std::f64::consts::PI;

/// Turn at a vertex above which it is a corner \[rad\].
pub const CORNER: f64 = 25.0 * PI / 180.0;

/// Turn below which a chain is straight \[rad\]: larger arcs would lose their ends to round-off.
const STRAIGHT: f64 = 1e-6;
/// Length over that of a neighbour above which a piece is a straight wall \[–\].
const WALL: f64 = 4.0;

impl Profile {
    /// Rounds chords off; arcs, corners and long straight pieces stay.
    pub fn rounded(&self) -> Self {
        let pieces = self.pieces();
        let n = pieces.len();
        let is_smooth = |turn: f64| turn > STRAIGHT && turn < CORNER;
        // Tangent shared at the vertex before each piece, where the chain is smooth there.
        let shared = |v: usize| {
            if v == 0 || v == n {
                let (end, own) = self.end_tangents()[usize::from(v == n)];
                // With its mirror image beyond the axis the chain is level there.
                return (on_axis(&end) && is_smooth(turn_on_axis(own).abs())).then(|| Point::new(own.x.signum(), 0.0));
            }
            let (before, after) = (&pieces[v - 1], &pieces[v]);
            let (a, b) = (before.tangent(true), after.tangent(false));
            let (la, lb) = (before.length(), after.length());
            let tangent = match la / lb {
                // A straight wall that runs into an arc has the say alone.
                ratio if ratio > WALL => a,
                ratio if ratio < 1.0 / WALL => b,
                // The arc through three points has its tangent nearer to the shorter chord's.
                _ => (a * lb + b * la).normalize(),
            };
            is_smooth(turn(a, b).abs()).then_some(tangent)
        };
        let rounded = pieces.iter().enumerate().flat_map(|(i, piece)| {
            let own = piece.tangent(false);
            let (start, end) = (shared(i).unwrap_or(own), shared(i + 1).unwrap_or(own));
            match piece {
                Piece::Segment(s) if start != own || end != own => biarc(s.from, start, s.to, end),
                _ => vec![*piece],
            }
        });
        Self::connected(rounded)
    }
}

/// One or two arcs with a common tangent from `a` along `ta` to `b` along `tb` (unit tangents).
pub fn biarc(a: Point, ta: Point, b: Point, tb: Point) -> Vec<Piece> {
    let v = b - a;
    let t = ta + tb;
    // Equal tangent lengths d: 2d²(1 − ta·tb) + 2d v·t − v² = 0.
    let (p, q, r) = (2.0 * (1.0 - ta.dot(&tb)), 2.0 * v.dot(&t), v.norm_squared());
    let d = 2.0 * r / (q + (q * q + 4.0 * p * r).sqrt());
    let joint = 0.5 * ((a + d * ta) + (b - d * tb));
    match (tangent_arc(a, ta, joint), tangent_arc(b, -tb, joint)) {
        (Some(first), Some(second)) => {
            let second = Arc::new(second.center, second.radius, second.start + second.sweep, -second.sweep);
            if (first.center - second.center).norm() < 1e-9 * first.radius {
                return vec![Piece::arc(first.center, first.radius, first.start, first.sweep + second.sweep)];
            }
            vec![Piece::Arc(first), Piece::Arc(second)]
        }
        // Straight to within round-off.
        _ => vec![Piece::line(a, b)],
    }
}

fn tangent_arc(a: Point, t: Point, b: Point) -> Option<Arc> {
    let chord = b - a;
    let normal = turned(t);
    let offset = normal.dot(&chord);
    if offset.abs() < 0.1 * STRAIGHT * chord.norm() {
        return None;
    }
    let signed_radius = chord.norm_squared() / (2.0 * offset);
    let center = a + signed_radius * normal;
    let (from, to) = (a - center, b - center);
    Some(Arc::new(center, signed_radius.abs(), from.y.atan2(from.x), turn(from, to)))
}
