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

use super::ImportError;
use super::chain::Chain;
use super::dxf::Source;
use super::frame::Frame;
use super::layers::ToolId;
use super::options::Heading;
use crate::geometry::{Piece, Point};
use crate::model::Role;
use std::rc::Rc;

/// Least distance of the middles of tools above each other, over the height of the lower one \[–\].
const APART: f64 = 0.1;

pub(super) fn is_outline(chain: &Chain) -> bool {
    chain.is_closed || chain.first().x == 0.0 && chain.last().x == 0.0
}

/// Direction of the punch from places: punch and holder are behind the sheet, the die is ahead of it.
pub(super) fn heading(chains: &[(ToolId, Chain)]) -> Option<(Heading, String)> {
    let dies = chains.iter().filter(|(tool, _)| tool.role == Role::Die);
    let mut pairs = dies.flat_map(|(die, of_die)| {
        let others = chains.iter().filter(|(tool, _)| tool.role != Role::Die && tool.operation == die.operation);
        others.map(move |(tool, chain)| (tool, chain.bounds(), of_die.bounds()))
    });
    pairs.find_map(|(tool, other, die)| {
        let rise = 0.5 * (other.low.y + other.high.y - die.low.y - die.high.y);
        let least = (other.high.y - other.low.y).min(die.high.y - die.low.y);
        let (heading, side) = if rise > 0.0 { (Heading::Down, "above") } else { (Heading::Up, "below") };
        (rise.abs() > APART * least).then(|| (heading, format!("the {tool} is {side} the die")))
    })
}

/// Two measures of a point, the second one among those with nearly the largest first.
type Measure<'a> = &'a dyn Fn(Point) -> [f64; 2];

pub(super) fn sheet_side(tool: ToolId, chain: Chain, heading: Heading, frame: &Frame) -> Result<Chain, ImportError> {
    // Larger where nearer to the sheet.
    let height = |p: Point| if (tool.role == Role::Die) == (heading == Heading::Down) { p.y } else { -p.y };
    let back_inner: Measure = &|p| [-height(p), -p.x];
    let back_outer: Measure = &|p| [-height(p), p.x];
    let face_outer: Measure = &|p| [p.x, height(p)];
    let is_closed = chain.is_closed;
    let chain = if is_closed {
        // Walked so that the face of a punch comes after its inner wall, and that of a die before.
        let chain = if (area(&chain) > 0.0) == (heading == Heading::Down) { chain } else { chain.reversed() };
        let [before, after] = split(&chain, if tool.role == Role::Die { face_outer } else { back_inner }, frame.join);
        Chain { pieces: [after, before].concat(), ..chain }
    } else if height(chain.first()) >= height(chain.last()) {
        chain
    } else {
        chain.reversed()
    };
    let end = match (tool.role, is_closed) {
        (Role::Die, true) => back_inner,
        (Role::Punch, _) => back_outer,
        (Role::Die, false) | (Role::Holder, _) => face_outer,
    };
    let [before, _] = split(&chain, end, frame.join);
    let pieces = if before.is_empty() { chain.pieces.clone() } else { before };
    let side = Chain { pieces, is_closed: false };
    let (a, b) = (frame.place(side.first()), frame.place(side.last()));
    if (side.first() - side.last()).norm() <= frame.join {
        let what = format!("no side of the {tool}'s outline meets the sheet: it would begin and end at {a}");
        return Err(ImportError::new(what, "draw the side that meets the sheet as an open line"));
    }
    frame.note(format!("the {tool} is drawn all round: the side towards the sheet is read, from {a} to {b}"));
    Ok(side)
}

/// Twice the enclosed area, positive if counter-clockwise \[mm²\]; chords of arcs keep its sign.
fn area(chain: &Chain) -> f64 {
    let points: Vec<Point> = chain.pieces().flat_map(|piece| piece.sample(8)).collect();
    points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.perp(b)).sum()
}

/// Pieces before and after the point with the largest first measure, and within `join` of it the largest second one.
fn split(chain: &Chain, by: Measure, join: f64) -> [Vec<(Piece, Rc<Source>)>; 2] {
    let points = chain
        .pieces()
        .enumerate()
        .flat_map(|(i, piece)| [piece.first(), piece.last()].into_iter().chain(piece.poles()).map(move |p| (i, p)));
    let points: Vec<(usize, Point)> = points.collect();
    let most = points.iter().map(|(_, p)| by(*p)[0]).fold(f64::NEG_INFINITY, f64::max);
    let first = points.into_iter().filter(|(_, p)| by(*p)[0] >= most - join);
    let (i, at) = first.max_by(|a, b| by(a.1)[1].total_cmp(&by(b.1)[1])).expect("a chain has pieces");
    let (piece, source) = &chain.pieces[i];
    let [a, b] = halves(piece, at, join).map(|half| half.map(|piece| (piece, source.clone())));
    let before = chain.pieces[..i].iter().cloned().chain(a).collect();
    [before, b.into_iter().chain(chain.pieces[i + 1..].iter().cloned()).collect()]
}

fn halves(piece: &Piece, at: Point, join: f64) -> [Option<Piece>; 2] {
    if (at - piece.first()).norm() <= join {
        return [None, Some(*piece)];
    }
    if (at - piece.last()).norm() <= join { [Some(*piece), None] } else { piece.split(at) }
}
