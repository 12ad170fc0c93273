//! Direction of the punch, and the sheet on the left of every section.

use super::chain::Chain;
use super::error::ImportError;
use super::frame::Frame;
use super::layers::{entities, some};
use super::listing::cut;
use super::options::Heading;
use super::outline::{self, is_outline, sheet_side};
use super::parts::Part;
use super::section::Section;
use crate::geometry::{Fold, Piece, Point, Profile};
use crate::model::Role;

/// Least height of a wall \[mm\].
const WALL: f64 = 1e-3;

/// Direction of the punch: the option's, or that of the walls, or that of the tools' places.
///
/// A punch's body lies behind its face, so that its outer end is behind its inner one; a die's cavity is ahead of its face.
pub(super) fn heading(
    chains: &[(Part, Chain)],
    asked: Option<Heading>,
    notes: &mut Vec<String>,
) -> Result<Heading, ImportError> {
    let open = chains.iter().filter(|(part, chain)| part.role != Role::Holder && !is_outline(chain));
    let told = open.filter_map(|(part, chain)| {
        let (inner, outer) = from_axis(chain);
        let rise = outer.y - inner.y;
        (rise.abs() > WALL).then_some((*part, if rise > 0.0 { Heading::Down } else { Heading::Up }))
    });
    let told: Vec<(Part, Heading)> = told.collect();
    let other = told.iter().find(|(_, heading)| *heading != told[0].1);
    let (heading, why) = match (asked, told.first(), other) {
        (Some(asked), ..) => (asked, "as asked for".to_owned()),
        (None, Some((first, a)), Some((second, b))) => {
            let what = format!(
                "the walls disagree about which way the punch moves: the {}'s say {}, the {}'s say {}",
                first.name(),
                a.name(),
                second.name(),
                b.name()
            );
            let help = "a punch's wall goes away from the sheet, and so does a die's, to the other side; is a layer named \
                        after the wrong tool? --punch-moves down or up decides";
            return Err(ImportError::new(what, help));
        }
        (None, Some((part, heading)), None) => (*heading, format!("by the {}'s wall", part.name())),
        (None, None, _) => by_place(chains)?,
    };
    notes.push(format!("the punch moves {} in the drawing ({why})", heading.name()));
    Ok(heading)
}

fn by_place(chains: &[(Part, Chain)]) -> Result<(Heading, String), ImportError> {
    if let Some((heading, why)) = outline::heading(chains) {
        return Ok((heading, why));
    }
    if let Some((part, chain)) = chains.iter().find(|(_, chain)| is_outline(chain)) {
        let (name, from) = (part.name(), &chain.strokes[0].from);
        let what = format!("which side of the {name}'s outline meets the sheet cannot be told: {from}");
        let help = "say --punch-moves down or up, or draw only that side, as an open line";
        return Err(ImportError::new(what, help).at(from.line));
    }
    Ok((Heading::Down, "assumed: no wall tells; --punch-moves up says otherwise".to_owned()))
}

fn from_axis(chain: &Chain) -> (Point, Point) {
    let (a, b) = (chain.first(), chain.last());
    if a.x <= b.x { (a, b) } else { (b, a) }
}

/// Section of a tool: z along the punch travel, the sheet on its left.
pub(super) fn section(
    part: Part,
    chain: Chain,
    heading: Heading,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Section, ImportError> {
    let role = part.role;
    let chain = if is_outline(&chain) { sheet_side(part, chain, heading, frame, notes)? } else { chain };
    let outward = outward(part, chain, heading, frame)?;
    // Below the sheet one walks outward, above it inward.
    let chain = if role == Role::Die { outward.reversed() } else { outward };
    let to_section = |piece: &Piece| if heading == Heading::Down { piece.upside_down() } else { *piece };
    let profile = Profile::new(chain.pieces().map(|(piece, _)| to_section(piece)).collect())
        .map_err(|error| ImportError::new(format!("the {}'s line is no section: {error}", part.name()), "redraw it"))?;
    let strokes: Vec<usize> = chain.pieces().map(|(_, stroke)| stroke).collect();
    let drawn = |p: Point| frame.place(if heading == Heading::Down { Point::new(p.x, -p.y) } else { p });
    let from = |piece: usize| &chain.strokes[strokes[piece]].from;
    let name = part.name();
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
    let mut drawn: Vec<(&str, usize)> =
        chain.strokes.iter().map(|stroke| (stroke.from.block.as_str(), stroke.from.line)).collect();
    drawn.sort_unstable();
    drawn.dedup();
    let made_of = format!("{} of layer {layers}", entities(drawn.len()));
    Ok(Section { role, profile, ends, made_of })
}

/// Chain from the axis outward; with both ends equally far, the one nearer to the sheet is the inner end.
fn outward(part: Part, chain: Chain, heading: Heading, frame: &Frame) -> Result<Chain, ImportError> {
    let (a, b) = (chain.first(), chain.last());
    let along = if heading == Heading::Down { -1.0 } else { 1.0 };
    let ahead = along * (b.y - a.y);
    let name = part.name();
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
    let begins_at_sheet = if part.role == Role::Die { ahead > 0.0 } else { ahead < 0.0 };
    Ok(if begins_at_sheet { chain } else { chain.reversed() })
}
