//! Bands of a formed part as a die designer names them, by the tools that it lies against; free ones by both sides.
//!
//! ```text
//!   bottom     punch radius     wall      die radius     flange
//!   ───────────────╮
//!                   ╲        (touches       ╭──────────────────
//!                    ╲        neither)     ╱
//!                     ╲___________________╱
//! ```
//! A release, or a stage whose punch leaves the sheet, keeps the bands of its start.

use crate::geometry::{Piece, Point, Profile, on_axis};
use crate::model::{Edge, Geometry, Model, Role, Tool, tool_sizes::embosses};
use crate::numerics::running_sums;
use crate::solver::solution::{Frame, NodeRecord, StageSolution};
use std::ops::Range;

/// Largest gap of a sheet that lies against a tool, over its thickness \[–\].
const TOUCHES: f64 = 0.1;
/// Depth in a tool, over the thickness, from which a node is behind another part of its line \[–\].
const BEHIND: f64 = 0.5;
/// Largest slope of a level piece \[rad\].
const LEVEL: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Distance from the end of a band that counts as next to the other one, over the thickness \[–\].
const NEXT_TO: f64 = 3.0;

named! {
    /// Band of a part by its name in the shop.
    #[derive(Hash)]
    pub enum Band;
    /// Name: `punch radius`.
    fn name;
    Bottom: "bottom", "Level sheet on the punch or on the bottom of a die.";
    Boss: "boss", "Level sheet in the middle of an embossing.";
    Dome: "dome", "Sheet on a punch that is round from the axis on, or free under gas.";
    PunchRadius: "punch radius", "Bend around the punch's edge.";
    Wall: "wall", "Steep sheet, free between punch and die or along one of them.";
    Unsupported: "unsupported stretch", "Free sheet between a dome and the die, or beside a further tool.";
    DieCorner: "die corner", "Bend in the hollow corner of a die.";
    DieRadius: "die radius", "Bend over the die's edge.";
    HolderRadius: "holder radius", "Bend over the edge of a holder within the part.";
    Flange: "flange", "Sheet between holder and die, or flat outside the die radius.";
    Tool: "tool", "Sheet on a further tool alone.";
    HoleEdge: "hole's edge", "First element of a flat sheet with a hole.";
}

/// Extent of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Kind.
    pub band: Band,
    /// Name: `punch radius`, `tool 'coin'`.
    pub name: String,
    /// Elements, from the axis outward.
    pub elements: Range<usize>,
    /// Both ends as length along the deformed mid-surface from the middle \[mm\].
    pub along: [f64; 2],
}

/// Place on a part in a designer's terms.
#[derive(Clone, Debug, PartialEq)]
pub struct PartPlace {
    /// Band of the place.
    pub band: Band,
    /// Name of the band.
    pub name: String,
    /// Name of another band within three thicknesses.
    pub next_to: Option<String>,
}

impl std::fmt::Display for PartPlace {
    /// `in the wall, next to the punch radius`
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let preposition = match self.band {
            Band::Boss | Band::Dome | Band::PunchRadius | Band::DieRadius | Band::HolderRadius => "on",
            Band::Bottom | Band::Wall | Band::Unsupported | Band::DieCorner | Band::Flange => "in",
            Band::Tool | Band::HoleEdge => "at",
        };
        write!(f, "{preposition} the {}", self.name)?;
        self.next_to.as_ref().map_or(Ok(()), |other| write!(f, ", next to the {other}"))
    }
}

/// Length along the deformed mid-surface from the middle to each node \[mm\].
pub fn along(frame: &Frame) -> Vec<f64> {
    running_sums(frame.nodes.windows(2).map(|w| (w[1].r - w[0].r).hypot(w[1].z - w[0].z)))
}

/// Bands of the part after a stage, from the middle outward; empty if no punch, further tool or gas formed it.
pub fn bands(stage: &StageSolution) -> Vec<Stretch> {
    let Some(last) = stage.frames.last() else { return Vec::new() };
    let Some(names) = bands_of_nodes(stage, last) else { return Vec::new() };
    let along = along(last);
    let mut from = 0;
    let end = |node: usize| match node {
        0 => 0.0,
        _ if node >= last.nodes.len() => along[along.len() - 1],
        // Half-way between the last node of a band and the first of the next.
        _ => 0.5 * (along[node - 1] + along[node]),
    };
    let elements = last.elements.len();
    let stretches = names.chunk_by(|a, b| a == b).map(|same| {
        let nodes = from..from + same.len();
        from = nodes.end;
        let elements = nodes.start.min(elements)..nodes.end.min(elements);
        let (band, tool) = same[0];
        let is_inverted = stage.model.blank.is_open() && stage.model.tool(Role::Die).is_none();
        let name = match (tool, band) {
            (Some(role), _) => format!("tool '{}'", stage.model.name_of(role)),
            (_, Band::DieRadius) if !is_inverted => format!("{} radius", stage.model.name_of(Role::Die)),
            (_, Band::PunchRadius | Band::DieRadius) => format!("{} radius", stage.model.name_of(Role::Punch)),
            _ => band.name().into(),
        };
        Stretch { band, name, along: [end(nodes.start), end(nodes.end)], elements }
    });
    stretches.filter(|stretch| !stretch.elements.is_empty()).collect()
}

/// Elongation of a strip's middle between its clamps, bent over a punch \[–\].
pub fn stretch(stage: &StageSolution) -> Option<f64> {
    let is_stretched = stage.model.is_stretch_bent() && stage.model.blank.edge == Edge::Clamped;
    Some(along(stage.frames.last().filter(|_| is_stretched)?).last()? / stage.model.blank.length - 1.0)
}

/// Index of the element whose initial distance from the axis is nearest to one \[mm\].
pub fn element_at(frame: &Frame, s0: f64) -> Option<usize> {
    let away = |e: &usize| (frame.elements[*e].s0 - s0).abs();
    (0..frame.elements.len()).min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// Place of the element with this initial distance from the axis \[mm\].
pub fn place_on_part(stage: &StageSolution, s0: f64) -> Option<PartPlace> {
    let frame = stage.frames.last()?;
    let element = element_at(frame, s0)?;
    let along = along(frame);
    let middle = 0.5 * (along[element] + along[element + 1]);
    let mut bands = bands(stage);
    let i = bands.iter().position(|stretch| stretch.elements.contains(&element))?;
    if element == 0 && stage.model.blank.has_hole() && !stage.model.blank.is_open() {
        return Some(PartPlace { band: Band::HoleEdge, name: Band::HoleEdge.name().into(), next_to: None });
    }
    let near = NEXT_TO * stage.model.blank.thickness;
    let [from, to] = bands[i].along;
    let inner = i.checked_sub(1).map(|inner| (middle - from, &bands[inner].name));
    let outer = bands.get(i + 1).map(|outer| (to - middle, &outer.name));
    let nearest = [inner, outer].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0));
    let next_to = nearest.filter(|(distance, _)| *distance < near).map(|(_, name)| name.clone());
    let Stretch { band, name, .. } = bands.swap_remove(i);
    Some(PartPlace { band, name, next_to })
}

#[derive(Clone, Copy)]
struct NodeContact<'a> {
    tool: &'a Tool,
    /// Displacement of the tool \[mm\].
    moved: Point,
    band: Band,
}

fn is_punch(contact: &NodeContact) -> bool {
    contact.tool.role == Role::Punch
}

type Named = (Band, Option<Role>);

fn bands_of_nodes(stage: &StageSolution, last: &Frame) -> Option<Vec<Named>> {
    let forms = |contact: &NodeContact| is_punch(contact) || contact.band == Band::Tool;
    let punched = |contacts: &[Option<NodeContact>]| contacts.iter().flatten().any(forms);
    let end = contacts(&stage.model, last);
    let start = stage.start.as_ref().filter(|_| stage.model.release.is_some() || !punched(&end));
    let start = start.map(|start| (start, contacts(&stage.model, start)));
    let (frame, contacts) = start.filter(|(_, contacts)| punched(contacts)).unwrap_or((last, end));
    let formed = punched(&contacts) || !stage.model.gas.is_empty() && contacts.iter().any(Option::is_some);
    let mut names = formed.then(|| node_bands(stage.model.geometry, frame, &contacts))?;
    if let Some(die) = stage.model.tool(Role::Die).filter(|_| embosses(&stage.model)) {
        let boss = names.iter().take_while(|name| name.0 == Band::Bottom).count();
        names[..boss].fill((Band::Boss, None));
        for (name, node) in names.iter_mut().zip(&frame.nodes).filter(|(name, _)| name.0 == Band::Bottom) {
            let at = Point::new(node.r, node.z);
            name.0 = of_piece(stage.model.geometry, die, die.profile.closest(at).piece, at);
        }
    }
    if stage.model.blank.is_open() {
        let has_none = |band: Band| matches!(band, Band::Dome | Band::Bottom | Band::Flange);
        names.iter_mut().filter(|name| has_none(name.0)).for_each(|name| name.0 = Band::Wall);
    }
    Some(names)
}

fn contacts<'a>(model: &'a Model, frame: &Frame) -> Vec<Option<NodeContact<'a>>> {
    let mut tools: Vec<_> = model.tools.iter().enumerate().collect();
    tools.sort_by_key(|(_, tool)| tool.role.index());
    let of_node = |node: &NodeRecord| {
        tools.iter().find_map(|&(i, tool)| {
            let moved = frame.tool_displacement.get(i).copied().unwrap_or_default();
            let at = Point::new(node.r, node.z) - moved;
            let closest = tool.profile.closest(at);
            let gap = closest.distance / node.thickness - 0.5;
            let touches = gap < TOUCHES && gap > -0.5 - BEHIND;
            touches.then(|| NodeContact { tool, moved, band: of_piece(model.geometry, tool, closest.piece, at) })
        })
    };
    frame.nodes.iter().map(of_node).collect()
}

fn node_bands(geometry: Geometry, frame: &Frame, contacts: &[Option<NodeContact>]) -> Vec<Named> {
    let at = |i: usize| Point::new(frame.nodes[i].r, frame.nodes[i].z);
    let mut names: Vec<Named> = Vec::with_capacity(contacts.len());
    for run in contacts.chunk_by(|a, b| a.is_some() == b.is_some()) {
        let nodes = names.len()..names.len() + run.len();
        let inner = nodes.start.checked_sub(1).and_then(|i| contacts[i]);
        let outer = contacts.get(nodes.end).copied().flatten();
        let free = |i: usize| between(geometry, at(i), inner.as_ref(), outer.as_ref());
        names.extend(nodes.zip(run).map(|(i, contact)| contact.map_or_else(|| free(i), named)));
    }
    // A bead in the flange is a part of it.
    let is_flange = |(band, _): &Named| *band == Band::Flange;
    if let (Some(first), Some(last)) = (names.iter().position(is_flange), names.iter().rposition(is_flange)) {
        names[first..last].fill((Band::Flange, None));
    }
    names
}

fn named(contact: NodeContact) -> Named {
    (contact.band, Some(contact.tool.role).filter(|_| contact.band == Band::Tool))
}

fn between(geometry: Geometry, node: Point, inner: Option<&NodeContact>, outer: Option<&NodeContact>) -> Named {
    let along = |touch: &NodeContact| {
        let at = node - touch.moved;
        of_piece(geometry, touch.tool, touch.tool.profile.closest(at).piece, at)
    };
    let band = match (inner, outer) {
        (Some(inner), Some(outer)) if inner.band == Band::Tool && inner.tool.role == outer.tool.role => {
            return named(*inner);
        }
        (Some(touch), _) | (_, Some(touch)) if touch.band == Band::Tool => Band::Unsupported,
        (Some(inner), Some(outer)) if is_punch(inner) == is_punch(outer) => along(inner),
        (Some(inner), None) if !is_punch(inner) => along(inner),
        (None, Some(outer)) if is_punch(outer) => along(outer),
        (None, _) => Band::Dome,
        (Some(NodeContact { band: Band::Dome, .. }), _) => Band::Unsupported,
        _ => Band::Wall,
    };
    (band, None)
}

fn of_piece(geometry: Geometry, tool: &Tool, piece: usize, at: Point) -> Band {
    let (role, profile) = (tool.role, &tool.profile);
    let stepped = if role == Role::Punch { stepped(profile, piece) } else { None };
    match &profile.pieces()[piece] {
        _ if role.further().is_some() => Band::Tool,
        Piece::Arc(arc) if arc.sweep < 0.0 => match role {
            Role::Punch => nose(geometry, profile, at),
            Role::Die => Band::DieRadius,
            Role::Holder => Band::HolderRadius,
            _ => Band::Bottom,
        },
        Piece::Arc(_) if role == Role::Die => Band::DieCorner,
        Piece::Arc(_) if stepped.is_some() => Band::DieRadius,
        piece => {
            let tangent = piece.tangent(false) + piece.tangent(true);
            let edge = || profile.corners().map(|corner| corner.center.x).fold(f64::INFINITY, f64::min);
            match role {
                _ if tangent.y.abs() >= LEVEL.tan() * tangent.x.abs() => Band::Wall,
                Role::Die if at.x >= edge() || !edge().is_finite() => Band::Flange,
                Role::Holder => Band::Flange,
                _ => stepped.unwrap_or(Band::Bottom),
            }
        }
    }
}

/// Band on a stepped punch outside its last corner: the flank to a hollow, that hollow, which bends the flange out, and the flange.
fn stepped(profile: &Profile, piece: usize) -> Option<Band> {
    let (inside, outside) = profile.pieces().split_at(piece + 1);
    let has_hollow = |pieces: &[Piece]| pieces.iter().any(|piece| piece.hollow().is_some());
    let is_corner = |piece: &Piece| matches!(piece, Piece::Arc(_)) && piece.hollow().is_none();
    let band = if has_hollow(inside) { Some(Band::Flange) } else { has_hollow(outside).then_some(Band::Wall) };
    band.filter(|_| !outside.iter().any(is_corner))
}

/// Band on a convex arc of a punch: its edge, or the end of a round or crowned punch.
fn nose(geometry: Geometry, profile: &Profile, at: Point) -> Band {
    let mut corners = profile.corners();
    match (corners.next().filter(|corner| on_axis(&corner.at(0.0)) || on_axis(&corner.at(1.0))), corners.next()) {
        (Some(_), None) if geometry == Geometry::Axisymmetric => Band::Dome,
        (Some(crown), Some(_)) if at.x < crown.at(0.0).x.max(crown.at(1.0).x) => Band::Bottom,
        _ => Band::PunchRadius,
    }
}
