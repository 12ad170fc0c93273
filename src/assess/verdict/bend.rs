//! Whether the sheet is bent over radii that a thin shell follows.

use super::{Finding, Light, largest};
use crate::assess::check::THIN;
use crate::solution::StageSolution;
use crate::table::Unit;

/// Bending radius over the thickness at which a fibre's strain is as large as plastic ones in deep draws, and a shell is none
/// \[–\].
const SHARP: f64 = 2.0;

/// Smallest bending radius of the mid-surface over the thickness.
pub(super) fn judge(passes: &[StageSolution]) -> Option<Finding> {
    let sharpest = largest(passes, |step| step.sharpest_bend);
    if sharpest <= 0.0 {
        return None;
    }
    let ratio = 1.0 / sharpest;
    let light = match ratio {
        r if r < SHARP => Light::Red,
        r if r < THIN => Light::Amber,
        _ => Light::Green,
    };
    Some(Finding {
        key: "bend_radius",
        label: "Bending radius",
        light,
        value: Some(ratio),
        unit: Unit::None,
        found: format!("{ratio:.2} thicknesses at the sharpest"),
        limit: format!("{THIN} thicknesses at least, refused below {SHARP}: thin-shell theory"),
        source: super::DECLARED,
        advice: light.advice("larger radii; else take strains and spring-back there with care"),
    })
}
