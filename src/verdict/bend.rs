//! Whether the sheet is bent over radii that a thin shell follows.

use super::{Finding, Light, largest};
use crate::case::check::THIN;
use crate::solver::Pass;
use crate::table::Unit;

/// Smallest bending radius of the mid-surface over the thickness.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let sharpest = largest(passes, |step| step.sharpest_bend);
    if sharpest <= 0.0 {
        return None;
    }
    let ratio = 1.0 / sharpest;
    let light = if ratio < THIN { Light::Amber } else { Light::Green };
    Some(Finding {
        key: "bend_radius",
        label: "Bending radius",
        light,
        value: Some(ratio),
        unit: Unit::None,
        found: format!("{ratio:.2} thicknesses at the sharpest"),
        limit: format!("{THIN} thicknesses at least: thin-shell theory"),
        source: super::DECLARED,
        advice: light.advice("larger radii; else take strains and spring-back there with care"),
    })
}
