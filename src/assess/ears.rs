//! What the computed rim, alike all round, stands for in a sheet that is not alike in its directions.

use super::{Finding, Light, run::Run};
use crate::model::{Edge, Geometry};
use crate::table::Unit;
use crate::units::Amount;

/// The ears to be expected about the computed rim, where the r-values by direction are given; nothing of a part whose edge
/// is not drawn in.
pub(super) fn expected(run: &Run) -> Option<Finding> {
    let r = run.case.r_values?;
    let last = run.stages.last()?;
    let frame = last.frames.last()?;
    let model = &last.model;
    if model.geometry != Geometry::Axisymmetric || model.blank.edge == Edge::Clamped {
        return None;
    }
    let lengths = frame.nodes.windows(2).map(|pair| (pair[1].r - pair[0].r).hypot(pair[1].z - pair[0].z));
    let hoops = frame.elements.iter().map(|element| element.strain_hoop);
    let ears = r.ears(lengths.zip(hoops));
    let [low, high] = [f64::min, f64::max].map(|of| ears.into_iter().reduce(of).unwrap_or_default());
    let [along, diagonal, across] = ears.map(Amount::place);
    let found = format!(
        "the edge is the mean over the directions: at 0, 45 and 90° to rolling {along}, {diagonal} and {across} beyond it are \
         expected (Δr = {planar})",
        planar = Amount::ratio(r.planar())
    );
    Some(
        Finding::judged("ears", "Ears", Light::Green, found)
            .against(high - low, Unit::Mm, "told, not judged: what is trimmed off is larger")
            .source("an estimate of the trend: hoop compression with r by direction (Yoon, Dick and Barlat 2011, abstract read)"),
    )
}
