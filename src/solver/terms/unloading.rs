//! Unloading: the forces of tools that were taken away, as external loads that fade to nothing over the run.

use crate::element::section;
use crate::model::Model;
use crate::numerics::lobatto::ThicknessPoint;
use crate::solver::equilibrium::{Evaluation, largest};
use crate::solver::step::{Step, references};
use crate::state::State;
use nalgebra::Vector3;

/// What the stress in the sheet asks for at every node to be in equilibrium \[N, N mm\].
pub fn forces(model: &Model, state: &State, rule: &[ThicknessPoint]) -> Vec<Vector3<f64>> {
    let mut forces = vec![Vector3::zeros(); state.nodes.len()];
    for (e, reference) in references(model, state, &state.bends).enumerate() {
        let Some(current) = reference.moved([0.0; 3], [0.0; 3]) else { continue };
        let points = state.points.row(e);
        let force = section::forces(&current, state.volume[e], state.thickness[e], rule, |k| points[k].stress);
        forces[e] += force.fixed_rows::<3>(0);
        forces[e + 1] += force.fixed_rows::<3>(3);
    }
    forces
}

/// What is left of the forces at the end of the step; returns the largest of a node before they faded.
pub fn add(step: &Step, out: &mut Evaluation) -> f64 {
    let left = 1.0 - step.end() / step.model.duration;
    for (rhs, force) in out.system.rhs.iter_mut().zip(&step.process.unloading) {
        *rhs += force * left;
    }
    largest(&step.process.unloading)
}
