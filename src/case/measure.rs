//! Sizes read off a tool's section, however it was drawn.

use crate::geometry::{Piece, Point, Profile};
use crate::model::{Geometry, Role, Tool};

/// Smallest and largest r of a tool \[mm\].
pub fn extent(tool: &Tool) -> (f64, f64) {
    let points = tool.profile.polyline(0.01);
    points.iter().fold((f64::INFINITY, 0.0), |(low, high), p| (p.x.min(low), p.x.max(high)))
}

/// What a distance from the axis or symmetry plane is called, as a size of a part.
pub fn across(geometry: Geometry) -> &'static str {
    match geometry {
        Geometry::Axisymmetric => "radius",
        Geometry::PlaneStrain => "half-width",
    }
}

/// Radius or half-width of the die's opening \[mm\]; `None` for a die with a bottom, which reaches the axis.
pub fn throat(die: &Tool) -> Option<f64> {
    (die.profile.last().x > 1e-6).then(|| extent(die).0)
}

/// How close two tools are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    /// Smallest signed distance [mm], negative where one is inside the other.
    pub distance: f64,
    /// Where, as tools are placed [mm].
    pub at: Point,
}

/// The gap between two tools when the punch has gone up by `travel` [mm]. Arcs and long lines are sampled: their
/// chords are short of them by 3e-6 of the radius.
pub(super) fn gap(a: &Tool, b: &Tool, travel: f64) -> Gap {
    let placed = |tool: &Tool| tool.profile.shifted(if tool.role == Role::Punch { travel } else { 0.0 });
    let (a, b) = (placed(a), placed(b));
    let one_way = |from: &Profile, to: &Profile| {
        let points = from.pieces().iter().flat_map(|piece| piece.sample(samples(piece)));
        let gaps = points.filter_map(|at| {
            let closest = to.closest(at);
            let foot = at - closest.distance * closest.normal;
            // Beyond the ends of a line no side is drawn.
            (closest.distance >= 0.0 || !to.ends_at(foot)).then_some(Gap { distance: closest.distance, at })
        });
        gaps.min_by(|a, b| a.distance.total_cmp(&b.distance))
    };
    let nearest = [one_way(&a, &b), one_way(&b, &a)].into_iter().flatten();
    nearest.min_by(|a, b| a.distance.total_cmp(&b.distance)).unwrap_or(Gap { distance: f64::INFINITY, at: a.first() })
}

/// Intervals that a piece is looked at in.
fn samples(piece: &Piece) -> usize {
    match piece {
        Piece::Segment(_) => 8,
        Piece::Arc(a) => (a.sweep.abs() / 0.005).ceil().max(1.0) as usize,
    }
}

/// Where the die's corners end and its flat begins [mm].
pub(super) fn shoulder_end(die: &Tool) -> f64 {
    die.profile.corners().map(|a| a.at(0.0).x.max(a.at(1.0).x)).fold(extent(die).0, f64::max)
}
