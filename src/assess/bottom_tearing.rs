//! Whether a cup's wall carries the punch force.

use super::nose::NoseEnd;
use super::run::{Run, at_event};
use super::{Finding, Light, thinning};
use crate::assess::estimate::{draw_ratio, tensile_strength};
use crate::model::{Edge, Geometry};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::Unit;
use crate::units::{Amount, joined};
use std::f64::consts::PI;

/// Tear-off factor a_R \[–\]: 1 for a metal and an edge that nothing is known of, 1.6 the largest that is measured.
const FACTORS: [f64; 2] = [1.0, 1.6];
/// Share of the force for which nothing is known that counts as near it \[–\].
const NEAR: f64 = 0.9;

/// The peak punch force over what a wall carries past the punch's nose, π (d₁ + s₀) s₀ R_m; where the nose ends in a
/// leaning wall d₁ is the diameter there, and of the wall's force the part along the axis counts.
///
/// Of the stage of a flat-bottomed cup, drawn at room temperature without gas, that comes nearest; punches of other shapes
/// tear elsewhere.
///
/// # References
/// 4ming, Forming handbook, "Tearing force", equations 1 and 2 (4ming.de/en/forming-handbook/tearing-force):
/// F_BR = π (d₁ + s₀) s₀ R_m a_R with a_R = 1 … 1.6. The works that it quotes were not read.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let forces = run.stages.iter().enumerate().filter_map(|(i, solved)| Some((i, forces(solved, i)?)));
    let ratio = |(_, (peak, tears)): &(usize, (&StepRecord, f64))| peak.punch_force / tears;
    let (i, (peak, tears)) = forces.max_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let factor = peak.punch_force / tears;
    let light = Light::of(factor, [NEAR * FACTORS[0], FACTORS[1]]);
    let force = format!("punch force up to {force}", force = Amount::force(peak.punch_force, Unit::N));
    let force = joined([force, at_event(&run.stages[i], peak)], " ");
    let found = format!("{force}, {share} of the limit", share = Amount::share(factor));
    let limit = format!(
        "{force} = π (d₁ + s₀) s₀ R_m at the end of the nose, near it from {near} on; some metals and noses carry up to {most} \
         times that",
        force = Amount::force(tears, Unit::N),
        near = Amount::given_share(NEAR),
        most = Amount::number(FACTORS[1])
    );
    Some(
        Finding::judged("bottom_tearing", "Bottom tearing", light, run.of_stage(found, i))
            .against(100.0 * factor, Unit::Percent, limit)
            .at_most(100.0 * NEAR * FACTORS[0], 100.0 * FACTORS[1])
            .source("4ming, Forming handbook, Tearing force, eqs. 1 and 2")
            .advice(thinning::advice(run, &run.stages[i], NoseEnd::of(&run.stages[i])?.radius)),
    )
}

/// The step of a stage with the peak force, and the force that tears its wall off \[N\].
fn forces(solved: &StageSolution, stage: usize) -> Option<(&StepRecord, f64)> {
    let model = &solved.model;
    let cold = model.geometry == Geometry::Axisymmetric && model.heat.is_none() && model.gas.is_empty();
    let drawn = if stage == 0 { draw_ratio(model).is_some() } else { model.blank.edge == Edge::Free };
    let nose = NoseEnd::of(solved).filter(|_| cold && drawn && model.release.is_none())?;
    let thickness = model.blank.thickness;
    let strength = tensile_strength(&model.material);
    let tears = PI * (2.0 * nose.radius + thickness) * thickness * strength * nose.cosine;
    let peak = solved.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force))?;
    Some((peak, tears))
}
