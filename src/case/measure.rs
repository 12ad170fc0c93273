//! Sizes read off a tool's section, however it was drawn.

use crate::model::Tool;

/// Smallest and largest r of a tool [mm].
pub(super) fn extent(tool: &Tool) -> (f64, f64) {
    let points = tool.profile.polyline(0.01);
    points.iter().fold((f64::INFINITY, 0.0), |(low, high), p| (p.x.min(low), p.x.max(high)))
}

/// Where the die's corners end and its flat begins [mm].
pub(super) fn shoulder_end(die: &Tool) -> f64 {
    die.profile.corners().map(|a| a.at(0.0).x.max(a.at(1.0).x)).fold(extent(die).0, f64::max)
}
