//! What a part came out as, over all: its height and its thickest place.

use crate::record::Frame;

/// Overall height of a part \[mm\]: along the punch travel from the outside of the sheet's middle, a cup's bottom, to the
/// mid-surface at its edge, a cup's rim; without sign. `None` without nodes.
pub fn part_height(frame: &Frame) -> Option<f64> {
    let (middle, edge) = (frame.nodes.first()?, frame.nodes.last()?);
    Some((middle.z - edge.z).abs() + 0.5 * middle.thickness)
}

/// The thickest element: its thickness \[mm\] and initial distance from the axis or symmetry plane \[mm\]. `None` without
/// elements.
pub fn thickest(frame: &Frame) -> Option<(f64, f64)> {
    let thickest = frame.elements.iter().max_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    Some((thickest.thickness, thickest.s0))
}
