//! One step of the first stage, iteration by iteration, with each of the corrector's matrices from the same state.

use serde_json::{Value, json};
use stampflow::case::Case;
use stampflow::model::Iteration;
use stampflow::solver::IterateSnapshot;
use stampflow::solver::solution::IterationRecord;
use stampflow::solver::trace::{IterationHistory, NoSuchStep, TraceRequest, trace};

/// Matrices by their keys on the page.
const MATRICES: [(Iteration, &str); 3] =
    [(Iteration::PrimalDual, "primal_dual"), (Iteration::Newton, "newton"), (Iteration::Secant, "secant")];

/// Iterations of a step with each matrix, and where its power goes.
pub fn step(case: &Case, step: usize) -> Result<Value, NoSuchStep> {
    let matrices = MATRICES.map(|(matrix, _)| matrix).to_vec();
    let request = TraceRequest { stage: 1, step, matrices, tolerance: None };
    let traced = trace(&case.stages, &request, &mut ())?;
    let (record, power) = (&traced.record, &traced.record.power);
    let histories = traced.histories.iter().zip(MATRICES).map(|(history, (_, key))| with_matrix(history, key));
    Ok(json!({
        "step": step,
        "travel": record.travel,
        "tolerance": traced.tolerance,
        "cutoff": case.model().settings.cutoff_strain,
        "ways": histories.collect::<Vec<_>>(),
        "power": { "external": power.external, "plastic": power.plastic, "elastic": power.elastic, "friction": power.friction, "contact": power.contact },
    }))
}

/// Velocity norms of all tries, and the iterates of the last.
fn with_matrix(history: &IterationHistory, key: &str) -> Value {
    let norms: Vec<f64> = history.rows.iter().filter(|row| row.iteration > 0).map(|row| row.velocity_norm).collect();
    let last = history.last_pass();
    let iterates = &history.iterates[history.iterates.len() - last.len()..];
    json!({
        "matrix": key,
        "converged": history.end.is_some(),
        "velocity": norms,
        "iterates": last.iter().zip(iterates).map(|(row, iterate)| one(row, iterate)).collect::<Vec<_>>(),
    })
}

fn one(row: &IterationRecord, iterate: &IterateSnapshot) -> Value {
    let nodes: Vec<f64> = iterate.nodes.iter().flat_map(|node| [node[0], node[1]]).collect();
    let forces: Vec<f64> = iterate.imbalance.iter().flat_map(|force| [force[0], force[1]]).collect();
    let contacts = iterate.contacts.iter().flat_map(|at| [at.position[0], at.position[1], at.force[0], at.force[1]]);
    json!({
        "velocity": (row.iteration > 0).then_some(row.velocity_norm),
        "nodes": nodes,
        "forces": forces,
        "increments": iterate.increments.iter().map(|most| most[0]).collect::<Vec<_>>(),
        "yieldStresses": iterate.increments.iter().map(|most| most[1]).collect::<Vec<_>>(),
        "cutOff": iterate.cut_off,
        "contacts": contacts.collect::<Vec<_>>(),
        "sticking": iterate.contacts.iter().filter(|contact| contact.sticks).count(),
    })
}
