//! Whether a cup's wall carries the punch force.

use super::{Finding, Light};
use crate::case::check::estimate::{draw_ratio, tensile_strength};
use crate::case::measure::extent;
use crate::model::{Geometry, Role};
use crate::solver::Pass;
use crate::table::Unit;
use std::f64::consts::PI;

/// Tear-off factor a_R \[–\]: 1 for a metal and an edge that nothing is known of, 1.6 the largest that is measured.
const FACTORS: [f64; 2] = [1.0, 1.6];

/// The peak punch force, all of which the wall carries past the punch's edge, over π (d₁ + s₀) s₀ R_m.
///
/// Of the first stage of a cup drawn at room temperature without gas; punches of other shapes tear elsewhere.
///
/// # References
/// 4ming, Forming handbook, "Tearing force", equations 1 and 2 (4ming.de/en/forming-handbook/tearing-force):
/// F_BR = π (d₁ + s₀) s₀ R_m a_R with a_R = 1 … 1.6. The works that it quotes were not read.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let Pass { model, run, .. } = passes.first()?;
    let cup = model.geometry == Geometry::Axisymmetric && model.heat.is_none() && model.gas.is_empty();
    draw_ratio(model).filter(|_| cup)?;
    let peak = run.history.iter().map(|step| step.punch_force).fold(0.0, f64::max);
    let diameter = 2.0 * extent(model.tool(Role::Punch)?).1;
    let thickness = model.blank.thickness;
    let tears = PI * (diameter + thickness) * thickness * tensile_strength(&model.material.hardening);
    let factor = peak / tears;
    let light = Light::of(factor, FACTORS);
    Some(Finding {
        key: "bottom_tearing",
        label: "Bottom tearing",
        light,
        value: Some(100.0 * factor),
        unit: Unit::Percent,
        found: format!("the wall carries {:.1} kN, {:.0} % of {:.1} kN", 1e-3 * peak, 100.0 * factor, 1e-3 * tears),
        limit: format!("π (d₁ + s₀) s₀ R_m; at most {} times that, by metal and punch edge", FACTORS[1]),
        source: "4ming, Forming handbook, Tearing force, eqs. 1 and 2",
        advice: light.advice(super::thinning::ADVICE),
    })
}
