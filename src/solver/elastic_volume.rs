//! The elastic change of the sheet's volume, by which its elements are thicker than their strains in the plane alone say.
//!
//! ```text
//! t = t₀ exp(−ε_s − ε_θ + ln J),   ln J = (1 − 2ν)(τ_s + τ_θ)/E, the mean through the thickness
//! ```
//!
//! Within a step t goes with the ln J of its start: contact and sections see it a step late, and the virtual work of contact,
//! δt = −t (δε_s + δε_θ), leaves δ ln J out (`docs/contact_on_faces.md` says what both are worth). What tools press on the
//! faces is left out of ln J: 3(1 − 2ν) p/2E. The flow law is rigid in its volume as well. A sheet that it has formed takes
//! the volume of its stress when it is first reckoned as elastic, so that one that bears nothing has the volume of the blank.

use super::evaluation::Evaluation;
use super::step::Step;
use crate::material::Elastic;
use crate::solver::state::State;

/// Corrects the thickness of `next`, at the end of a step, by what its stress does to the volume.
pub(super) fn follow(elastic: Elastic, step: &Step, evaluation: &Evaluation, next: &mut State) {
    for (e, updates) in evaluation.updates.rows().enumerate() {
        let points = updates.iter().zip(&step.process.rule);
        let volume: f64 = points.map(|(update, at)| at.weight * elastic.volume_strain(update.stress)).sum();
        next.thickness[e] *= (volume - next.dilation[e]).exp();
        next.dilation[e] = volume;
    }
}
