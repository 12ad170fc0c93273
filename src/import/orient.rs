//! Which way the punch moves, and the sheet on the left of every section.

use super::chain::Chain;
use super::error::ImportError;
use super::frame::Frame;
use super::layers::{entities, some};
use super::listing::cut;
use super::options::Heading;
use super::section::Section;
use crate::geometry::{Fold, Piece, Point, Profile};
use crate::model::Role;

/// A wall is seen from this height on \[mm\].
const WALL: f64 = 1e-3;

/// The heading asked for, or the one that the walls of punch and die tell: a punch's body lies behind its face, so that
/// its outer end is behind its inner one, and a die's cavity is ahead of its face.
pub(super) fn heading(
    chains: &[(Role, Chain)],
    asked: Option<Heading>,
    notes: &mut Vec<String>,
) -> Result<Heading, ImportError> {
    let told = chains.iter().filter(|(role, _)| *role != Role::Holder).filter_map(|(role, chain)| {
        let (inner, outer) = from_axis(chain);
        let rise = outer.y - inner.y;
        (rise.abs() > WALL).then_some((*role, if rise > 0.0 { Heading::Down } else { Heading::Up }))
    });
    let told: Vec<(Role, Heading)> = told.collect();
    let (heading, why) = match (asked, &told[..]) {
        (Some(asked), _) => (asked, "as asked for".to_owned()),
        (None, [(_, a), (_, b)]) if a != b => {
            let what = format!(
                "the walls disagree about which way the punch moves: the punch's say {}, the die's say {}",
                a.name(),
                b.name()
            );
            let help = "a punch's wall goes away from the sheet, and so does a die's, to the other side; is a layer named \
                        after the wrong tool? --punch-moves down or up decides";
            return Err(ImportError::new(what, help));
        }
        (None, [(role, heading), ..]) => (*heading, format!("by the {}'s wall", role.name())),
        (None, []) => (Heading::Down, "assumed: no wall tells; --punch-moves up says otherwise".to_owned()),
    };
    notes.push(format!("the punch moves {} in the drawing ({why})", heading.name()));
    Ok(heading)
}

/// The ends of a chain, the one nearer to the axis first.
fn from_axis(chain: &Chain) -> (Point, Point) {
    let (a, b) = (chain.first(), chain.last());
    if a.x <= b.x { (a, b) } else { (b, a) }
}

/// The section of a tool: z in the direction of the punch travel, the sheet on its left.
pub(super) fn section(role: Role, chain: Chain, heading: Heading, frame: &Frame) -> Result<Section, ImportError> {
    let outward = outward(role, chain, heading, frame)?;
    // Below the sheet one walks outward, above it inward.
    let chain = if role == Role::Die { outward.reversed() } else { outward };
    let to_section = |piece: &Piece| if heading == Heading::Down { piece.upside_down() } else { *piece };
    let profile = Profile::new(chain.pieces().map(|(piece, _)| to_section(piece)).collect())
        .map_err(|error| ImportError::new(format!("the {}'s line is no section: {error}", role.name()), "redraw it"))?;
    let strokes: Vec<usize> = chain.pieces().map(|(_, stroke)| stroke).collect();
    let drawn = |p: Point| frame.place(if heading == Heading::Down { Point::new(p.x, -p.y) } else { p });
    let from = |piece: usize| &chain.strokes[strokes[piece]].from;
    let name = role.name();
    let help = "a section is one open line along the side that meets the sheet";
    match profile.fold() {
        None => {}
        Some(Fold::Back { at, after, .. }) => {
            let what = format!("the {name}'s line turns back on itself at {}, after {}", drawn(at), from(after));
            return Err(ImportError::new(what, help).at(from(after).line));
        }
        Some(Fold::Crossing { at, pieces: [a, b] }) => {
            let (a, b) = (from(a), from(b));
            let both = if a == b { a.to_string() } else { format!("{a} and {b}") };
            let what = format!("the {name}'s line crosses or touches itself at {}: {both}", drawn(at));
            return Err(ImportError::new(what, help).at(a.line));
        }
    }
    // Inside a spline there are as many ends as its tolerance asks for.
    let is_drawn =
        |i: &usize| i.checked_sub(1).is_none_or(|before| strokes[before] != strokes[*i]) || from(*i).kind != "SPLINE";
    let pieces = chain.pieces().enumerate().filter(|(i, _)| is_drawn(i));
    let mut ends: Vec<Point> = pieces.map(|(_, (piece, _))| piece.first()).collect();
    ends.push(chain.last());
    if heading == Heading::Down {
        ends.iter_mut().for_each(|end| end.y = -end.y);
    }
    let mut layers: Vec<&str> = chain.strokes.iter().map(|stroke| stroke.from.layer.as_str()).collect();
    layers.sort_unstable();
    layers.dedup();
    let layers = some(layers.into_iter().map(|layer| format!("\"{}\"", cut(layer))));
    let made_of = format!("{} of layer {layers}", entities(chain.strokes.len()));
    Ok(Section { role, profile, ends, made_of })
}

/// The chain from the axis outward. Where both ends are equally far from it (a body drawn as far as the axis, a ring), the
/// end nearer to the sheet is the inner one.
fn outward(role: Role, chain: Chain, heading: Heading, frame: &Frame) -> Result<Chain, ImportError> {
    let (a, b) = (chain.first(), chain.last());
    let along = if heading == Heading::Down { -1.0 } else { 1.0 };
    let ahead = along * (b.y - a.y);
    let name = role.name();
    if (b.x - a.x).abs() > frame.join {
        return Ok(if b.x > a.x { chain } else { chain.reversed() });
    }
    let wall = chain.pieces().all(|(piece, _)| piece.sample(8).iter().all(|p| (p.x - a.x).abs() <= frame.join));
    if wall || ahead.abs() <= frame.join {
        let place = frame.place(a);
        let what = format!(
            "the sheet lies on neither side of the {name}'s line: it begins and ends at one distance from the axis, {place}"
        );
        let help = "draw the face that meets the sheet too, from its inner to its outer end";
        return Err(ImportError::new(what, help));
    }
    let begins_at_sheet = if role == Role::Die { ahead > 0.0 } else { ahead < 0.0 };
    Ok(if begins_at_sheet { chain } else { chain.reversed() })
}
