//! One step of the first stage, iteration by iteration, with each of the corrector's matrices.

use crate::case::case;
use crate::numbers::Numbers;
use crate::question::Failure;
use serde_json::{Value, json};
use stampflow::model::Iteration;
use stampflow::solution::IterationRecord;
use stampflow::solver::{Iterate, run};
use stampflow::{Model, Observer, StepRecord};

/// Strain increment over the cut-off below which a place counts as nearly rigid \[–\].
const NEARLY_RIGID: f64 = 10.0;

const MATRICES: [(&str, Iteration); 3] =
    [("primal_dual", Iteration::PrimalDual), ("newton", Iteration::Newton), ("secant", Iteration::Secant)];

/// An observer of one step, which ends the run there.
struct Watch<'n> {
    step: usize,
    /// Of the last way to equilibrium: others did not come there.
    iterations: Vec<IterationRecord>,
    iterates: Vec<Value>,
    /// Where iterates are kept.
    numbers: Option<&'n mut Numbers>,
    record: Option<StepRecord>,
}

impl<'n> Watch<'n> {
    fn of(step: usize, numbers: Option<&'n mut Numbers>) -> Self {
        Self { step, iterations: Vec::new(), iterates: Vec::new(), numbers, record: None }
    }
}

impl Observer for Watch<'_> {
    fn step(&mut self, record: &StepRecord) {
        if record.step == self.step {
            self.record = Some(*record);
        }
    }

    fn iteration(&mut self, record: &IterationRecord) {
        if record.step == self.step {
            if record.iteration <= 1 {
                self.iterations.clear();
            }
            self.iterations.push(*record);
        }
    }

    fn wants_to_stop(&mut self) -> bool {
        self.record.is_some()
    }

    fn wants_iterates(&self) -> bool {
        self.numbers.is_some()
    }

    fn iterate(&mut self, iterate: &Iterate<'_>) {
        let Some(numbers) = self.numbers.as_mut().filter(|_| iterate.step == self.step) else { return };
        if iterate.iteration == 0 {
            self.iterates.clear();
        }
        let largest = (0..iterate.thickness.len()).map(|e| {
            let points = iterate.updates.row(e).iter();
            points.fold([0.0, 0.0], |most: [f64; 2], point| match point.increment > most[0] {
                true => [point.increment, point.yield_stress],
                false => most,
            })
        });
        let largest: Vec<[f64; 2]> = largest.collect();
        self.iterates.push(json!({
            "nodes": numbers.put(iterate.nodes.iter().flat_map(|node| [node[0], node[1]])),
            "forces": numbers.put(iterate.imbalance.iter().flat_map(|force| [force.x, force.y])),
            "increments": numbers.put(largest.iter().map(|most| most[0])),
            "yieldStresses": numbers.put(largest.iter().map(|most| most[1])),
        }));
    }
}

/// The iterations of a step with the case's own matrix, their norms with each of the three, and where its power goes.
pub fn step(question: &Value, numbers: &mut Numbers) -> Result<Value, Failure> {
    let case = case(question)?;
    let model = case.model();
    let step = question["step"].as_u64().and_then(|step| usize::try_from(step).ok()).unwrap_or(1).max(1);
    let mut watch = Watch::of(step, Some(numbers));
    let solved = run(model, &mut watch);
    let (iterates, record) = (watch.iterates, watch.record);
    let Some(record) = record else {
        let what = format!("the run has {} steps, and none of the number {step}", solved.steps.len());
        return Err(Failure { what, ..Failure::default() });
    };
    let norms: Vec<Value> = MATRICES.iter().map(|(name, matrix)| norms(name, *matrix, model, step, numbers)).collect();
    let before = solved.steps.iter().rev().find(|other| other.step < step).map_or(0.0, |other| other.travel);
    let share = if model.travel > 0.0 { (record.travel - before) / model.travel } else { 0.01 };
    let cutoff = model.settings.cutoff_strain * share / 0.01;
    let power = record.power;
    Ok(json!({
        "step": step,
        "travel": record.travel,
        "tolerance": model.settings.tolerance,
        "cutoff": cutoff,
        "nearlyRigid": NEARLY_RIGID * cutoff,
        "iterates": iterates,
        "norms": norms,
        "power": {
            "external": power.external,
            "plastic": power.plastic,
            "elastic": power.elastic,
            "friction": power.friction,
            "contact": power.contact,
        },
    }))
}

/// The norms of that step in a run with one matrix throughout.
fn norms(name: &str, matrix: Iteration, model: &Model, step: usize, numbers: &mut Numbers) -> Value {
    let mut model = model.clone();
    model.settings.iteration = matrix;
    let mut watch = Watch::of(step, None);
    run(&model, &mut watch);
    json!({
        "matrix": name,
        "travel": watch.record.map(|record| record.travel),
        "velocity": numbers.put(watch.iterations.iter().map(|record| record.velocity_norm)),
        "residual": numbers.put(watch.iterations.iter().map(|record| record.residual_norm)),
        "contacts": numbers.put(watch.iterations.iter().map(|record| record.active_contacts as f64)),
    })
}
