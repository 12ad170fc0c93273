//! Solver of the flow approach: explicit predictor, implicit corrector.

mod augmented_lagrangian;
mod closing;
mod converged;
mod corrector;
mod damage;
mod end_search;
mod energy_balance;
mod equilibrium;
mod evaluation;
mod heat;
mod ironing;
mod line_search;
mod no_equilibrium;
mod observer;
mod restraints;
mod retry;
mod run_context;
mod selective_bending;
pub mod solution;
mod stages;
pub mod state;
mod step;
mod step_record;
mod tearing_index;
mod termination;
mod terms;
mod time_step;
pub mod trace;
mod trial;

use crate::model::Model;
use crate::solver::solution::{Heat, StageSolution, StepRecord, Stop, StopKind};
use crate::solver::state::State;
use converged::Converged;
use evaluation::Evaluation;
use no_equilibrium::{creeping, interrupted, no_equilibrium};
use run_context::RunContext;
use std::mem::swap;
use step::Step;
use termination::Termination;
use time_step::{Budget, StepControl};
use trial::Trial;

pub use closing::closing_way;
pub use observer::{Iterate, IterateContact, IterateSnapshot, Observer};
pub use retry::{Start, try_step};
pub use stages::{enter, run, solve};

/// Solves a model from a given state.
pub fn run_from(model: &Model, mut state: State, observer: &mut dyn Observer) -> StageSolution {
    let mut context = RunContext::new(model, &state);
    let mut trial = Trial::new(&context, &state);
    let (mut evaluation, mut before) = (Evaluation::new(&context, &state), Evaluation::new(&context, &state));
    let mut termination = Termination::new(model, &state);
    let mut control = StepControl::new(model, termination.closes_at(model));
    let mut run = StageSolution {
        start: Some(state.frame(model)),
        paths: state.paths(model),
        ..StageSolution::unsolved(model.clone(), Stop::new(StopKind::FullTravel, "full travel reached"))
    };
    let mut last = StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() };
    let mut budget = Budget::new(model);
    let mut rejected = 0;
    // Node with the largest residual of the last failed try.
    let mut worst = None;

    observer.state(model, &state);
    while let Some(dt) = control.next(&state) {
        if observer.wants_to_stop() {
            run.stop = interrupted(&state);
            break;
        }
        let step = Step::new(&context, &state, dt, last.step + 1);
        if !budget.spend(model.progress(state.time)) {
            let necking = termination.necking(model, &state);
            run.stop = necking.unwrap_or_else(|| creeping(&step, &before, worst, &run.steps, budget.tries));
            break;
        }
        let (start, converged) = match retry::solve(&step, &mut trial, &mut evaluation, &mut rejected, observer) {
            Ok(solved) => solved,
            Err(outcome) if outcome.interrupted => {
                run.stop = interrupted(&state);
                break;
            }
            Err(outcome) => {
                run.effort.halved += 1;
                worst = Some(evaluation.worst_node);
                let necking = termination.necking(model, &state);
                if necking.is_none() && control.reject() {
                    // No extrapolation of velocities that change abruptly.
                    state.end_velocity.clone_from(&state.velocity);
                    continue;
                }
                run.stop = necking.unwrap_or_else(|| no_equilibrium(&step, &evaluation, &outcome, &run.steps));
                break;
            }
        };
        if control.is_overstrained(converged.strain_increment()) && control.reject() {
            run.effort.overstrained += 1;
            rejected += 1;
            continue;
        }
        let (mut next, record) = advance(&before, &converged, rejected, &last);
        let seen = termination.after(model, &state, &next, &record);
        if control.oversteps(&step, seen.excess) {
            run.effort.overstepped += 1;
            rejected += 1;
            continue;
        }
        (termination, rejected) = (seen, 0);
        run.neck = run.neck.or_else(|| termination.necked(model, &next));
        start.count(&mut run.effort);
        control.accept(&before, &converged, &record);
        if model.forming_limit.is_some() {
            run.paths.record(next.instant());
        }
        observer.step(&record);
        observer.state(model, &next);
        run.steps.push(record);
        last = record;
        swap(&mut before, &mut evaluation);
        if let Some(tool) = context.release(&next) {
            next.release(tool);
            before.release(tool);
        }
        if control.at_frame(&next) {
            run.keep(next.frame(model));
        }
        state = next;
        if let Some(stop) = termination.stop(model, &state, &record) {
            run.stop = stop;
            break;
        }
    }
    if last.step > 0 && run.frames.last().is_none_or(|f| f.time < state.time) {
        run.keep(state.frame(model));
    }
    run.effort.abandoned = rejected;
    if model.release.is_none() {
        run.left_at = context.tools.iter().map(|tool| tool.released).collect();
    }
    run.end = state;
    run
}

/// State after a converged step, with porosity and temperatures, and its record.
fn advance(before: &Evaluation, converged: &Converged, rejected: usize, last: &StepRecord) -> (State, StepRecord) {
    let Converged { step, .. } = converged;
    let times = step.model.extent().times();
    let (work, plastic) = energy_balance::work(before, converged);
    let mut next = converged.advanced();
    let mut record = step_record::record(converged, before, &next, rejected);
    ironing::add(converged, &mut next, &mut record);
    tearing_index::add(converged, &mut next, &mut record);
    if step.model.material.gtn.is_some() {
        (record.porosity, record.porous_s0) = next.largest_porosity(&step.context.rule);
    }
    if step.model.material.fracture.is_some() {
        (record.damage, record.damage_s0) = next.largest_damage(&step.context.rule);
    }
    let heat = heat::advance(converged, &plastic, &mut next).unwrap_or_default();
    record.power = work.scaled(1.0 / step.dt).scaled(times);
    record.work = last.work.combined(work.scaled(times), |before, added| before + added);
    record.heat = Heat {
        plastic: last.heat.plastic + times * heat.plastic,
        tools: last.heat.tools + times * heat.tools,
        stored: last.heat.stored + times * heat.stored,
    };
    (record.coldest, record.hottest) = next.temperatures();
    (next, record)
}
