//! The stretches of a formed part as a die designer names them: bottom, punch radius, wall, die radius, flange.
//!
//! They come from the tools' pieces that the sheet lies against. Where it lies against none it belongs to what is on
//! both sides of it: between punch and die it is the wall, beside a dome the unsupported stretch, and within one tool
//! what the nearest piece makes.
//!
//! ```text
//!   bottom     punch radius     wall      die radius     flange
//!   ───────────────╮
//!                   ╲        (touches       ╭──────────────────
//!                    ╲        neither)     ╱
//!                     ╲___________________╱
//! ```
//! A stage that takes its tools away, or whose punch leaves the sheet, is named as it began: these are the same places
//! of the sheet.

use crate::geometry::{Piece, Point, Profile, on_axis};
use crate::model::{Geometry, Model, Role, Tool};
use crate::solver::solution::{Frame, StageSolution};
use std::ops::Range;

/// A sheet that is no further from a tool than this share of its thickness lies against it \[–\]; declared.
const TOUCHES: f64 = 0.1;
/// What lies this much into a tool, over the thickness, is behind another part of its line \[–\].
const BEHIND: f64 = 0.5;
/// A straight piece of a tool that rises by less than this is level \[rad\]: 20°; declared.
const LEVEL: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// What is within so many thicknesses of the end of a band is said to be next to the other one; declared.
const NEXT_TO: f64 = 3.0;

/// A stretch of the part by its name in the shop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Band {
    /// Level, over the punch's end or on the bottom of a die.
    Bottom,
    /// On a punch that is round from the axis on, or blown up free.
    Dome,
    /// Around the punch's edge.
    PunchRadius,
    /// Steep: free between punch and die, or along one of them.
    Wall,
    /// Free between a dome and the die.
    Unsupported,
    /// In the hollow corner of a die.
    DieCorner,
    /// Over the die's edge.
    DieRadius,
    /// Over the edge of a holder that stands within the part.
    HolderRadius,
    /// Between holder and die, or flat outside of the die radius.
    Flange,
}

impl Band {
    /// The word for it: `punch radius`.
    pub fn name(self) -> &'static str {
        match self {
            Band::Bottom => "bottom",
            Band::Dome => "dome",
            Band::PunchRadius => "punch radius",
            Band::Wall => "wall",
            Band::Unsupported => "unsupported",
            Band::DieCorner => "die corner",
            Band::DieRadius => "die radius",
            Band::HolderRadius => "holder radius",
            Band::Flange => "flange",
        }
    }

    /// The same with its preposition: `on the punch radius`.
    pub fn at(self) -> &'static str {
        match self {
            Band::Bottom => "in the bottom",
            Band::Dome => "on the dome",
            Band::PunchRadius => "on the punch radius",
            Band::Wall => "in the wall",
            Band::Unsupported => "in the unsupported stretch",
            Band::DieCorner => "in the die corner",
            Band::DieRadius => "on the die radius",
            Band::HolderRadius => "on the holder radius",
            Band::Flange => "in the flange",
        }
    }
}

/// A band of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Its name.
    pub band: Band,
    /// Its elements, from the axis outward.
    pub elements: Range<usize>,
    /// Where it begins and ends: length along the deformed mid-surface from the middle \[mm\].
    pub along: [f64; 2],
}

/// A place on a part, as a designer says it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartPlace {
    /// The band that it lies in.
    pub band: Band,
    /// The band that begins within three thicknesses of it.
    pub next_to: Option<Band>,
    /// Length along the deformed mid-surface from the middle \[mm\].
    pub along: f64,
    /// Distance from the axis or symmetry plane \[mm\].
    pub r: f64,
    /// Height from the middle of the part, along the punch travel, without sign \[mm\].
    pub height: f64,
}

impl std::fmt::Display for PartPlace {
    /// `in the wall, next to the punch radius`
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.band.at())?;
        self.next_to.map_or(Ok(()), |other| write!(f, ", next to the {}", other.name()))
    }
}

/// Length along the deformed mid-surface from the middle to each node \[mm\].
pub fn along(frame: &Frame) -> Vec<f64> {
    let mut length = 0.0;
    let steps = frame.nodes.windows(2).map(|pair| (pair[1].r - pair[0].r).hypot(pair[1].z - pair[0].z));
    let ends = steps.map(|step| {
        length += step;
        length
    });
    std::iter::once(0.0).chain(ends).collect()
}

/// The bands of the part that a stage left, from the middle outward; none where neither punch nor gas made it.
pub fn bands(stage: &StageSolution) -> Vec<Stretch> {
    let Some(last) = stage.frames.last() else { return Vec::new() };
    let Some(names) = named_of(stage, last) else { return Vec::new() };
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
        Stretch {
            band: same[0],
            along: [end(nodes.start), end(nodes.end)],
            elements: nodes.start.min(elements)..nodes.end.min(elements),
        }
    });
    stretches.filter(|stretch| !stretch.elements.is_empty()).collect()
}

/// Where on the part the element is that was initially so far from the axis \[mm\].
pub fn place_on_part(stage: &StageSolution, s0: f64) -> Option<PartPlace> {
    let frame = stage.frames.last()?;
    let away = |e: &usize| (frame.elements[*e].s0 - s0).abs();
    let element = (0..frame.elements.len()).min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let along = along(frame);
    let middle = 0.5 * (along[element] + along[element + 1]);
    let bands = bands(stage);
    let i = bands.iter().position(|stretch| stretch.elements.contains(&element))?;
    let near = NEXT_TO * stage.model.blank.thickness;
    let [from, to] = bands[i].along;
    let inner = i.checked_sub(1).map(|inner| (middle - from, bands[inner].band));
    let outer = bands.get(i + 1).map(|outer| (to - middle, outer.band));
    let nearest = [inner, outer].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0));
    let crate::solver::solution::ElementRecord { r, z, .. } = frame.elements[element];
    Some(PartPlace {
        band: bands[i].band,
        next_to: nearest.filter(|(distance, _)| *distance < near).map(|(_, band)| band),
        along: middle,
        r,
        height: (z - frame.nodes.first()?.z).abs(),
    })
}

/// What a node lies against.
#[derive(Clone, Copy)]
struct Touch<'a> {
    tool: &'a Tool,
    /// Where the tool has moved \[mm\].
    moved: Point,
    band: Band,
}

impl Touch<'_> {
    fn is_punch(&self) -> bool {
        self.tool.role == Role::Punch
    }
}

/// The band of each node by the frame in which the tools formed it; `None` where no punch and no gas made it.
fn named_of(stage: &StageSolution, last: &Frame) -> Option<Vec<Band>> {
    let (at_end, at_start) =
        (touches(&stage.model, last), stage.start.as_ref().map(|start| touches(&stage.model, start)));
    let punched = |touches: &[Option<Touch>]| touches.iter().flatten().any(Touch::is_punch);
    let leaves = stage.model.release.is_some() || !punched(&at_end);
    let (frame, touches) = match (&stage.start, &at_start) {
        (Some(start), Some(at_start)) if leaves && punched(at_start) => (start, at_start),
        _ => (last, &at_end),
    };
    // Without a punch or a gas that made the part, contact says nothing of its bands.
    let formed = punched(touches) || !stage.model.gas.is_empty() && touches.iter().any(Option::is_some);
    formed.then(|| named(stage.model.geometry, frame, touches))
}

/// What each node lies against.
fn touches<'a>(model: &'a Model, frame: &Frame) -> Vec<Option<Touch<'a>>> {
    frame.nodes.iter().map(|node| touch(model, frame, Point::new(node.r, node.z), node.thickness)).collect()
}

/// The band of each node.
fn named(geometry: Geometry, frame: &Frame, touches: &[Option<Touch>]) -> Vec<Band> {
    let at = |i: usize| Point::new(frame.nodes[i].r, frame.nodes[i].z);
    let mut names: Vec<Band> = Vec::with_capacity(touches.len());
    for run in touches.chunk_by(|a, b| a.is_some() == b.is_some()) {
        let nodes = names.len()..names.len() + run.len();
        let inner = nodes.start.checked_sub(1).and_then(|i| touches[i]);
        let outer = touches.get(nodes.end).copied().flatten();
        names.extend(nodes.zip(run).map(|(i, touch)| match touch {
            Some(touch) => touch.band,
            None => between(geometry, at(i), inner.as_ref(), outer.as_ref()),
        }));
    }
    // A bead in the flange is a part of it.
    let is_flange = |band: &Band| *band == Band::Flange;
    if let (Some(first), Some(last)) = (names.iter().position(is_flange), names.iter().rposition(is_flange)) {
        names[first..last].fill(Band::Flange);
    }
    names
}

/// The tool that a node lies against, the punch first.
fn touch<'a>(model: &'a Model, frame: &Frame, node: Point, thickness: f64) -> Option<Touch<'a>> {
    let touches = Role::ALL.into_iter().filter_map(|role| {
        let (i, tool) = model.tools.iter().enumerate().find(|(_, tool)| tool.role == role)?;
        let moved = frame.tool_displacement.get(i).copied().unwrap_or_default();
        let closest = tool.profile.closest(node - moved);
        let gap = closest.distance / thickness - 0.5;
        let touches = gap < TOUCHES && gap > -0.5 - BEHIND;
        touches.then(|| Touch { tool, moved, band: of_piece(model.geometry, tool, closest.piece, node - moved) })
    });
    touches.into_iter().next()
}

/// What a stretch is that lies against nothing, by its neighbours.
fn between(geometry: Geometry, node: Point, inner: Option<&Touch>, outer: Option<&Touch>) -> Band {
    let along = |touch: &Touch| {
        let at = node - touch.moved;
        of_piece(geometry, touch.tool, touch.tool.profile.closest(at).piece, at)
    };
    match (inner, outer) {
        (Some(inner), Some(outer)) if inner.is_punch() == outer.is_punch() => along(inner),
        (Some(inner), None) if !inner.is_punch() => along(inner),
        (None, Some(outer)) if outer.is_punch() => along(outer),
        (None, _) => Band::Dome,
        (Some(Touch { band: Band::Dome, .. }), _) => Band::Unsupported,
        _ => Band::Wall,
    }
}

/// What a piece of a tool makes of the sheet at a point of the tool's own frame.
fn of_piece(geometry: Geometry, tool: &Tool, piece: usize, at: Point) -> Band {
    let (role, profile) = (tool.role, &tool.profile);
    match &profile.pieces()[piece] {
        Piece::Arc(arc) if arc.sweep < 0.0 => match role {
            Role::Punch => nose(geometry, profile, at),
            Role::Die => Band::DieRadius,
            Role::Holder => Band::HolderRadius,
        },
        Piece::Arc(_) if role == Role::Die => Band::DieCorner,
        piece => {
            let tangent = piece.tangent(false) + piece.tangent(true);
            let is_level = tangent.y.abs() < LEVEL.tan() * tangent.x.abs();
            let edge = || profile.corners().map(|corner| corner.center.x).fold(f64::INFINITY, f64::min);
            match role {
                _ if !is_level => Band::Wall,
                Role::Punch => Band::Bottom,
                Role::Die if at.x < edge() && edge().is_finite() => Band::Bottom,
                Role::Die | Role::Holder => Band::Flange,
            }
        }
    }
}

/// What a convex arc of a punch makes: its edge, or the end of a punch that is round or crowned from the axis on.
fn nose(geometry: Geometry, profile: &Profile, at: Point) -> Band {
    let mut corners = profile.corners();
    let from_axis = corners.next().filter(|corner| on_axis(&corner.at(0.0)) || on_axis(&corner.at(1.0)));
    match (from_axis, corners.next()) {
        (Some(_), None) if geometry == Geometry::Axisymmetric => Band::Dome,
        (Some(crown), Some(_)) if at.x < crown.at(0.0).x.max(crown.at(1.0).x) => Band::Bottom,
        _ => Band::PunchRadius,
    }
}
