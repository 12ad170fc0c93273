//! Direction of the punch, and the sheet on the left of every section.

use super::chain::Chain;
use super::dxf::cut;
use super::frame::Frame;
use super::layers::{ToolId, count_entities, list};
use super::options::Heading;
use super::outline::{self, is_outline, sheet_side};
use super::{ImportError, Section};
use crate::geometry::{Fold, Piece, Point, Profile};
use crate::model::Role;
use std::collections::BTreeSet;
use std::rc::Rc;

/// Least height of a wall \[mm\].
const WALL: f64 = 1e-3;

/// Direction of the punch: the option's, or that of the walls, or that of the tools' places.
///
/// A punch's body lies behind its face, so that its outer end is behind its inner one; a die's cavity is ahead of its face.
pub(super) fn heading(
    chains: &[(ToolId, Chain)],
    option: Option<Heading>,
    frame: &Frame,
) -> Result<Heading, ImportError> {
    let open = chains.iter().filter(|(tool, chain)| tool.role != Role::Holder && !is_outline(chain));
    let mut walls = open.filter_map(|(tool, chain)| {
        let (a, b) = (chain.first(), chain.last());
        let rise = if a.x <= b.x { b.y - a.y } else { a.y - b.y };
        (rise.abs() > WALL).then_some((tool, if rise > 0.0 { Heading::Down } else { Heading::Up }))
    });
    let first = walls.next();
    let other = walls.find(|(_, heading)| first.is_some_and(|(_, first)| first != *heading));
    let (heading, why) = match (option, first, other) {
        (Some(option), ..) => (option, "as asked for".to_owned()),
        (None, Some((first, a)), Some((second, b))) => {
            let [a, b] = [a.name(), b.name()];
            let what = format!(
                "the walls disagree about which way the punch moves: the {first}'s say {a}, the {second}'s say {b}"
            );
            let help = "a punch's wall goes away from the sheet, and so does a die's, to the other side; is a layer named \
                        after the wrong tool? --punch-moves down or up decides";
            return Err(ImportError::new(what, help));
        }
        (None, Some((tool, heading)), None) => (heading, format!("by the {tool}'s wall")),
        (None, None, _) => match (outline::heading(chains), chains.iter().find(|(_, chain)| is_outline(chain))) {
            (Some(heading), _) => heading,
            (None, None) => (Heading::Down, "assumed: no wall tells; --punch-moves up says otherwise".to_owned()),
            (None, Some((tool, chain))) => {
                let source = chain.source(0);
                let what = format!("which side of the {tool}'s outline meets the sheet cannot be told: {source}");
                return Err(source.error(what, "say --punch-moves down or up, or draw only that side, as an open line"));
            }
        },
    };
    frame.note(format!("the punch moves {} in the drawing ({why})", heading.name()));
    Ok(heading)
}

/// Section of a tool: z along the punch travel, the sheet on its left.
pub(super) fn section(tool: ToolId, chain: Chain, heading: Heading, frame: &Frame) -> Result<Section, ImportError> {
    let chain = if is_outline(&chain) { sheet_side(tool, chain, heading, frame)? } else { chain };
    let outward = outward(tool, chain, heading, frame)?;
    // Below the sheet one walks outward, above it inward.
    let chain = if tool.role == Role::Die { outward.reversed() } else { outward };
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
    let ends = firsts.chain([chain.last()]).map(turned).collect();
    let sources = chain.pieces.iter().map(|(_, source)| source);
    let layers: BTreeSet<&str> = sources.clone().map(|source| source.layer.as_str()).collect();
    let drawn: BTreeSet<(&str, usize)> = sources.map(|source| (source.block.as_str(), source.line)).collect();
    let layers = list(layers.into_iter().map(|layer| format!("\"{}\"", cut(layer))));
    let made_of = format!("{} of layer {layers}", count_entities(drawn.len()));
    Ok(Section { role: tool.role, profile, ends, made_of })
}

/// Chain from the axis outward; with both ends equally far, the one nearer to the sheet is the inner end.
fn outward(tool: ToolId, chain: Chain, heading: Heading, frame: &Frame) -> Result<Chain, ImportError> {
    let (a, b) = (chain.first(), chain.last());
    if (b.x - a.x).abs() > frame.join {
        return Ok(if b.x > a.x { chain } else { chain.reversed() });
    }
    let ahead = if heading == Heading::Down { a.y - b.y } else { b.y - a.y };
    let is_wall = chain.pieces().all(|piece| piece.sample(8).iter().all(|p| (p.x - a.x).abs() <= frame.join));
    if is_wall || ahead.abs() <= frame.join {
        let place = frame.place(a);
        let what = format!(
            "the sheet lies on neither side of the {tool}'s line: it begins and ends at one distance from the axis, {place}"
        );
        let help = "draw the face that meets the sheet too, from its inner to its outer end";
        return Err(ImportError::new(what, help));
    }
    let begins_at_sheet = if tool.role == Role::Die { ahead > 0.0 } else { ahead < 0.0 };
    Ok(if begins_at_sheet { chain } else { chain.reversed() })
}
