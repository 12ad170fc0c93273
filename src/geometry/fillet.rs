//! Corners rounded by an arc that is tangent to both sides.

use super::{Arc, Piece, Point, crossing::carriers, crossing::common, turn};

/// Turn below which a vertex has no corner \[rad\].
const STRAIGHT: f64 = 1e-9;

/// Error: the segments at a vertex have no room for its fillet.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("a fillet of {radius:.4} mm does not fit at r = {:.4} mm, z = {:.4} mm: at most {largest:.4} mm", at.x, at.y)]
pub struct FilletTooLarge {
    /// Index of the point.
    pub vertex: usize,
    /// Position of the vertex \[mm\].
    pub at: Point,
    /// Requested radius \[mm\].
    pub radius: f64,
    /// Largest radius that fits when larger neighbours shrink along with it \[mm\].
    pub largest: f64,
}

/// Chain through `points` \[mm\] with vertex `i` rounded by `radii[i]` \[mm\]; 0 leaves it sharp.
/// Fails when the tangent lengths R tan(turn/2) of two neighbours are longer than the segment between them.
pub fn fillet(points: &[Point], radii: &[f64]) -> Result<Vec<Piece>, FilletTooLarge> {
    let sides: Vec<Piece> = points.windows(2).map(|w| Piece::line(w[0], w[1])).collect();
    // Tangent length per radius; 0 at the ends.
    let at_vertex = |w: &[Piece]| (0.5 * turn(w[0].tangent(true), w[1].tangent(false)).abs()).tan();
    let tangent: Vec<f64> = [0.0].into_iter().chain(sides.windows(2).map(at_vertex)).chain([0.0]).collect();
    for (i, side) in sides.iter().enumerate() {
        if radii[i] * tangent[i] + radii[i + 1] * tangent[i + 1] > side.length() * (1.0 + 1e-12) {
            let larger = |j: usize| if tangent[j] > 0.0 { radii[j] } else { 0.0 };
            let vertex = if larger(i + 1) > larger(i) { i + 1 } else { i };
            let room = |side: usize, neighbour: usize| {
                let (length, own, its) = (sides[side].length(), tangent[vertex], tangent[neighbour]);
                let shared = length / (own + its);
                if shared <= radii[neighbour] { shared } else { (length - radii[neighbour] * its) / own }
            };
            let largest = room(vertex - 1, vertex - 1).min(room(vertex, vertex + 1));
            return Err(FilletTooLarge { vertex, at: points[vertex], radius: radii[vertex], largest });
        }
    }
    let (mut pieces, mut here) = (Vec::new(), points[0]);
    for i in 1..sides.len() {
        let (before, after, radius) = (&sides[i - 1], &sides[i], radii[i]);
        let turn = turn(before.tangent(true), after.tangent(false));
        let is_round = radius > 0.0 && turn.abs() >= STRAIGHT;
        let arc = is_round.then(|| parallel_arc(before, after, radius * turn.signum())).flatten();
        pieces.push(Piece::line(here, arc.map_or(points[i], |arc| arc.at(0.0))));
        here = arc.map_or(points[i], |arc| arc.at(1.0));
        pieces.extend(arc.map(Piece::Arc));
    }
    pieces.push(Piece::line(here, points[points.len() - 1]));
    pieces.retain(|piece| piece.length() > super::piece::SHORTEST);
    Ok(pieces)
}

/// Two lines and an arc between them, with another radius of the arc \[mm\]; `None` of other pieces, or without room.
pub fn with_radius(pieces: &[Piece], radius: f64) -> Option<[Piece; 3]> {
    let [before @ Piece::Segment(_), Piece::Arc(_), after @ Piece::Segment(_)] = pieces else { return None };
    let corner =
        carriers(before, after).into_iter().find(|at| (at - before.last()).dot(&before.tangent(true)) > 0.0)?;
    fillet(&[before.first(), corner, after.last()], &[0.0, radius, 0.0]).ok()?.try_into().ok()
}

/// Arc from one piece into another, its centre at the distance `side` on the left of both \[mm\].
pub(super) fn parallel_arc(before: &Piece, after: &Piece, side: f64) -> Option<Arc> {
    let centers = common(&before.parallel(side)?, &after.parallel(side)?);
    let distance = |p: &Point| (p - before.last()).norm_squared();
    let center = centers.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    let (from, to) = (before.closest_point(center) - center, after.closest_point(center) - center);
    Some(Arc::new(center, side.abs(), from.y.atan2(from.x), turn(from, to)))
}
