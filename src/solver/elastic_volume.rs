//! Elastic change of the sheet's volume.
//!
//! ```text
//! t = t₀ exp(−ε_s − ε_θ + ln J),   ln J = (1 − 2ν)(τ_s + τ_θ)/E, the mean through the thickness
//! ```
//!
//! Within a step t goes with the ln J of its start, and the virtual work of contact leaves δ ln J out. The pressure of tools,
//! 3(1 − 2ν) p/2E, is neglected. A sheet formed by the flow law takes the volume of its stress in the first elastic step.

use super::evaluation::Evaluation;
use super::step::Step;
use crate::material::Elastic;
use crate::solver::state::State;

/// Corrects the thickness of `next` by the volume strain of its stress.
pub(super) fn follow(elastic: Elastic, step: &Step, evaluation: &Evaluation, next: &mut State) {
    for (e, updates) in evaluation.updates.rows().enumerate() {
        let points = updates.iter().zip(&step.context.rule);
        let volume: f64 = points.map(|(update, at)| at.weight * elastic.volume_strain(update.stress)).sum();
        next.thickness[e] *= (volume - next.dilation[e]).exp();
        next.dilation[e] = volume;
    }
}
