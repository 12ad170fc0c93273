//! One step of the first stage, iteration by iteration, with each of the corrector's matrices from the same state.

use crate::case::case;
use crate::json::{Numbers, Value, table};
use crate::question::{Failure, Question};
use stampflow::model::Iteration;
use stampflow::solver::trace::{Asked, Iterated, Way, key, trace};

/// The case's own first.
const MATRICES: [Iteration; 3] = [Iteration::PrimalDual, Iteration::Newton, Iteration::Secant];

/// The iterations of a step with each of the matrices, and where its power goes.
pub fn step(question: &Question, numbers: &mut Numbers) -> Result<Value, Failure> {
    let case = case(question)?;
    let step = question.text("step").parse().unwrap_or(1);
    let asked = Asked { step, matrices: MATRICES.to_vec(), ..Asked::default() };
    let traced = trace(&case.stages, &asked, &mut ())
        .map_err(|none| Failure { what: none.to_string(), ..Failure::default() })?;
    let (record, power) = (&traced.record, &traced.record.power);
    let ways = traced.ways.iter().map(|way| json(way, numbers)).collect::<Vec<_>>();
    let cutoff = traced.ways.iter().find_map(|way| way.attempts.last()?.passes.last()?.cutoff);
    Ok(table! {
        "step": step,
        "travel": record.travel,
        "tolerance": traced.tolerance(),
        "cutoff": cutoff,
        "ways": ways,
        "power": table! {
            "external": power.external,
            "plastic": power.plastic,
            "elastic": power.elastic,
            "friction": power.friction,
            "contact": power.contact,
        },
    })
}

/// Velocity norms of all tries, and the iterates of the last.
fn json(way: &Way, numbers: &mut Numbers) -> Value {
    let passes = way.attempts.iter().flat_map(|attempt| &attempt.passes);
    let norms = passes.flat_map(|pass| &pass.iterated).filter_map(|iterated| iterated.velocity_norm);
    let norms = numbers.put(norms);
    let iterates = way.iterations().iter().map(|iterated| iterate(iterated, numbers)).collect::<Vec<_>>();
    table! { "matrix": key(way.matrix), "converged": way.converged, "velocity": norms, "iterates": iterates }
}

fn iterate(iterated: &Iterated, numbers: &mut Numbers) -> Value {
    let touching = &iterated.touching;
    table! {
        "velocity": iterated.velocity_norm,
        "nodes": numbers.put(iterated.nodes.iter().flat_map(|node| [node[0], node[1]])),
        "forces": numbers.put(iterated.imbalance.iter().flat_map(|force| [force.x, force.y])),
        "increments": numbers.put(iterated.increments.iter().map(|most| most[0])),
        "yieldStresses": numbers.put(iterated.increments.iter().map(|most| most[1])),
        "cutOff": numbers.put(iterated.cut_off.iter().map(|is| f64::from(u8::from(*is)))),
        "contacts": numbers.put(touching.iter().flat_map(|at| [at.position.x, at.position.y, at.force.x, at.force.y])),
        "sticking": iterated.sticking(),
    }
}
