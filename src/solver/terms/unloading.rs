//! Unloading: forces of removed tools as external loads that fade over the run.

use crate::solver::evaluation::{Evaluation, largest};
use crate::solver::step::Step;

/// Adds the remaining forces at the end of the step; returns the largest initial one of a node.
pub fn add(step: &Step, out: &mut Evaluation) -> f64 {
    let left = 1.0 - step.end() / step.model.duration;
    for (rhs, force) in out.system.rhs.iter_mut().zip(&step.context.unloading) {
        *rhs += force * left;
    }
    largest(&step.context.unloading)
}
