//! Sheet that folds onto itself: it meets tools only, so that a run goes on through it.

use super::{tear::place, *};
use crate::geometry::{Piece, Point};
use crate::measure::along;

/// Distance of two stretches of the mid-surface over the thickness, below which they are in one another: a tenth is penetration \[–\].
const NEAR: f64 = 0.9;
/// Length between these over the thickness; round the sharpest bend, of radius t/2, it is π/2 \[–\].
const APART: f64 = 3.0;

/// Distance from every tool over the thickness beyond which a node of a tube is free \[–\].
const FREE: f64 = 0.6;
/// Height over the thickness of a ring that a tube's free wall has buckled into \[–\]: declared, elastic waves are far lower.
const RING: f64 = 1.0;

/// Initial distance from the axis where the mid-surface comes near to itself, or where a tube's wall has buckled \[mm\].
pub fn folded(model: &Model, frame: &Frame) -> Option<f64> {
    let ring = ring(model, frame).filter(|(_, height)| *height > RING * model.blank.thickness);
    meets(frame).or_else(|| Some(frame.elements[ring?.0.min(frame.elements.len() - 1)].s0))
}

/// Node at which a tube's wall before its tools stands out or in most between lower places on both sides, or its seat has
/// spread, and how far \[mm\].
fn ring(model: &Model, frame: &Frame) -> Option<(usize, f64)> {
    let is_free = |node: &NodeRecord| {
        let gap = |(tool, moved): (&Tool, &Point)| tool.profile.closest(Point::new(node.r, node.z) - *moved).distance;
        model.tools.iter().zip(&frame.tool_displacement).all(|tool| gap(tool) > FREE * node.thickness)
    };
    // From the end that stays to the first tool; behind it a wall may be rolled up as wished.
    let count = frame.nodes.iter().position(|node| !is_free(node)).map_or(frame.nodes.len(), |i| i + 1);
    let nodes = &frame.nodes[..if model.blank.is_open() { count } else { 0 }];
    let over = |i: usize, sign: f64| {
        let lowest = |side: &[NodeRecord]| side.iter().map(|node| sign * node.r).fold(f64::INFINITY, f64::min);
        sign * nodes[i].r - lowest(&nodes[..i]).max(lowest(&nodes[i + 1..]))
    };
    // Pressure bulges a wall outward by itself.
    let outward = if model.gas.is_empty() { 1.0 } else { -1.0 };
    let inside = (1..nodes.len().max(1) - 1).map(|i| (i, over(i, -1.0).max(over(i, outward))));
    let meridian = model.blank.meridian.as_ref().filter(|_| model.gas.is_empty());
    let seat = nodes.first().zip(meridian).map(|(node, line)| (0, (node.r - line.first().x).abs()));
    inside.chain(seat).max_by(|a, b| a.1.total_cmp(&b.1))
}

fn meets(frame: &Frame) -> Option<f64> {
    let (nodes, along) = (&frame.nodes, along(frame));
    let point = |i: usize| Point::new(nodes[i].r, nodes[i].z);
    let is_near = |i: &usize| {
        let (segment, t) = (Piece::line(point(*i), point(i + 1)), nodes[*i].thickness);
        let is_apart = |j: &usize| along[*j] < along[*i] - APART * t || along[*j] > along[i + 1] + APART * t;
        let mut others = (0..nodes.len()).filter(is_apart).map(point);
        others.any(|other| (segment.closest_point(other) - other).norm() < NEAR * t)
    };
    (0..frame.elements.len()).find(is_near).map(|i| frame.elements[i].s0)
}

pub(super) fn first(stages: &[StageSolution]) -> Option<(usize, &Frame)> {
    let (i, stage) = formed(stages).last()?;
    folded(&stage.model, stage.frames.last()?)?;
    Some((i, stage.frames.iter().find(|frame| folded(&stage.model, frame).is_some())?))
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let (i, frame) = run.fold?;
    let stage = &run.stages[i];
    let last = stage.frames.last()?;
    let at = place(run.stages, folded(&stage.model, last)?);
    let instant = instant(stage, frame.travel, frame.time);
    let what = match (meets(last), ring(&stage.model, last)) {
        (None, Some((_, height))) => format!("a ring {} high has buckled", Amount::place(height)),
        _ => "the sheet folds onto itself".into(),
    };
    let text = run.of_stage(format!("{what} {at}; seen from {instant} on"), i);
    let judged = Finding::judged("fold", "Fold", text).light(Light::Red).limit("faces apart, no ring of over 1 t");
    Some(judged.advice("less feed or travel, larger radii, or less reduction in one step"))
}
