//! Sizes of tools measured on their sections.

use super::{Geometry, Model, Role, Tool};
use crate::geometry::{Piece, Point, Profile, Segment};
use crate::numerics::bisect;

/// Smallest and largest distance of a tool from the axis \[mm\].
pub fn extent(tool: &Tool) -> (f64, f64) {
    tool.profile.polyline(0.01).iter().fold((f64::INFINITY, 0.0), |(low, high), p| (p.x.min(low), p.x.max(high)))
}

/// Sampling of arcs \[rad\] and number of parts of a line.
const FINE: f64 = 0.005;
const PARTS: usize = 8;
/// Step of the search for contact over the thickness \[–\], and bisections of the last one.
const APPROACH: f64 = 0.25;
const HALVINGS: usize = 50;
/// Rounding of coordinates \[mm\].
const ROUNDED: f64 = 1e-6;

/// [`mouth`] at the full travel \[mm\]; a punch meets the edge of a hole first.
pub fn full_mouth(model: &Model, punch: &Tool) -> f64 {
    let front = |from: f64| punch.profile.extreme(true, [from, 1e6]).map_or(0.0, |point| point.y);
    mouth(punch, model.travel + front(0.0) - front(model.blank.hole))
}

/// Largest r of a punch down to `depth` behind its foremost point \[mm\]: the mouth of the part at this travel. A rounding counts
/// as a whole, so that a straight-walled punch has its wall from the start.
pub fn mouth(punch: &Tool, depth: f64) -> f64 {
    let pieces = punch.profile.pieces();
    let level = punch.profile.polyline(0.01).iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max) - depth;
    let last = pieces.iter().rposition(|piece| piece.first().y.max(piece.last().y) >= level - ROUNDED);
    let last = last.unwrap_or(0);
    let roundings = pieces[last..].iter().take_while(|piece| matches!(piece, Piece::Arc(_))).count();
    let passed = pieces[..last + roundings].iter().flat_map(|piece| piece.polyline(FINE)).map(|p| p.x);
    let cut = match pieces[last] {
        Piece::Segment(line) if line.to.y < level => {
            let share = ((line.from.y - level) / (line.from.y - line.to.y)).max(0.0);
            line.from.x + share * (line.to.x - line.from.x).max(0.0)
        }
        Piece::Segment(line) => line.from.x.max(line.to.x),
        Piece::Arc(_) => 0.0,
    };
    passed.fold(cut, f64::max)
}

/// True if a punch is wider behind the part that goes through the flat sheet on its travel \[mm\].
pub fn widens(punch: &Tool, travel: f64) -> bool {
    mouth(punch, travel) < extent(punch).1 - ROUNDED
}

/// Radius or half-width of the die's opening \[mm\]; `None` for a die with a bottom, which reaches the axis.
pub fn throat(die: &Tool) -> Option<f64> {
    (die.profile.last().x > 1e-6).then(|| extent(die).0)
}

/// Name of a punch that forms the end of a tube: both ends of a groove are open upward, the bore of a nosing die goes down.
pub fn name_on_tube(punch: &Tool) -> &'static str {
    match punch.profile.ends() {
        [Some((_, inner)), Some((_, outer))] if inner.y > 0.5 && outer.y > 0.5 => "groove",
        [Some((_, inner)), _] if inner.y < -0.5 => "nosing die",
        _ => "punch",
    }
}

/// True of a round punch and a die with a bottom that are both as wide as the flat blank.
pub fn embosses(model: &Model) -> bool {
    let is_wide = |punch: &Tool| model.blank.meridian.is_none() && extent(punch).1 >= model.blank.length;
    let is_closed = model.tool(Role::Die).is_some_and(|die| throat(die).is_none());
    model.geometry == Geometry::Axisymmetric && is_closed && model.tool(Role::Punch).is_some_and(is_wide)
}

/// Smallest distance of two tools at a travel of the punch \[mm\], negative where they overlap, and the place \[mm\].
pub(crate) fn gap(a: &Tool, b: &Tool, travel: f64) -> (f64, Point) {
    apart([a, b], [a, b].map(|tool| Point::new(0.0, if tool.role == Role::Punch { travel } else { 0.0 })))
}

/// [`gap`] of two tools that have moved.
pub(crate) fn apart([a, b]: [&Tool; 2], moved: [Point; 2]) -> (f64, Point) {
    let (distance, at) = a.profile.distance_by(&b.profile, moved[0] - moved[1], FINE, PARTS);
    (distance, at + moved[1])
}

/// Travel of the punch at which it is closer than `least` to another tool \[mm\], at most `most`.
pub(crate) fn room(punch: &Tool, other: &Tool, least: f64, most: f64) -> f64 {
    bisect(0.0, most, 30, |travel| gap(punch, other, travel).0 >= least)[0]
}

/// True if punch and die leave room for a sheet at a travel, both touching it when it is flat; its edge and thickness \[mm\].
pub(crate) fn has_room(punch: &Tool, die: &Tool, [edge, thickness]: [f64; 2], travel: f64) -> bool {
    let placed = |tool: &Tool, highest: bool, z: f64| {
        let touching = tool.profile.extreme(highest, [0.0, edge]).map_or(0.0, |p| p.y);
        Tool { profile: tool.profile.shifted(z - touching), ..tool.clone() }
    };
    let (punch, die) = (placed(punch, true, -0.5 * thickness), placed(die, false, 0.5 * thickness));
    gap(&punch, &die, travel).0 >= thickness
}

/// Radius where the die's shoulder ends \[mm\]: at its outermost level's innermost line, else where its last corner ends.
pub(crate) fn shoulder_end(die: &Tool) -> f64 {
    let outermost = flats(die).max_by(|a, b| a.from.x.max(a.to.x).total_cmp(&b.from.x.max(b.to.x)));
    let at_level = flats(die).filter(|flat| outermost.is_some_and(|outer| (flat.to.y - outer.to.y).abs() < ROUNDED));
    let inner = at_level.map(|flat| flat.from.x.min(flat.to.x)).reduce(f64::min).filter(|_| throat(die).is_some());
    let corners = die.profile.corners().map(|arc| arc.at(0.0).x.max(arc.at(1.0).x));
    inner.unwrap_or_else(|| corners.fold(extent(die).0, f64::max))
}

fn flats(tool: &Tool) -> impl Iterator<Item = Segment> {
    tool.profile.pieces().iter().filter_map(|piece| match piece {
        Piece::Segment(line) if (line.to.y - line.from.y).abs() < ROUNDED => Some(*line),
        _ => None,
    })
}

/// Displacement of a tool from above (1) or below (−1) until `apart` from a sheet of points, half as thick \[mm\].
pub fn met(tool: &Profile, side: f64, sheet: &[(Point, f64)], [t, apart]: [f64; 2]) -> f64 {
    let towards = -side;
    let z = || sheet.iter().map(|(x, _)| x.y);
    let (low, high) = (z().fold(f64::INFINITY, f64::min), z().fold(f64::NEG_INFINITY, f64::max));
    let tip = tool.polyline(t).iter().map(|p| towards * p.y).fold(f64::NEG_INFINITY, f64::max) * towards;
    let from = if towards > 0.0 { low } else { high } - towards * 2.0 * t - tip;
    let most = high - low + 4.0 * t;
    let touches = |way: f64| {
        let moved = Point::new(0.0, from + towards * way);
        sheet.iter().any(|(x, half)| tool.closest(x - moved).distance - half < apart)
    };
    let steps = (most / (APPROACH * t)).ceil() as usize;
    let way = |k: usize| APPROACH * t * k as f64;
    let Some(hit) = (1..=steps).find(|&k| touches(way(k))) else { return from + towards * most };
    let [free, _] = bisect(way(hit - 1), way(hit), HALVINGS, |way| !touches(way));
    from + towards * free
}
