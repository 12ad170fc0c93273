//! Direction of the punch, and the sheet on the left of every section.
//!
//! Tools that are drawn all round: the side of the outline that meets the sheet.
//!
//! ```text
//!   punch, holder: from the back's inner end round the face        die: from the face's outer end
//!   to the back's outer end (of a holder, the face's)              to the back's inner end; a pad is a punch upside down
//!
//!        A┌────────┐B                                  B'┐  ┌──────────┐A'        A, B farthest from the sheet
//!         │        │                                     │  │          │          A', of those farthest out the one
//!         └────────┘  ── sheet ──                        └──┘          ┘              nearest to the sheet
//! ```
//!
//! Of a body that is drawn as far as the axis, the inner end is where its face meets the axis.

use super::dxf::{Source, cut};
use super::layers::{ToolId, count_entities, list};
use super::{ImportError, Result, Section, chain::Chain, ensure, frame::Frame, options::Heading};
use crate::geometry::{Bounds, Fold, Piece, Point, Profile};
use crate::model::Role;
use std::{collections::BTreeSet, rc::Rc};

/// Least height of a wall \[mm\].
const WALL: f64 = 1e-3;
/// Least distance of the middles of tools above each other, over the height of the lower one \[–\].
const APART: f64 = 0.1;

/// Direction of the punch: the known one, or that of the walls, or that of the tools' places.
///
/// A punch's body lies behind its face, so that its outer end is behind its inner one; a die's cavity is ahead of its face.
pub(super) fn heading(chains: &[(ToolId, Chain)], known: Option<(Heading, String)>, frame: &Frame) -> Result<Heading> {
    let open = chains.iter().filter(|(tool, chain)| matches!(tool.role, Role::Punch | Role::Die) && !is_outline(chain));
    let mut walls = open.filter_map(|(tool, chain)| {
        let (a, b) = (chain.first(), chain.last());
        let rise = if a.x <= b.x { b.y - a.y } else { a.y - b.y };
        (rise.abs() > WALL).then_some((tool, if rise > 0.0 { Heading::Down } else { Heading::Up }))
    });
    let first = walls.next();
    let other = walls.find(|(_, heading)| first.is_some_and(|(_, first)| first != *heading));
    let (heading, why) = match (known, first, other) {
        (Some(known), ..) => known,
        (None, Some((first, a)), Some((second, b))) => {
            let [a, b] = [a.name(), b.name()];
            let what = format!("walls disagree which way the punch moves: the {first}'s say {a}, the {second}'s {b}");
            let help = "a punch's wall goes away from the sheet, and so does a die's, to the other side; is a layer named \
                        after the wrong tool? --punch-moves down or up decides";
            return Err(ImportError::new(what, help));
        }
        (None, Some((tool, heading)), None) => (heading, format!("by the {tool}'s wall")),
        (None, None, _) => match (by_places(chains), chains.iter().find(|(_, chain)| is_outline(chain))) {
            (Some(heading), _) => heading,
            (None, None) => (Heading::Down, "assumed: no wall tells; --punch-moves up says otherwise".to_owned()),
            (None, Some((tool, chain))) => {
                let source = chain.source(0);
                let what = format!("which side of the {tool}'s outline meets the sheet cannot be told: {source}");
                return Err(source.error(what, "say --punch-moves down or up, or draw only that side, as an open line"));
            }
        },
    };
    let what = if chains.iter().any(|(tool, _)| tool.role == Role::Punch) { "the punch moves" } else { "z goes" };
    frame.note(format!("{what} {} in the drawing ({why})", heading.name()));
    Ok(heading)
}

/// Direction into a tube, towards the end that stays: where the formed sheet still is, or away from the punch; without both where
/// the die is wider.
pub(super) fn tube(chains: &[(ToolId, Chain)], tube: Bounds, sheet: Option<Bounds>) -> (Heading, String) {
    let of = |role: Role| chains.iter().find(|(tool, _)| tool.role == role).map(|(_, chain)| chain);
    let (above, why) = if let Some(sheet) = sheet {
        ((sheet.low.y - tube.low.y).abs() - (sheet.high.y - tube.high.y).abs(), "the formed tube's end stays there")
    } else if let Some(punch) = of(Role::Punch).map(Chain::bounds) {
        (tube.low.y + tube.high.y - punch.low.y - punch.high.y, "from the punch into the tube")
    } else {
        let ends = of(Role::Die).map_or([Point::zeros(); 2], |die| [die.first(), die.last()]);
        ((ends[1] - ends[0]).product(), "towards the wider end of the die")
    };
    (if above < 0.0 { Heading::Down } else { Heading::Up }, why.to_owned())
}

pub(super) fn section(tool: ToolId, chain: Chain, heading: Heading, tube: bool, frame: &Frame) -> Result<Section> {
    let chain = if is_outline(&chain) { sheet_side(tool, chain, heading, frame)? } else { chain };
    let outward = outward(tool, chain, heading, tube, frame)?;
    // Below the sheet one walks outward, above it inward.
    let chain = if tool.role.side() > 0.0 { outward.reversed() } else { outward };
    let turned = |p: Point| if heading == Heading::Down { Point::new(p.x, -p.y) } else { p };
    let to_section = |piece: &Piece| if heading == Heading::Down { piece.upside_down() } else { *piece };
    let profile = Profile::new(chain.pieces().map(to_section).collect())
        .map_err(|error| ImportError::new(format!("the {tool}'s line is no section: {error}"), "redraw it"))?;
    let fold = profile.fold().map(|fold| match fold {
        Fold::Back { at, after, .. } => {
            let (at, source) = (frame.place(turned(at)), chain.source(after));
            (source, format!("the {tool}'s line turns back on itself at {at}, after {source}"))
        }
        Fold::Crossing { at, pieces } => {
            let (at, [a, b]) = (frame.place(turned(at)), pieces.map(|piece| chain.source(piece)));
            let both = if a == b { a.to_string() } else { format!("{a} and {b}") };
            (a, format!("the {tool}'s line crosses or touches itself at {at}: {both}"))
        }
    });
    if let Some((source, what)) = fold {
        return Err(source.error(what, "a section is one open line along the side that meets the sheet"));
    }
    // Inside a spline there are as many ends as its tolerance asks for.
    let is_drawn = |i: &usize| {
        *i == 0 || !Rc::ptr_eq(&chain.pieces[i - 1].1, &chain.pieces[*i].1) || chain.source(*i).kind != "SPLINE"
    };
    let firsts = (0..chain.pieces.len()).filter(is_drawn).map(|i| chain.pieces[i].0.first());
    let sources = chain.pieces.iter().map(|(_, source)| source);
    let layers: BTreeSet<&str> = sources.clone().map(|source| source.layer.as_str()).collect();
    let drawn: BTreeSet<(&str, usize)> = sources.map(|source| (source.block.as_str(), source.line)).collect();
    let layers = list(layers.into_iter().map(|layer| format!("\"{}\"", cut(layer))));
    let made_of = format!("{} of layer {layers}", count_entities(drawn.len()));
    Ok(Section { role: tool.role, profile, ends: firsts.chain([chain.last()]).map(turned).collect(), made_of })
}

fn outward(tool: ToolId, chain: Chain, heading: Heading, tube: bool, frame: &Frame) -> Result<Chain> {
    let (a, b) = (chain.first(), chain.last());
    // A die around a tube goes up along it.
    let is_around = tube && tool.role == Role::Die;
    if (b.x - a.x).abs() > frame.join && !is_around {
        return Ok(if b.x > a.x { chain } else { chain.reversed() });
    }
    let ahead = if heading == Heading::Down { a.y - b.y } else { b.y - a.y };
    let is_wall = chain.pieces().all(|piece| piece.sample(8).iter().all(|p| (p.x - a.x).abs() <= frame.join));
    if is_wall && !is_around || ahead.abs() <= frame.join {
        let place = frame.place(a);
        let what = format!("the {tool}'s line begins and ends at one r, {place}: on which side of it is the sheet?");
        return Err(ImportError::new(what, "draw the face that meets the sheet too, from its inner to its outer end"));
    }
    Ok(if (tool.role.side() * ahead > 0.0) != is_around { chain } else { chain.reversed() })
}

fn is_outline(chain: &Chain) -> bool {
    chain.is_closed || chain.first().x == 0.0 && chain.last().x == 0.0
}

fn by_places(chains: &[(ToolId, Chain)]) -> Option<(Heading, String)> {
    let mut pairs = chains.iter().filter(|(tool, _)| tool.role == Role::Die).flat_map(|(die, of_die)| {
        let others = chains.iter().filter(|(tool, _)| tool.role.side() < 0.0 && tool.operation == die.operation);
        others.map(move |(tool, chain)| (tool, chain.bounds(), of_die.bounds()))
    });
    pairs.find_map(|(tool, other, die)| {
        let rise = 0.5 * (other.low.y + other.high.y - die.low.y - die.high.y);
        let least = (other.high.y - other.low.y).min(die.high.y - die.low.y);
        let (heading, side) = if rise > 0.0 { (Heading::Down, "above") } else { (Heading::Up, "below") };
        (rise.abs() > APART * least).then(|| (heading, format!("the {tool} is {side} the die")))
    })
}

type Measure<'a> = &'a dyn Fn(Point) -> [f64; 2];

fn sheet_side(tool: ToolId, chain: Chain, heading: Heading, frame: &Frame) -> Result<Chain> {
    // A pad is a punch upside down.
    let is_down = (heading == Heading::Down) != (tool.role == Role::Pad);
    // Larger where nearer to the sheet.
    let height = |p: Point| if (tool.role == Role::Die) == is_down { p.y } else { -p.y };
    let back_inner: Measure = &|p| [-height(p), -p.x];
    let back_outer: Measure = &|p| [-height(p), p.x];
    let face_outer: Measure = &|p| [p.x, height(p)];
    let is_closed = chain.is_closed;
    let chain = if is_closed {
        // Walked so that the face of a punch comes after its inner wall, and that of a die before.
        let chain = if (area(&chain) > 0.0) == is_down { chain } else { chain.reversed() };
        let [before, after] = split(&chain, if tool.role == Role::Die { face_outer } else { back_inner }, frame.join);
        Chain { pieces: [after, before].concat(), ..chain }
    } else if height(chain.first()) >= height(chain.last()) {
        chain
    } else {
        chain.reversed()
    };
    let end = match (tool.role, is_closed) {
        (Role::Die, true) => back_inner,
        (Role::Punch | Role::Pad, _) => back_outer,
        _ => face_outer,
    };
    let [before, _] = split(&chain, end, frame.join);
    let pieces = if before.is_empty() { chain.pieces.clone() } else { before };
    let side = Chain { pieces, is_closed: false };
    let (a, b) = (frame.place(side.first()), frame.place(side.last()));
    let is_open = (side.first() - side.last()).norm() > frame.join;
    let what = || format!("no side of the {tool}'s outline meets the sheet: it would begin and end at {a}");
    ensure(is_open, || ImportError::new(what(), "draw the side that meets the sheet as an open line"))?;
    frame.note(format!("the {tool} is drawn all round: the side towards the sheet is read, from {a} to {b}"));
    Ok(side)
}

/// Twice the enclosed area, positive if counter-clockwise \[mm²\]; chords of arcs keep its sign.
fn area(chain: &Chain) -> f64 {
    let points: Vec<Point> = chain.pieces().flat_map(|piece| piece.sample(8)).collect();
    points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.perp(b)).sum()
}

fn split(chain: &Chain, by: Measure, join: f64) -> [Vec<(Piece, Rc<Source>)>; 2] {
    let of_piece = |piece: &Piece| [piece.first(), piece.last()].into_iter().chain(piece.poles());
    let points = chain.pieces().enumerate().flat_map(|(i, piece)| of_piece(piece).map(move |p| (i, p)));
    let points: Vec<(usize, Point)> = points.collect();
    let most = points.iter().map(|(_, p)| by(*p)[0]).fold(f64::NEG_INFINITY, f64::max);
    let first = points.into_iter().filter(|(_, p)| by(*p)[0] >= most - join);
    let (i, at) = first.max_by(|a, b| by(a.1)[1].total_cmp(&by(b.1)[1])).expect("a chain has pieces");
    let (piece, source) = &chain.pieces[i];
    let [a, b] = piece.split_within(at, join).map(|half| half.map(|piece| (piece, source.clone())));
    let before = chain.pieces[..i].iter().cloned().chain(a).collect();
    [before, b.into_iter().chain(chain.pieces[i + 1..].iter().cloned()).collect()]
}
