//! Course of a run: steps from a state on, up to a reason to end.

use super::evaluation::Evaluation;
use super::no_equilibrium::{creeping, interrupted, no_equilibrium, squeezed, unheld};
use super::run_context::RunContext;
use super::step::Step;
use super::termination::Termination;
use super::time_step::{Budget, StepControl};
use super::trial::Trial;
use super::{Observer, advance, retry};
use crate::model::Model;
use crate::solver::solution::{StageSolution, StepRecord, Stop, StopKind};
use crate::solver::state::State;
use std::mem::swap;

/// Progress of a run between two courses that are kept to go back to \[–\]: twice the usual largest step.
const KEPT_EVERY: f64 = 0.02;

/// State that a run has come to, its rules of termination, and its results so far.
#[derive(Clone)]
pub(super) struct Course {
    pub state: State,
    last: StepRecord,
    termination: Termination,
    /// Results so far; the end and the last frame are still missing.
    pub solution: StageSolution,
    /// True once there is nothing left to solve, and if that is for want of equilibrium.
    pub has_ended: bool,
    pub is_lost: bool,
    /// Tries so far.
    pub tries: usize,
}

impl Course {
    pub fn new(model: &Model, state: State) -> Self {
        let full = Stop::new(StopKind::FullTravel, "full travel reached");
        Self {
            last: StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() },
            termination: Termination::new(model, &state),
            solution: StageSolution {
                start: Some(state.frame(model)),
                paths: state.paths(model),
                ..StageSolution::unsolved(model.clone(), full)
            },
            has_ended: false,
            is_lost: false,
            tries: 0,
            state,
        }
    }

    pub fn ends(&mut self, stop: Stop) {
        (self.solution.stop, self.has_ended, self.is_lost) = (stop, true, false);
    }

    /// Ends where no step succeeds, unless a rule or the sheet names the reason; `closed` is that of tools that squeeze it.
    fn loses(&mut self, stop: Stop, closed: Option<Stop>) {
        let is_lost = matches!(stop.kind, StopKind::NoEquilibrium | StopKind::Creeping);
        self.ends(closed.filter(|_| is_lost).unwrap_or(stop));
        self.is_lost = is_lost;
    }

    /// Results with the last state and its frame.
    pub fn finished(self) -> StageSolution {
        let Self { state, last, solution: mut run, .. } = self;
        if last.step > 0 && run.frames.last().is_none_or(|f| f.time < state.time) {
            run.keep(state.frame(&run.model));
        }
        run.end = state;
        run
    }

    /// Goes on with the settings of `model` up to a `progress` \[–\], or its end; keeps in `behind` the last two courses that lie
    /// [`KEPT_EVERY`] apart.
    pub fn go_on(&mut self, model: &Model, progress: f64, behind: &mut [Self; 2], observer: &mut dyn Observer) {
        let mut context = RunContext::new(model, &self.state);
        let left = context.tools.iter_mut().zip(&self.solution.left_at);
        left.for_each(|(tool, left)| tool.released = tool.released.or(*left));
        let mut trial = Trial::new(&context, &self.state);
        let [mut evaluation, mut before] = [(); 2].map(|()| Evaluation::new(&context, &self.state));
        let mut control = StepControl::new(model, &self.state, self.termination.closes_at(model));
        let mut budget = Budget::new(model);
        let mut rejected = 0;
        // Node with the largest residual of the last failed try.
        let mut worst = None;
        if let Some(stop) = unheld(&context).filter(|_| self.last.step == 0) {
            self.ends(stop);
            return;
        }

        loop {
            let done = model.progress(self.state.time);
            if done >= model.progress(behind[1].state.time) + KEPT_EVERY {
                behind.swap(0, 1);
                behind[1].clone_from(self);
            }
            let dt = control.next(&self.state);
            self.has_ended = dt.is_none();
            let Some(dt) = dt.filter(|_| done < progress) else { break };
            if observer.wants_to_stop() {
                self.ends(interrupted(&self.state));
                break;
            }
            let run = &mut self.solution;
            let step = Step::new(&context, &self.state, dt, self.last.step + 1);
            if !budget.spend(done) {
                let necking = self.termination.necking(model, &self.state);
                let stop = necking.unwrap_or_else(|| creeping(&step, &before, worst, &run.steps, budget.tries));
                self.loses(stop, squeezed(&step, &before));
                break;
            }
            let (start, converged) = match retry::solve(&step, &mut trial, &mut evaluation, &mut rejected, observer) {
                Ok(solved) => solved,
                Err(outcome) if outcome.interrupted => {
                    self.ends(interrupted(&self.state));
                    break;
                }
                Err(outcome) => {
                    run.effort.halved += 1;
                    worst = Some(evaluation.worst_node);
                    let necking = self.termination.necking(model, &self.state);
                    if necking.is_none() && control.reject() {
                        // No extrapolation of velocities that change abruptly.
                        self.state.end_velocity.clone_from(&self.state.velocity);
                        continue;
                    }
                    let stop = necking.unwrap_or_else(|| no_equilibrium(&step, &evaluation, &outcome, &run.steps));
                    self.loses(stop, squeezed(&step, &before));
                    break;
                }
            };
            if control.is_overstrained(converged.strain_increment()) && control.reject() {
                run.effort.overstrained += 1;
                rejected += 1;
                continue;
            }
            let (mut next, record) = advance(&before, &converged, rejected, &self.last);
            let seen = self.termination.after(model, &self.state, &next, &record);
            if control.oversteps(&step, seen.excess) {
                run.effort.overstepped += 1;
                rejected += 1;
                continue;
            }
            (self.termination, rejected) = (seen, 0);
            run.neck = run.neck.or_else(|| self.termination.necked(model, &next));
            start.count(&mut run.effort);
            control.accept(&before, &converged, &record);
            if model.forming_limit.is_some() {
                run.paths.record(next.instant());
            }
            observer.step(&record);
            observer.state(model, &next);
            run.steps.push(record);
            self.last = record;
            swap(&mut before, &mut evaluation);
            if let Some(tool) = context.release(&next) {
                next.release(tool);
                before.release(tool);
            }
            if control.at_frame(&next) {
                run.keep(next.frame(model));
            }
            self.state = next;
            if let Some(stop) = self.termination.stop(model, &self.state, &record) {
                self.ends(stop);
                break;
            }
        }
        self.tries += budget.tries;
        self.solution.effort.abandoned = rejected;
        if model.release.is_none() {
            self.solution.left_at = context.tools.iter().map(|tool| tool.released).collect();
        }
    }
}
