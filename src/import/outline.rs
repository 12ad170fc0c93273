//! Tools that are drawn all round: the side of the outline that meets the sheet.
//!
//! ```text
//!   punch, holder: from the back's inner end round the face        die: from the face's outer end
//!   to the back's outer end (of a holder, the face's)              to the back's inner end
//!
//!        A┌────────┐B                                  B'┐  ┌──────────┐A'        A, B farthest from the sheet
//!         │        │                                     │  │          │          A', of those farthest out the one
//!         └────────┘  ── sheet ──                        └──┘          ┘              nearest to the sheet
//! ```
//!
//! Of a body that is drawn as far as the axis, the inner end is where its face meets the axis.

use super::chain::Chain;
use super::error::ImportError;
use super::frame::Frame;
use super::options::Heading;
use super::parts::Part;
use super::stroke::Stroke;
use crate::geometry::{Arc, Bounds, Piece, Point};
use crate::model::Role;

/// Least distance of the middles of tools above each other, over the height of the lower one \[–\].
const APART: f64 = 0.1;

/// Whether a line is closed, or begins and ends on the axis.
pub(super) fn is_outline(chain: &Chain) -> bool {
    chain.is_closed || chain.first().x == 0.0 && chain.last().x == 0.0
}

/// Direction of the punch from places: punch and holder are behind the sheet, the die is ahead of it.
pub(super) fn heading(chains: &[(Part, Chain)]) -> Option<(Heading, String)> {
    let bounds = |chain: &Chain| {
        let pieces: Vec<Piece> = chain.pieces().map(|(piece, _)| *piece).collect();
        Bounds::around(&pieces).expect("a chain has pieces")
    };
    let dies = chains.iter().filter(|(part, _)| part.role == Role::Die);
    let pairs = dies.flat_map(|(die, of_die)| {
        let others = chains.iter().filter(|(part, _)| part.role != Role::Die && part.operation == die.operation);
        others.map(move |(part, chain)| (part, bounds(chain), bounds(of_die)))
    });
    let mut told = pairs.filter_map(|(part, other, die)| {
        let rise = 0.5 * (other.low.y + other.high.y - die.low.y - die.high.y);
        let least = (other.high.y - other.low.y).min(die.high.y - die.low.y);
        let heading = if rise > 0.0 { Heading::Down } else { Heading::Up };
        let side = if rise > 0.0 { "above" } else { "below" };
        (rise.abs() > APART * least).then(|| (heading, format!("the {} is {side} the die", part.name())))
    });
    told.next()
}

/// Side of an outline towards the sheet, as an open line.
pub(super) fn sheet_side(
    part: Part,
    chain: Chain,
    heading: Heading,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Chain, ImportError> {
    // Larger where nearer to the sheet.
    let ahead = if heading == Heading::Down { -1.0 } else { 1.0 };
    let toward = if part.role == Role::Die { -ahead } else { ahead };
    let near = |p: Point| toward * p.y;
    let back_inner = |p: Point| [-near(p), -p.x];
    let back_outer = |p: Point| [-near(p), p.x];
    let face_outer = |p: Point| [p.x, near(p)];
    let chain = if chain.is_closed {
        // Walked so that the face of a punch comes after its inner wall, and that of a die before.
        let chain = if (area(&chain) > 0.0) == (heading == Heading::Down) { chain } else { chain.reversed() };
        let start: &dyn Fn(Point) -> [f64; 2] = if part.role == Role::Die { &face_outer } else { &back_inner };
        from(chain, start, frame.join)
    } else if near(chain.first()) >= near(chain.last()) {
        chain
    } else {
        chain.reversed()
    };
    let end: &dyn Fn(Point) -> [f64; 2] = match (part.role, chain.is_closed) {
        (Role::Die, true) => &back_inner,
        (Role::Punch, _) => &back_outer,
        (Role::Die, false) | (Role::Holder, _) => &face_outer,
    };
    let side = up_to(chain, end, frame.join);
    let (name, a, b) = (part.name(), frame.place(side.first()), frame.place(side.last()));
    if (side.first() - side.last()).norm() <= frame.join {
        let what = format!("no side of the {name}'s outline meets the sheet: it would begin and end at {a}");
        return Err(ImportError::new(what, "draw the side that meets the sheet as an open line"));
    }
    notes.push(format!("the {name} is drawn all round: the side towards the sheet is read, from {a} to {b}"));
    Ok(side)
}

/// Twice the enclosed area, positive if counter-clockwise \[mm²\]; chords of arcs keep its sign.
fn area(chain: &Chain) -> f64 {
    let points: Vec<Point> = chain.pieces().flat_map(|(piece, _)| piece.sample(8)).collect();
    points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.perp(b)).sum()
}

/// Stroke, piece and point of a chain.
type Spot = (usize, usize, Point);

/// Point with the largest first measure, and within `near` of it the largest second one.
fn largest(chain: &Chain, by: &dyn Fn(Point) -> [f64; 2], near: f64) -> Spot {
    let spots = chain.strokes.iter().enumerate().flat_map(|(i, stroke)| {
        stroke.pieces.iter().enumerate().flat_map(move |(j, piece)| corners(piece).map(move |p| (i, j, p)))
    });
    let spots: Vec<Spot> = spots.collect();
    let most = spots.iter().map(|(_, _, p)| by(*p)[0]).fold(f64::NEG_INFINITY, f64::max);
    let first = spots.into_iter().filter(|(_, _, p)| by(*p)[0] >= most - near);
    first.max_by(|a, b| by(a.2)[1].total_cmp(&by(b.2)[1])).expect("a chain has pieces")
}

/// Ends of a piece, and the points of an arc where it is parallel to x or y.
fn corners(piece: &Piece) -> impl Iterator<Item = Point> + use<> {
    let poles = match piece {
        Piece::Arc(arc) => [Point::x(), Point::y(), -Point::x(), -Point::y()]
            .map(|way| Some(arc.center + arc.radius * way).filter(|pole| arc.faces(*pole))),
        Piece::Segment(_) => [None; 4],
    };
    [piece.first(), piece.last()].into_iter().chain(poles.into_iter().flatten())
}

fn split(chain: Chain, (i, j, at): Spot, join: f64) -> [Vec<Stroke>; 2] {
    let mut before = chain.strokes;
    let mut after = before.split_off(i);
    let Stroke { pieces, from } = after.remove(0);
    let (mut first, mut rest) = (pieces[..j].to_vec(), pieces[j + 1..].to_vec());
    let [a, b] = halves(&pieces[j], at, join);
    first.extend(a);
    rest.splice(..0, b);
    let stroke = |pieces: Vec<Piece>| (!pieces.is_empty()).then(|| Stroke { pieces, from: from.clone() });
    before.extend(stroke(first));
    after.splice(..0, stroke(rest));
    [before, after]
}

fn halves(piece: &Piece, at: Point, join: f64) -> [Option<Piece>; 2] {
    if (at - piece.first()).norm() <= join {
        return [None, Some(*piece)];
    }
    if (at - piece.last()).norm() <= join {
        return [Some(*piece), None];
    }
    let Piece::Arc(arc) = piece else { return [Some(*piece), None] };
    let part = |from, to| Piece::Arc(Arc::between(from, to, arc.center, arc.sweep > 0.0).0);
    [Some(part(piece.first(), at)), Some(part(at, piece.last()))]
}

fn from(chain: Chain, by: &dyn Fn(Point) -> [f64; 2], join: f64) -> Chain {
    let spot = largest(&chain, by, join);
    let [before, after] = split(chain, spot, join);
    Chain { strokes: after.into_iter().chain(before).collect(), is_closed: true }
}

fn up_to(chain: Chain, by: &dyn Fn(Point) -> [f64; 2], join: f64) -> Chain {
    let spot = largest(&chain, by, join);
    let [before, _] = split(chain.clone(), spot, join);
    Chain { strokes: if before.is_empty() { chain.strokes } else { before }, is_closed: false }
}
