//! The elastic change of the sheet's volume in a step, by which its elements are thicker than strains in the plane alone say.
//!
//! ```text
//! t = t₀ exp(−ε_s − ε_θ + ln J),   ln J = (1 − 2ν)(τ_s + τ_θ)/E, the mean through the thickness
//! ```

use super::evaluation::Evaluation;
use super::step::Step;
use crate::material::Elastic;
use crate::material::flow::Triple;
use crate::state::State;

/// Corrects the thickness of `next`, at the end of a step, by what the change of stress in the step has done to the volume.
pub(super) fn follow(elastic: Elastic, step: &Step, evaluation: &Evaluation, next: &mut State) {
    for (e, updates) in evaluation.updates.rows().enumerate() {
        let points = step.state.points.row(e).iter().zip(updates).zip(&step.process.rule);
        let change = |before: Triple, now: Triple| elastic.volume_strain(now) - elastic.volume_strain(before);
        let volume: f64 = points.map(|((before, now), at)| at.weight * change(before.stress, now.stress)).sum();
        next.thickness[e] *= volume.exp();
        next.dilation[e] += volume;
    }
}
