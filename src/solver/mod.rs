//! The flow approach: explicit predictor, implicit corrector, from the flat blank to the full travel.

mod assembly;
mod balance;
pub mod block_tridiagonal;
mod contacts;
mod corrector;
mod stepping;

use crate::mesh;
use crate::model::{Edge, Model, Role};
use crate::record::{IterationRecord, Run, StepRecord, Stop};
use crate::state::{LayerPoint, State};
use assembly::Workspace;
use balance::Balance;
use corrector::{Outcome, correct};
use stepping::StepControl;

/// Sees a run as it goes; the solver itself never prints.
pub trait Observer {
    /// After every accepted step.
    fn step(&mut self, _record: &StepRecord) {}
    /// After every iteration.
    fn iteration(&mut self, _record: &IterationRecord) {}
}

/// An observer that looks away.
impl Observer for () {}

/// Solves a model from the flat blank to its full travel, or as far as equilibrium is found.
pub fn run(model: &Model, observer: &mut dyn Observer) -> Run {
    run_from(model, State::flat(model, mesh::nodes(model)), observer).0
}

/// As [`run`], from a given state; also returns the last state.
pub fn run_from(model: &Model, mut state: State, observer: &mut dyn Observer) -> (Run, State) {
    let mut work = Workspace::new(model, &state);
    let mut balance = Balance::new(&work);
    let mut control = StepControl::new(model);
    let mut run =
        Run { history: Vec::new(), frames: Vec::new(), stop: Stop::FullTravel, abandoned: 0, warnings: Vec::new() };
    let mut last = StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() };
    let mut rejected = 0;

    while let Some(dt) = control.next(&state) {
        work.begin(model, &state);
        let step = last.step + 1;
        let mut outcome = None;
        for rung in LADDER.into_iter().skip(usize::from(step == 1)) {
            let tried = attempt(&mut work, model, &state, dt, step, rung, observer);
            outcome = Some(tried);
            if tried.converged {
                break;
            }
            rejected += 1;
        }
        let outcome = outcome.expect("the ladder has rungs");
        if !outcome.converged {
            if control.reject(dt) {
                continue;
            }
            run.stop = Stop::NoEquilibrium {
                travel: state.travel,
                step: dt * model.speed,
                velocity_norm: outcome.velocity_norm,
                residual_norm: outcome.residual_norm,
                worst_s0: state.s0[work.worst_node],
            };
            break;
        }
        control.accept(dt, outcome.iterations);
        work.measure_far();
        let record = StepRecord { rejected, ..accept(&work, &mut balance, model, &mut state, dt, &outcome, &last) };
        rejected = 0;
        observer.step(&record);
        run.history.push(record);
        last = record;
        if let Some(contacts) = work.release(&state) {
            state.pressure[contacts.clone()].fill(0.0);
            balance.forget(contacts);
        }
        if control.at_frame(&state) {
            run.frames.push(state.frame(model));
        }
    }
    if !run.stop.is_complete() && last.step > 0 && run.frames.last().is_none_or(|f| f.travel < state.travel) {
        run.frames.push(state.frame(model));
    }
    run.abandoned = rejected;
    run.warnings = warnings(model, &work, &state, &run);
    (run, state)
}

/// Where the corrector starts from; what fails on one rung is tried on the next before the step is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rung {
    /// The velocities of the last step.
    Predictor,
    /// No motion but the tools'.
    Rest,
    /// The answer with a cut-off that is [`SOFTENING`] times as large, itself started from rest.
    Softened,
}

const LADDER: [Rung; 3] = [Rung::Predictor, Rung::Rest, Rung::Softened];

/// Factor on the cut-off for a softened start.
const SOFTENING: f64 = 30.0;

/// One try of a step.
fn attempt(
    work: &mut Workspace,
    model: &Model,
    state: &State,
    dt: f64,
    step: usize,
    rung: Rung,
    observer: &mut dyn Observer,
) -> Outcome {
    work.predict(model, state, dt, rung != Rung::Predictor);
    let mut spent = 0;
    if rung == Rung::Softened {
        work.softening = SOFTENING;
        let soft = correct(work, model, state, dt, step, observer);
        work.softening = 1.0;
        if !soft.converged {
            return soft;
        }
        spent = soft.iterations;
    }
    let outcome = correct(work, model, state, dt, step, observer);
    Outcome { iterations: outcome.iterations + spent, ..outcome }
}

/// Moves the state to the end of a converged step and writes down what happened.
fn accept(
    work: &Workspace,
    balance: &mut Balance,
    model: &Model,
    state: &mut State,
    dt: f64,
    outcome: &Outcome,
    last: &StepRecord,
) -> StepRecord {
    let done = balance.work_of_step(work, model, state, dt);
    for (i, response) in work.responses.iter().enumerate() {
        let point = &mut state.layers[i];
        *point = LayerPoint {
            strain: point.strain + response.increment,
            stress: response.stress,
            carried: work.iterates[i].carried,
        };
    }
    for (velocity, u) in state.velocity.iter_mut().zip(&work.moves) {
        *velocity = u.map(|u| u / dt);
    }
    for (j, position) in work.tool_position.iter().enumerate() {
        state.tool_velocity[j] = (position - state.tools[j]) / dt;
    }
    for (pressure, now) in state.pressure.iter_mut().zip(work.pressures()) {
        *pressure = now;
    }
    state.tools.copy_from_slice(&work.tool_position);
    state.nodes.copy_from_slice(&work.nodes);
    state.thickness.copy_from_slice(&work.thickness);
    for (total, increment) in state.membrane.iter_mut().zip(&work.membrane_increment) {
        total[0] += increment[0];
        total[1] += increment[1];
    }
    state.time += dt;
    state.travel += dt * model.speed;

    let force_of = |role: Role| model.tools.iter().position(|t| t.role == role).map_or(0.0, |j| work.tool_force[j]);
    let thinnest = (0..state.thickness.len()).min_by(|&a, &b| state.thickness[a].total_cmp(&state.thickness[b]));
    let thinnest = thinnest.expect("a blank has elements");
    let edge_node = state.nodes.len() - 1;
    StepRecord {
        step: last.step + 1,
        time: state.time,
        travel: state.travel,
        punch_force: force_of(Role::Punch),
        holder_force: force_of(Role::Holder),
        edge_force: if model.blank.edge == Edge::Free { 0.0 } else { work.edge_reaction.x },
        draw_in: model.blank.length - state.nodes[edge_node][0],
        thinnest: state.thickness[thinnest],
        thinnest_s0: 0.5 * (state.s0[thinnest] + state.s0[thinnest + 1]),
        penetration: work.penetration,
        iterations: outcome.iterations,
        rejected: 0,
        velocity_norm: outcome.velocity_norm,
        residual_norm: outcome.residual_norm,
        power: done.scaled(1.0 / dt),
        work: last.work.plus(done),
    }
}

/// Power balance that a user should be able to rely on \[–\].
const LARGEST_IMBALANCE: f64 = 0.01;
/// Penetration that would show in the result, over the thickness \[–\].
const LARGEST_PENETRATION: f64 = 0.05;
/// Plastic power in cut-off zones that puts stresses in doubt \[–\].
const LARGEST_CUT_OFF: f64 = 0.05;

/// Thickness over the initial one that no sheet metal is drawn to in one piece \[–\].
const TORN: f64 = 0.5;
/// Thickness strain of the thinnest element over that of its surroundings from which thinning counts as localised \[–\].
const LOCALISED: f64 = 1.6;
/// Surroundings: this many thicknesses away, on either side.
const NEAR: f64 = 3.0;
const AWAY: f64 = 8.0;

/// Whether the thinnest place is a neck: much thinner than the sheet a few thicknesses away.
fn localised(model: &Model, state: &State) -> Option<String> {
    let t0 = model.blank.thickness;
    let strain = |e: usize| (state.thickness[e] / t0).ln();
    let middle = |e: usize| 0.5 * (state.s0[e] + state.s0[e + 1]);
    let elements = 0..state.thickness.len();
    let neck = elements.clone().min_by(|&a, &b| strain(a).total_cmp(&strain(b)))?;
    let around = elements.filter(|&e| (NEAR * t0..AWAY * t0).contains(&(middle(e) - middle(neck)).abs()));
    let (sum, count) = around.fold((0.0, 0), |(sum, count), e| (sum + strain(e), count + 1));
    let share = state.thickness[neck] / t0;
    let neck_like = count > 0 && share < 0.8 && strain(neck) < LOCALISED * (sum / f64::from(count)).min(0.0);
    let place = middle(neck);
    if neck_like {
        Some(format!(
            "thinning has localised at s0 = {place:.1} mm, down to {:.0} % of the thickness: the sheet tears there, and what \
             is computed after that depends on the mesh",
            100.0 * share
        ))
    } else {
        (share < TORN).then(|| {
            format!(
                "the sheet is down to {:.0} % of its thickness at s0 = {place:.1} mm: it has torn before",
                100.0 * share
            )
        })
    }
}

/// What a user should know before trusting the result.
fn warnings(model: &Model, work: &Workspace, state: &State, run: &Run) -> Vec<String> {
    let mut warnings = Vec::new();
    let Some(last) = run.history.last() else { return warnings };
    warnings.extend(localised(model, state));
    let imbalance = last.work.imbalance();
    if imbalance.abs() > LARGEST_IMBALANCE {
        warnings.push(format!(
            "the power balance misses {:.2} % of the external work: take smaller steps (solver.max_step)",
            100.0 * imbalance
        ));
    }
    let deepest = run.history.iter().map(|r| r.penetration).fold(0.0, f64::max);
    if deepest > LARGEST_PENETRATION {
        warnings.push(format!(
            "a tool penetrates the sheet by {:.1} % of its thickness: raise solver.contact_stiffness",
            100.0 * deepest
        ));
    }
    if last.work.cutoff > LARGEST_CUT_OFF * last.work.plastic {
        warnings.push(format!(
            "{:.1} % of the plastic work is done where the strain rate is cut off: stresses there are not the true ones",
            100.0 * last.work.cutoff / last.work.plastic
        ));
    }
    let strain = state.layers.iter().map(|p| p.strain).fold(0.0, f64::max);
    if let Some(end) = model.material.hardening.valid_up_to().filter(|&end| strain > end) {
        warnings.push(format!(
            "the hardening table ends at a strain of {end:.3}; the run reaches {strain:.3} on its extrapolation"
        ));
    }
    for (tool, active) in model.tools.iter().zip(&work.tools) {
        if let Some(travel) = active.released {
            warnings.push(format!(
                "the sheet left the {} at {travel:.2} mm of travel; it is lifted off from there on",
                tool.role.name()
            ));
        }
    }
    warnings
}
