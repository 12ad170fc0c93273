//! Tearing of a cup's bottom: punch force against the strength of the wall.

use super::estimate::{draw_ratio, tensile_strength};
use super::{Finding, Run, at_event, tear};
use crate::geometry::Arc;
use crate::model::{Edge, Geometry, Role, Tool};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::{Amount, Unit, joined};
use std::f64::consts::PI;

/// Tear-off factor a_R \[–\]: 1 for a metal and an edge that nothing is known of, 1.6 the largest measured.
const FACTORS: [f64; 2] = [1.0, 1.6];
/// Share of the force from which on it is near the limit \[–\].
const NEAR: f64 = 0.9;

/// Peak punch force over what a wall carries past the punch's nose, π (d₁ + s₀) s₀ R_m. If the nose ends in a leaning wall,
/// d₁ is the diameter there, and of the wall's force the part along the axis counts.
///
/// For the stage of a flat-bottomed cup, drawn cold without gas, that comes nearest; other punches tear elsewhere.
///
/// # References
/// 4ming, Forming handbook, "Tearing force", equations 1 and 2 (4ming.de/en/forming-handbook/tearing-force):
/// F_BR = π (d₁ + s₀) s₀ R_m a_R with a_R = 1 … 1.6. The works that it quotes were not read.
pub(super) fn judge<'a>(run: &Run<'a>) -> Option<Finding> {
    let share = |(peak, tears): (&'a StepRecord, f64)| (peak.punch_force / tears, (peak, tears));
    let (i, factor, (peak, tears)) = run.peak(|i, stage| forces(stage, i).map(share))?;
    let stage = &run.stages[i];
    let force = format!("punch force up to {}", Amount::force(peak.punch_force, Unit::N));
    let force = joined([force, at_event(stage, peak)], " ");
    let [near, least, most] = [NEAR, FACTORS[0], FACTORS[1]].map(Amount::given_share);
    let limit = format!(
        "{} = π (d₁ + s₀) s₀ R_m at the end of the nose, near it from {near} on; between {least} and {most} it may or may not \
         tear",
        Amount::force(tears, Unit::N)
    );
    Finding::judged("bottom_tearing", "Bottom tearing", run.of_stage(format!("{force}, {{}} of the limit"), i))
        .number(Amount::share(factor))
        .at_most(100.0 * NEAR * FACTORS[0], 100.0 * FACTORS[1])
        .limit(limit)
        .source("4ming, Forming handbook, Tearing force, eqs. 1 and 2")
        .advice(tear::advice(run, stage, NoseEnd::of(stage)?.radius))
        .into()
}

/// Step of a stage with the peak force, and the force that tears its wall off \[N\].
fn forces(solved: &StageSolution, stage: usize) -> Option<(&StepRecord, f64)> {
    let model = &solved.model;
    let cold = model.geometry == Geometry::Axisymmetric && model.heat.is_none() && model.gas.is_empty();
    let drawn = if stage == 0 { draw_ratio(model).is_some() } else { model.blank.edge == Edge::Free };
    let nose = NoseEnd::of(solved).filter(|_| cold && drawn && model.release.is_none())?;
    let thickness = model.blank.thickness;
    let tears = PI * (2.0 * nose.radius + thickness) * thickness * tensile_strength(&model.material) * nose.cosine;
    let peak = solved.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force))?;
    Some((peak, tears))
}

/// Cosine of a wall's lean up to which it counts as upright, to a degree.
const UPRIGHT: f64 = 0.9998;

#[derive(Clone, Copy, Debug)]
pub(super) struct NoseEnd {
    /// \[mm\]
    pub radius: f64,
    /// Cosine of the wall's lean to the axis \[–\].
    pub cosine: f64,
}

impl NoseEnd {
    /// `None` without a punch, and for one without a flat bottom as wide as the sheet is thick.
    pub fn of(stage: &StageSolution) -> Option<Self> {
        let nose = nose(stage.model.tool(Role::Punch)?)?;
        let end = [nose.at(0.0), nose.at(1.0)].into_iter().max_by(|a, b| a.x.total_cmp(&b.x))?;
        let flat = inner(&nose) > stage.model.blank.thickness;
        flat.then(|| Self { radius: end.x, cosine: (end.x - nose.center.x) / nose.radius })
    }

    /// Whether the wall above is upright.
    pub fn is_upright(self) -> bool {
        self.cosine > UPRIGHT
    }
}

pub(super) fn nose(punch: &Tool) -> Option<Arc> {
    punch.profile.corners().min_by(|a, b| inner(a).total_cmp(&inner(b)))
}

/// Smallest distance of an arc's ends from the axis \[mm\].
fn inner(arc: &Arc) -> f64 {
    arc.at(0.0).x.min(arc.at(1.0).x)
}
