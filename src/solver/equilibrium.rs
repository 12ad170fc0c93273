//! Equilibrium: residual r = p − f and matrix H (Sosnowski 1994, equations 7 to 9), sums of the [`terms`](super::terms).

use super::evaluation::{Linearisation, largest};
use super::terms::{bead, contact, gas, holder, sheet};
use super::*;
use std::sync::Arc;

/// Duration of a step at rest over that of the run \[–\].
const AT_REST: f64 = 1e-9;

#[must_use]
pub(super) fn evaluate(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> bool {
    for (x, (start, u)) in out.nodes.iter_mut().zip(step.state.nodes.iter().zip(&trial.moves)) {
        *x = [0, 1, 2].map(|d| start[d] + u[d]);
    }
    out.system.clear();
    if !sheet::add(step, trial, at, out) {
        return false;
    }
    let internal = largest(&out.system.rhs);
    let contact = contact::add(step, trial, at, out);
    bead::add(step, trial, out);
    sheet::stabilise(step, trial, out);
    let gas = gas::add(step, trial, out);
    let left = step.unloading_left(step.end());
    out.system.rhs.iter_mut().zip(step.state.unloading.iter()).for_each(|(rhs, force)| *rhs += force * left);
    if let Some(kept) = &mut trial.kept {
        if at.iteration == 0 { kept.take_matrix(&out.system) } else { out.system.take_matrix(kept) }
    }
    gas::hold_rate(step, trial, out);
    holder::add(step, trial, out);
    constrain(step, out);
    measure_residual(step, internal.max(contact).max(gas).max(largest(&step.state.unloading)), out);
    true
}

/// Nodal forces that keep an elastic sheet at rest in equilibrium at the beginning of a run: those of removed tools \[N, N mm\].
pub(super) fn unloading(model: &Model, state: &State) -> Arc<[Vector3<f64>]> {
    let context = RunContext::new(model, state);
    let (mut trial, mut out) = (Trial::new(&context, state), Evaluation::new(&context, state));
    let step = Step::new(&context, state, AT_REST * model.duration, 1);
    trial.predict(&step, true);
    let matrix = model.settings.iteration;
    let at = Linearisation { matrix, residual_alone: true, iteration: 0, velocity_norm: f64::INFINITY };
    let is_known = evaluate(&step, &mut trial, &at, &mut out);
    if is_known { out.system.rhs.iter().map(|f| -f).collect() } else { Arc::default() }
}

fn constrain(step: &Step, out: &mut Evaluation) {
    let (last, edge) = (out.nodes.len() - 1, step.model.blank.edge);
    out.edge_reaction = -out.system.rhs[last];
    if step.model.blank.theory == Theory::Membrane {
        (0..=last).for_each(|i| out.system.fix(i, 2));
    }
    if step.model.release.is_some() && edge == Edge::Free {
        // Nothing else holds the sheet up; what fades is in balance, so that this bears nothing.
        out.system.fix(0, 1);
    }
    for (i, edge) in step.model.held_edges(last + 1) {
        let held = edge.held(0.0, 0.0).into_iter().enumerate();
        held.filter(|(_, held)| held.is_some()).for_each(|(freedom, _)| out.system.fix(i, freedom));
    }
}

fn measure_residual(step: &Step, largest_force: f64, out: &mut Evaluation) {
    let residuals = out.system.rhs.iter().map(|f| f.xy().norm()).enumerate();
    let (worst, residual) = residuals.fold((0, 0.0), |worst, now| if now.1 > worst.1 { now } else { worst });
    out.worst_node = worst;
    out.residual_norm = match largest_force > 0.0 {
        true => residual / largest_force.max(step.context.least_force),
        // A sheet that all tools have left is at rest; one that none has reached yet says nothing.
        false if step.model.may_be_left() => 0.0,
        false => f64::INFINITY,
    };
}

#[cfg(test)]
mod faces;
#[cfg(test)]
mod tests;
