//! Unloading: the forces of tools that were taken away, as external loads that fade to nothing over the run.

use crate::solver::evaluation::{Evaluation, largest};
use crate::solver::step::Step;

/// What is left of the forces at the end of the step; returns the largest of a node before they faded.
pub fn add(step: &Step, out: &mut Evaluation) -> f64 {
    let left = 1.0 - step.end() / step.model.duration;
    for (rhs, force) in out.system.rhs.iter_mut().zip(&step.process.unloading) {
        *rhs += force * left;
    }
    largest(&step.process.unloading)
}
