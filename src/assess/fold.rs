//! Sheet that folds onto itself: it meets tools only, so that a run goes on through it.

use super::{tear::place, *};
use crate::geometry::{Piece, Point};
use crate::measure::along;
use crate::solver::solution::Frame;

/// Distance of two stretches of the mid-surface over the thickness, below which they are in one another: a tenth is penetration \[–\].
const NEAR: f64 = 0.9;
/// Length between these over the thickness; round the sharpest bend, of radius t/2, it is π/2 \[–\].
const APART: f64 = 3.0;

/// Initial distance from the axis where the mid-surface comes near to itself \[mm\].
pub fn folded(frame: &Frame) -> Option<f64> {
    let (nodes, along) = (&frame.nodes, along(frame));
    let point = |i: usize| Point::new(nodes[i].r, nodes[i].z);
    let meets = |i: &usize| {
        let (segment, t) = (Piece::line(point(*i), point(i + 1)), nodes[*i].thickness);
        let is_apart = |j: &usize| along[*j] < along[*i] - APART * t || along[*j] > along[i + 1] + APART * t;
        let mut others = (0..nodes.len()).filter(is_apart).map(point);
        others.any(|other| (segment.closest_point(other) - other).norm() < NEAR * t)
    };
    (0..frame.elements.len()).find(meets).map(|i| frame.elements[i].s0)
}

pub(super) fn first(stages: &[StageSolution]) -> Option<(usize, &Frame)> {
    let (i, stage) = formed(stages).last()?;
    folded(stage.frames.last()?)?;
    Some((i, stage.frames.iter().find(|frame| folded(frame).is_some())?))
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let (i, frame) = first(run.stages)?;
    let stage = &run.stages[i];
    let at = place(run.stages, folded(stage.frames.last()?)?);
    let instant = instant(stage, frame.travel, frame.time);
    let text = run.of_stage(format!("the sheet folds onto itself {at}; seen from {instant} on"), i);
    let judged = Finding::judged("fold", "Fold", text).light(Light::Red).limit("its faces stay apart");
    Some(judged.advice("less feed or travel, larger radii, or less reduction in one step"))
}
