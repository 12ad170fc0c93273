//! One step of the first stage, iteration by iteration, with each of the corrector's matrices from the same state.

use crate::lock;
use serde_json::{Value, json};
use stampflow::case::Case;
use stampflow::model::Iteration;
use stampflow::solver::trace::{IterationHistory, NoSuchStep, Trace, TraceRequest, trace};
use stampflow::solver::{IterateSnapshot, solution::IterationRecord};
use std::sync::Mutex;

/// Trace of the last request, for the points of its elements.
static LAST: Mutex<Option<Trace>> = Mutex::new(None);

/// Iterations of a step with each matrix, and where its power goes.
pub fn step(case: &Case, step: usize) -> Result<Value, NoSuchStep> {
    let request = TraceRequest { stage: 1, step, matrices: Iteration::ALL.to_vec(), tolerance: None };
    let traced = trace(&case.stages, &request, &mut ())?;
    let (record, power) = (&traced.record, &traced.record.power);
    let histories = traced.histories.iter().map(with_matrix);
    let answer = json!({
        "step": step,
        "travel": record.travel,
        "tolerance": traced.tolerance,
        "isElastic": case.model().elasticity().is_some(),
        "duration": traced.dt,
        "ways": histories.collect::<Vec<_>>(),
        "power": { "external": power.external, "plastic": power.plastic, "elastic": power.elastic, "friction": power.friction, "contact": power.contact },
    });
    *lock(&LAST) = Some(traced);
    Ok(answer)
}

/// Thickness points of an element in an iteration of the last pass of the traced step.
pub fn points(way: usize, iteration: usize, element: usize) -> Option<Value> {
    let last = lock(&LAST);
    let history = last.as_ref()?.histories.get(way)?;
    let iterate = last_iterates(history).get(iteration)?;
    Some(json!({ "points": iterate.points.get(element)? }))
}

fn last_iterates(history: &IterationHistory) -> &[IterateSnapshot] {
    &history.iterates[history.iterates.len() - history.last_pass().len()..]
}

/// Velocity norms of all tries, and the iterates of the last.
fn with_matrix(history: &IterationHistory) -> Value {
    let rows = || history.rows.iter().filter(|row| row.iteration > 0);
    let iterates = history.last_pass().iter().zip(last_iterates(history));
    json!({
        "matrix": history.matrix.key(),
        "converged": history.end.is_some(),
        "velocity": rows().map(|row| row.velocity_norm).collect::<Vec<_>>(),
        "residual": rows().map(|row| row.residual_norm).collect::<Vec<_>>(),
        "iterates": iterates.map(|(row, iterate)| one(row, iterate)).collect::<Vec<_>>(),
    })
}

fn one(row: &IterationRecord, iterate: &IterateSnapshot) -> Value {
    json!({
        "velocity": (row.iteration > 0).then_some(row.velocity_norm),
        "residual": row.residual_norm,
        "nodes": iterate.nodes,
        "tools": iterate.tools,
        "forces": iterate.imbalance,
        "correction": iterate.correction,
        "cutOff": iterate.cut_off,
        "contacts": iterate.contacts,
    })
}
