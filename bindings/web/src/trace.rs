//! One step of the first stage, iteration by iteration, with each of the corrector's matrices from the same state.

use crate::request::Failure;
use serde_json::{Value, json};
use stampflow::case::Case;
use stampflow::model::Iteration;
use stampflow::solver::trace::{TraceRequest, trace};

/// The case's own first.
const MATRICES: [Iteration; 3] = [Iteration::PrimalDual, Iteration::Newton, Iteration::Secant];

/// Iterations of a step with each matrix, and where its power goes.
pub fn step(case: &Case, step: usize) -> Result<Value, Failure> {
    let request = TraceRequest { step, matrices: MATRICES.to_vec(), ..TraceRequest::default() };
    let traced = trace(&case.stages, &request, &mut ())
        .map_err(|none| Failure { what: none.to_string(), ..Failure::default() })?;
    let (record, power) = (&traced.record, &traced.record.power);
    Ok(json!({
        "step": step,
        "travel": record.travel,
        "tolerance": traced.tolerance,
        "power": {
            "external": power.external,
            "plastic": power.plastic,
            "elastic": power.elastic,
            "friction": power.friction,
            "contact": power.contact,
        },
    }))
}
