//! Overall height and thickest place of a part.

use crate::solver::solution::Frame;

/// Overall height of a part along the punch travel \[mm\]: range of the mid-surface and half the thickness of its middle.
pub fn part_height(frame: &Frame) -> Option<f64> {
    let z = || frame.nodes.iter().map(|node| node.z);
    let (low, high) = (z().reduce(f64::min)?, z().reduce(f64::max)?);
    Some(high - low + 0.5 * frame.nodes.first()?.thickness)
}

/// Thickness and initial distance from the axis of the thickest element \[mm\].
pub fn thickest(frame: &Frame) -> Option<(f64, f64)> {
    let thickest = frame.elements.iter().max_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    Some((thickest.thickness, thickest.s0))
}
