//! Section of a tool: chain of pieces with signed distance, normal and curvature.

use super::{Piece, Point, on_axis, piece::Foot, piece::SHORTEST, turned};

/// Largest gap between consecutive pieces \[mm\].
pub(super) const GAP: f64 = 1e-6;

/// Distance of an end over the depth below which a point has come round that end \[–\]: a tool is solid up to 45° behind it.
const ROUND_THE_END: f64 = std::f64::consts::SQRT_2;

/// A connected chain of pieces, the sheet on its left. See the [module](crate::geometry) for frame and sign.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    pub(super) pieces: Vec<Piece>,
    /// Mean outward normals at the vertices, one more than pieces; they decide the sign at a corner.
    vertex_normals: Vec<Point>,
    /// Free ends: neither on the axis nor where the line closes.
    pub(super) ends: [Option<Point>; 2],
}

/// Closest point of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest {
    /// Signed distance \[mm\]: positive on the sheet's side.
    pub distance: f64,
    /// Gradient of the distance, a unit vector from the tool to the sheet.
    pub normal: Point,
    /// ∇²d = curvature · ττᵀ \[1/mm\]; positive over a convex corner.
    pub curvature: f64,
    /// Index of the piece.
    pub piece: usize,
}

/// Closest piece of a profile, and the way that a point may move before another can be closer \[mm\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nearest {
    piece: usize,
    room: f64,
}

/// Round-off of distances \[mm\].
const ROUNDED: f64 = 1e-9;

/// Reason why a chain of pieces is not a profile.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct ProfileError(String);

impl Profile {
    /// Joins pieces into a profile. Fails without a piece, with one of no length, or where they are 1e-6 mm apart.
    pub fn new(pieces: Vec<Piece>) -> Result<Self, ProfileError> {
        if pieces.is_empty() {
            return Err(ProfileError("a profile needs at least one piece".into()));
        }
        for (index, piece) in pieces.iter().enumerate() {
            let first = piece.first();
            let at = || format!("r = {:.4} mm, z = {:.4} mm", first.x, first.y);
            if piece.length().is_nan() || piece.length() <= SHORTEST {
                return Err(ProfileError(format!("piece {index} has no length (it starts and ends at {})", at())));
            }
            let gap = if index > 0 { (first - pieces[index - 1].last()).norm() } else { 0.0 };
            if gap > GAP {
                let away = format!("piece {index} starts {gap:.3e} mm away from the end of the piece before it");
                return Err(ProfileError(format!("{away} ({})", at())));
            }
        }
        let n = pieces.len();
        let vertex_normals = (0..=n).map(|v| {
            let before = if v > 0 { turned(pieces[v - 1].tangent(true)) } else { Point::zeros() };
            let after = if v < n { turned(pieces[v].tangent(false)) } else { Point::zeros() };
            (before + after).normalize()
        });
        let vertex_normals = vertex_normals.collect();
        let ends = [pieces[0].first(), pieces[n - 1].last()];
        let closes = (ends[1] - ends[0]).norm() <= GAP;
        Ok(Self { pieces, vertex_normals, ends: ends.map(|end| (!closes && !on_axis(&end)).then_some(end)) })
    }

    pub(super) fn connected(pieces: impl IntoIterator<Item = Piece>) -> Self {
        Self::new(pieces.into_iter().collect()).expect("a connected chain")
    }

    /// The pieces in order.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Signed distance, normal and curvature at `x` \[mm\]; exact for segments, arcs and corners.
    ///
    /// Beyond a free end, or where it is nearer than √2 times the depth, a point is outside at its distance from it:
    ///
    /// ```text
    ///      d > 0      :  d > 0, from the end
    ///   ──────────────•
    ///      d < 0     ╱
    ///              ╱ 45°   d > 0, from the end
    /// ```
    pub fn closest(&self, x: Point) -> Closest {
        self.seen_from(x, self.nearest(x).piece)
    }

    /// [`Self::closest`] for a point that has `moved` \[mm\] since `known`, which is updated.
    pub fn closest_after(&self, x: Point, moved: f64, known: &mut Nearest) -> Closest {
        // Distances change no faster than the point moves.
        let stays = moved < known.room - ROUNDED;
        *known = if stays { Nearest { room: known.room - moved, ..*known } } else { self.nearest(x) };
        self.seen_from(x, known.piece)
    }

    fn seen_from(&self, x: Point, piece: usize) -> Closest {
        let best = self.on_line(x, piece);
        if best.distance >= 0.0 { best } else { self.round_an_end(x, &best).unwrap_or(best) }
    }

    /// Closest point for an `x` behind the line that has come round an end.
    #[cold]
    fn round_an_end(&self, x: Point, behind: &Closest) -> Option<Closest> {
        let away = self.ends.iter().flatten().map(|end| x - end).min_by(|a, b| a.norm().total_cmp(&b.norm()))?;
        let distance = away.norm();
        let is_round = distance < ROUND_THE_END * -behind.distance;
        is_round.then(|| Closest { distance, normal: away / distance, curvature: 1.0 / distance, piece: behind.piece })
    }

    fn nearest(&self, x: Point) -> Nearest {
        let (mut piece, mut square, mut next) = (0, f64::INFINITY, f64::INFINITY);
        for (index, candidate) in self.pieces.iter().enumerate() {
            let its = match candidate.foot(x) {
                Foot::Interior { distance } => distance * distance,
                Foot::End { point, .. } => (x - point).norm_squared(),
            };
            if its < square { (piece, square, next) = (index, its, square) } else { next = next.min(its) }
        }
        Nearest { piece, room: 0.5 * (next.sqrt() - square.sqrt()) }
    }

    /// Closest point of a piece, with the side of a line that goes on straight beyond its ends.
    fn on_line(&self, x: Point, piece: usize) -> Closest {
        match self.pieces[piece].foot(x) {
            Foot::Interior { distance } => {
                let (normal, curvature) = self.pieces[piece].facing(x);
                Closest { distance, normal, curvature, piece }
            }
            Foot::End { first, point } => {
                let outward = self.vertex_normals[if first { piece } else { piece + 1 }];
                let away = x - point;
                let distance = away.norm();
                if distance < 1e-12 {
                    return Closest { distance: 0.0, normal: outward, curvature: 0.0, piece };
                }
                let side = if away.dot(&outward) >= 0.0 { 1.0 } else { -1.0 };
                let curvature = side / distance;
                Closest { distance: side * distance, normal: away * curvature, curvature, piece }
            }
        }
    }

    /// First point of the chain \[mm\].
    pub fn first(&self) -> Point {
        self.pieces[0].first()
    }

    /// Last point of the chain \[mm\].
    pub fn last(&self) -> Point {
        self.pieces[self.pieces.len() - 1].last()
    }

    /// Length of the chain \[mm\].
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(Piece::length).sum()
    }

    /// Point at a length along the chain \[mm\] and the direction there; the end of the chain beyond it.
    pub fn at(&self, mut length: f64) -> (Point, Point) {
        for piece in &self.pieces {
            if length <= piece.length() {
                return piece.at(length);
            }
            length -= piece.length();
        }
        (self.last(), self.pieces[self.pieces.len() - 1].tangent(true))
    }

    /// Profile moved by `dz` \[mm\] along z.
    pub fn shifted(&self, dz: f64) -> Self {
        Self::connected(self.pieces().iter().map(|piece| piece.image(|p| p + Point::new(0.0, dz), |angle| angle, 1.0)))
    }

    /// Line walked the other way: the sheet's side becomes the tool's.
    pub fn reversed(&self) -> Self {
        Self::connected(self.pieces().iter().rev().map(Piece::reversed))
    }

    /// Mirror image in the plane z = 0, the sheet on the left again: a punch becomes a die.
    pub fn mirrored(&self) -> Self {
        Self::connected(self.pieces().iter().rev().map(|piece| piece.upside_down().reversed()))
    }

    /// Polyline for drawing: arcs sampled every `step` radians or finer.
    pub fn polyline(&self, step: f64) -> Vec<Point> {
        let rest = self.pieces.iter().flat_map(|piece| piece.polyline(step).into_iter().skip(1));
        std::iter::once(self.first()).chain(rest).collect()
    }
}
