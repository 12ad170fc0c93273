//! Whether a cup's wall carries the punch force.

use super::{Finding, Light};
use crate::case::check::estimate::{draw_ratio, tensile_strength};
use crate::geometry::Arc;
use crate::model::{Geometry, Role, Tool};
use crate::solver::Pass;
use crate::table::Unit;
use std::f64::consts::PI;

/// Tear-off factor a_R \[–\]: 1 for a metal and an edge that nothing is known of, 1.6 the largest that is measured.
const FACTORS: [f64; 2] = [1.0, 1.6];

/// The peak punch force over what a wall carries past the punch's nose, π (d₁ + s₀) s₀ R_m; where the nose ends in a
/// leaning wall d₁ is the diameter there, and of the wall's force the part along the axis counts.
///
/// Of the first stage of a flat-bottomed cup drawn at room temperature without gas; punches of other shapes tear
/// elsewhere.
///
/// # References
/// 4ming, Forming handbook, "Tearing force", equations 1 and 2 (4ming.de/en/forming-handbook/tearing-force):
/// F_BR = π (d₁ + s₀) s₀ R_m a_R with a_R = 1 … 1.6. The works that it quotes were not read.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let Pass { model, run, .. } = passes.first()?;
    let cup = model.geometry == Geometry::Axisymmetric && model.heat.is_none() && model.gas.is_empty();
    draw_ratio(model).filter(|_| cup)?;
    let peak = run.history.iter().map(|step| step.punch_force).fold(0.0, f64::max);
    let thickness = model.blank.thickness;
    let (radius, upright) = nose_end(model.tool(Role::Punch)?, thickness)?;
    let tears = PI * (2.0 * radius + thickness) * thickness * tensile_strength(&model.material.hardening) * upright;
    let factor = peak / tears;
    let light = Light::of(factor, FACTORS);
    Some(Finding {
        key: "bottom_tearing",
        label: "Bottom tearing",
        light,
        value: Some(100.0 * factor),
        unit: Unit::Percent,
        found: format!("punch force up to {:.1} kN, {:.0} % of the limit", 1e-3 * peak, 100.0 * factor),
        limit: format!(
            "{:.1} kN = π (d₁ + s₀) s₀ R_m at the end of the nose; some metals and noses carry up to {} times that",
            1e-3 * tears,
            FACTORS[1]
        ),
        source: "4ming, Forming handbook, Tearing force, eqs. 1 and 2",
        advice: light.advice(super::thinning::ADVICE),
    })
}

/// Where the nose of a punch with a flat bottom, of that radius \[mm\] at least, ends in its wall: the radius there
/// \[mm\], and the cosine of the wall's lean.
fn nose_end(punch: &Tool, bottom: f64) -> Option<(f64, f64)> {
    let nose = punch.profile.corners().min_by(|a, b| inner(a).total_cmp(&inner(b)))?;
    let end = [nose.at(0.0), nose.at(1.0)].into_iter().max_by(|a, b| a.x.total_cmp(&b.x))?;
    (inner(&nose) > bottom).then(|| (end.x, (end.x - nose.center.x) / nose.radius))
}

/// Smallest distance of an arc's ends from the axis \[mm\].
fn inner(arc: &Arc) -> f64 {
    arc.at(0.0).x.min(arc.at(1.0).x)
}
