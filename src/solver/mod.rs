//! The flow approach: explicit predictor, implicit corrector, from the flat blank to the full travel.

mod assembly;
mod attempt;
mod balance;
mod blocks;
mod contacts;
mod corrector;
mod diagnosis;
mod heat;
mod line_search;
mod loads;
mod selection;
mod stages;
mod stepping;
mod stops;
mod voids;
pub(crate) mod warnings;

use crate::model::mesh;
use crate::model::stage::Stage;
use crate::model::{Edge, Model, Role};
use crate::solution::{Energy, IterationRecord, StageSolution, StepRecord, Stop};
use crate::state::State;
use assembly::Workspace;
use attempt::{Rung, Step, attempt};
use balance::Balance;
use corrector::Outcome;
use heat::HeatSolver;
use stepping::StepControl;
use stops::StopWatch;

pub use stages::{enter, run_stages};

/// Sees a run as it goes; the solver itself never prints.
pub trait Observer {
    /// After every accepted step.
    fn step(&mut self, _record: &StepRecord) {}
    /// At the start and after every accepted step: the sheet and its tools.
    fn state(&mut self, _model: &Model, _state: &State) {}
    /// After every iteration.
    fn iteration(&mut self, _record: &IterationRecord) {}
    /// Before each stage of a sequence.
    fn stage(&mut self, _stage: &Stage) {}
}

/// An observer that looks away.
impl Observer for () {}

/// Solves a model from the flat blank to its full travel, or as far as equilibrium is found.
pub fn run(model: &Model, observer: &mut dyn Observer) -> StageSolution {
    run_from(model, State::flat(model, mesh::nodes(model)), observer)
}

/// As [`run`], from a given state.
pub fn run_from(model: &Model, mut state: State, observer: &mut dyn Observer) -> StageSolution {
    let mut work = Workspace::new(model, &state);
    work.resume(model, &state);
    let mut balance = Balance::new(&work);
    let mut heat = HeatSolver::new(model, &work);
    let mut watch = StopWatch::new(model, &state);
    let mut control = StepControl::new(model, watch.closes_at(model));
    let mut run = StageSolution {
        start: Some(state.frame(model)),
        paths: state.paths(model),
        ..StageSolution::unsolved(model.clone())
    };
    let mut last = StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() };
    let mut before = state.thickness.clone();
    let strained: Vec<f64> = state.layers.iter().map(|point| point.strain).collect();
    let mut rejected = 0;

    observer.state(model, &state);
    while let Some(dt) = control.next(&state) {
        let step = Step { model, state: &state, dt, number: last.step + 1 };
        work.begin(&step);
        let (rung, outcome) = climb(&mut work, &step, &mut rejected, observer);
        if !outcome.converged {
            run.effort.halved += 1;
            if let Some(stop) = watch.necking(model, &state) {
                run.stop = stop;
                break;
            }
            if control.reject() {
                continue;
            }
            run.stop = stops::pressure_maximum(model, &run).unwrap_or_else(|| Stop::NoEquilibrium {
                travel: state.travel,
                time: state.time,
                step: dt,
                velocity_norm: outcome.velocity_norm,
                residual_norm: outcome.residual_norm,
                worst_s0: state.s0[work.worst_node],
                diagnosis: stops::diagnosis(model, &work, &state, &last),
            });
            break;
        }
        work.settle(model, &state);
        if control.is_overstrained(work.strain_increment()) && control.reject() {
            run.effort.overstrained += 1;
            rejected += 1;
            continue;
        }
        rung.count(&mut run.effort);
        work.measure_far();
        let approach = balance.approach(&work, dt);
        let figures = work.diagnosis(&step, balance.contacts());
        let done = balance.work_of_step(&work, &step);
        let mut record = record(&work, &step, &outcome, figures, done, rejected, &last);
        rejected = 0;
        control.accept(dt, outcome.iterations, &record, approach);
        before.copy_from_slice(&state.thickness);
        let since = state.time;
        accept(&work, model, &mut state, dt);
        if let Some(voids) = &model.material.voids {
            work.grow_voids(voids, model.material.anisotropy, &mut state, dt);
            (record.porosity, record.porous_s0) = state.largest_porosity(&work.layers);
        }
        if let Some(heat) = &mut heat {
            record.heat = last.heat.plus(heat.advance(&work, &balance.plastic, &mut state, dt));
        }
        (record.coldest, record.hottest) = state.temperatures();
        if model.forming_limit.is_some() {
            run.paths.push(state.instant());
        }
        observer.step(&record);
        observer.state(model, &state);
        run.steps.push(record);
        last = record;
        if let Some(contacts) = work.release(&state) {
            state.pressure[contacts.clone()].fill(0.0);
            state.shift[contacts.clone()].fill(0.0);
            balance.forget(contacts);
        }
        if control.at_frame(&state) {
            run.keep(state.frame(model));
        }
        if let Some(stop) = watch.look(model, &state, &record, &before, since) {
            run.stop = stop;
            break;
        }
    }
    if last.step > 0 && run.frames.last().is_none_or(|f| f.time < state.time) {
        run.keep(state.frame(model));
    }
    run.effort.abandoned = rejected;
    run.warnings = warnings::warnings(model, &work, &state, &run);
    run.warnings.extend(warnings::yielded_again(model, &strained, &state));
    run.end = state;
    run
}

/// Tries a step from rung to rung until one brings it to equilibrium; counts the tries that did not.
fn climb(work: &mut Workspace, step: &Step, rejected: &mut usize, observer: &mut dyn Observer) -> (Rung, Outcome) {
    let mut last = None;
    // Nothing has moved yet: the first step has no velocities to start from.
    for rung in Rung::LADDER.into_iter().skip(usize::from(step.number == 1)) {
        let outcome = attempt(work, step, rung, observer);
        last = Some((rung, outcome));
        if outcome.converged {
            break;
        }
        *rejected += 1;
    }
    last.expect("the ladder has rungs")
}

/// Moves the state to the end of a converged step.
fn accept(work: &Workspace, model: &Model, state: &mut State, dt: f64) {
    for (i, response) in work.responses.iter().enumerate() {
        let point = &mut state.layers[i];
        point.strain += response.increment;
        point.stress = response.stress;
        match work.twins.get(i) {
            None => point.carried = work.iterates[i].carried,
            Some(twin) => (point.carried, point.back) = (response.stress, twin.back),
        }
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
    state.shift.copy_from_slice(&work.shift);
    state.gas.copy_from_slice(&work.gas_pressure);
    state.tools.copy_from_slice(&work.tool_position);
    state.aside.copy_from_slice(&work.tool_aside);
    state.nodes.copy_from_slice(&work.nodes);
    state.thickness.copy_from_slice(&work.thickness);
    state.bends.copy_from_slice(&work.selection.bends);
    for (total, increment) in state.membrane.iter_mut().zip(&work.membrane_increment) {
        total[0] += increment[0];
        total[1] += increment[1];
    }
    state.time += dt;
    state.travel = model.travel_at(state.time);
}

/// Writes down what happened in a converged step.
fn record(
    work: &Workspace,
    step: &Step,
    outcome: &Outcome,
    figures: StepRecord,
    done: Energy,
    rejected: usize,
    last: &StepRecord,
) -> StepRecord {
    let Step { model, state, dt, number } = *step;
    let force_of = |role: Role| model.tools.iter().position(|t| t.role == role).map_or(0.0, |j| work.tool_force[j]);
    let thinnest = (0..work.thickness.len()).min_by(|&a, &b| work.thickness[a].total_cmp(&work.thickness[b]));
    let thinnest = thinnest.expect("a blank has elements");
    let edge_node = work.nodes.len() - 1;
    StepRecord {
        step: number,
        time: state.time + dt,
        travel: model.travel_at(state.time + dt),
        punch_force: force_of(Role::Punch),
        holder_force: force_of(Role::Holder),
        edge_force: if model.blank.edge == Edge::Free { 0.0 } else { work.edge_reaction.x },
        draw_in: model.blank.length - work.nodes[edge_node][0],
        thinnest: work.thickness[thinnest],
        thinnest_s0: 0.5 * (state.s0[thinnest] + state.s0[thinnest + 1]),
        iterations: outcome.iterations,
        rejected,
        velocity_norm: outcome.velocity_norm,
        residual_norm: outcome.residual_norm,
        power: done.scaled(1.0 / dt),
        work: last.work.plus(done),
        ..figures
    }
}
