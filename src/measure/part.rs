//! What a part came out as, over all: its height and its thickest place.

use crate::solver::solution::Frame;

/// Height of a part over all \[mm\], along the punch travel: from the lowest to the highest place of the mid-surface, and
/// half the thickness of the sheet's middle; without sign. Of a cup that is from the outside of its bottom to the middle of
/// its rim. `None` without nodes.
pub fn part_height(frame: &Frame) -> Option<f64> {
    let z = || frame.nodes.iter().map(|node| node.z);
    let (low, high) = (z().reduce(f64::min)?, z().reduce(f64::max)?);
    Some(high - low + 0.5 * frame.nodes.first()?.thickness)
}

/// The thickest element: its thickness \[mm\] and initial distance from the axis or symmetry plane \[mm\]. `None` without
/// elements.
pub fn thickest(frame: &Frame) -> Option<(f64, f64)> {
    let thickest = frame.elements.iter().max_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    Some((thickest.thickness, thickest.s0))
}
