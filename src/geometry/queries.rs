//! Corners, vertices, ends, extreme points and distances of profiles.

use super::{Arc, Piece, Point, Profile, crossing::common, turn};

/// Largest turn between two arcs of one corner \[rad\].
const SMOOTH: f64 = 0.02;
/// Largest ratio of the radii of arcs of one corner \[–\].
const ALIKE: f64 = 1.5;
/// Most rises of a search, and the last one over the wanted distance \[–\].
const MOST_RISES: usize = 200;
const LAST_RISE: f64 = 1e-6;

/// Vertex between two pieces of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Position \[mm\].
    pub point: Point,
    /// Index of the piece before.
    pub after: usize,
    /// Turn of the chain \[rad\]: positive to the left, into a hollow; negative around a convex corner.
    pub turn: f64,
}

impl Profile {
    /// Rise along y at which the closest place of the profile is `apart` below or beside another \[mm\].
    pub fn rise_until(&self, other: &Self, apart: f64) -> f64 {
        let widen = |(low, high): (f64, f64), p: &Point| (low.min(p.y), high.max(p.y));
        let heights = |of: &Self| of.polyline(0.01).iter().fold((f64::INFINITY, f64::NEG_INFINITY), widen);
        let ((_, top), (face, end)) = (heights(self), heights(other));
        // Distances change no faster than the profile rises.
        let mut rise = face - top - apart;
        for _ in 0..MOST_RISES {
            let spare = self.distance_to(other, Point::new(0.0, rise)).0 - apart;
            if spare < LAST_RISE * apart || rise > end - top {
                break;
            }
            rise += spare;
        }
        rise
    }

    /// Convex corners in order; smoothly connected arcs of about one radius are one corner.
    pub fn corners(&self) -> impl Iterator<Item = Arc> {
        let mut corners: Vec<(usize, Arc)> = Vec::new();
        for (i, piece) in self.pieces.iter().enumerate() {
            let Piece::Arc(arc) = piece else { continue };
            if arc.sweep >= 0.0 {
                continue;
            }
            let goes_on = |(last, corner): &(usize, Arc)| {
                let turn = turn(self.pieces[*last].tangent(true), piece.tangent(false)).abs();
                let ratio = corner.radius / arc.radius;
                last + 1 == i && turn < SMOOTH && ratio < ALIKE && ratio > 1.0 / ALIKE
            };
            match corners.last_mut().filter(|last| goes_on(last)) {
                Some(last) => *last = (i, last.1.joined(arc)),
                None => corners.push((i, *arc)),
            }
        }
        corners.into_iter().map(|(_, corner)| corner)
    }

    /// Inner vertices in order, smooth ones included.
    pub fn vertices(&self) -> impl Iterator<Item = Vertex> {
        let turned = |pair: &[Piece]| turn(pair[0].tangent(true), pair[1].tangent(false));
        let pairs = self.pieces.windows(2).enumerate();
        pairs.map(move |(after, pair)| Vertex { point: pair[0].last(), after, turn: turned(pair) })
    }

    /// Smallest r of the chain \[mm\].
    pub fn least_r(&self) -> f64 {
        self.polyline(0.01).iter().map(|p| p.x).fold(f64::INFINITY, f64::min)
    }

    /// Smallest distance to another profile when moved by `shift` \[mm\], negative in overlap; arcs every 0.02 rad.
    pub fn distance_to(&self, other: &Self, shift: Point) -> (f64, Point) {
        self.distance_by(other, shift, 0.02, 1)
    }

    /// [`Self::distance_to`] with arcs sampled every `step` \[rad\] and lines in `parts`.
    pub fn distance_by(&self, other: &Self, shift: Point, step: f64, parts: usize) -> (f64, Point) {
        let points = |of: &Self| -> Vec<Point> {
            let is_line = |piece: &Piece| matches!(piece, Piece::Segment(_));
            let along = |piece: &Piece| if is_line(piece) { piece.sample(parts) } else { piece.polyline(step) };
            of.pieces.iter().flat_map(along).collect()
        };
        let mine = points(self).into_iter().map(|p| (other.closest(p + shift).distance, p + shift));
        let others = points(other).into_iter().map(|p| (self.closest(p - shift).distance, p));
        mine.chain(others).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, self.first() + shift))
    }

    /// Free ends of the line with their unit directions away from it; `None` on the axis and where it closes.
    pub fn ends(&self) -> [Option<(Point, Point)>; 2] {
        let [(_, first), (_, last)] = self.end_tangents();
        [(self.ends[0], -first), (self.ends[1], last)].map(|(end, away)| Some((end?, away)))
    }

    /// Highest (or lowest) point between two distances from the axis \[mm\]; `None` when the profile lies beyond them.
    pub fn extreme(&self, highest: bool, within: [f64; 2]) -> Option<Point> {
        let sign = if highest { 1.0 } else { -1.0 };
        let edges = within.map(|r| Piece::line(Point::new(r, -1e6), Point::new(r, 1e6)));
        let points = self.pieces().iter().flat_map(|piece| {
            let mut points: Vec<Point> = edges.iter().flat_map(|edge| common(piece, edge)).collect();
            points.extend([piece.first(), piece.last()]);
            if let Piece::Arc(a) = piece {
                points.push(piece.closest_point(a.center + Point::new(0.0, sign * 2.0 * a.radius)));
            }
            points
        });
        let [from, to] = within;
        points.filter(|p| (from - 1e-9..=to + 1e-9).contains(&p.x)).max_by(|a, b| (sign * a.y).total_cmp(&(sign * b.y)))
    }
}
