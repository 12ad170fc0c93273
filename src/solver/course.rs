//! Course of a run: steps from a state on, up to a reason to end.

use super::corrector::Corrector;
use super::no_equilibrium::{creeping, interrupted, no_equilibrium, squeezed, unheld};
use super::termination::Termination;
use super::time_step::{Budget, OVERSTRAINED, StepControl};
use super::*;
use crate::solver::solution::{Frame, ThroughThickness};
use std::mem::swap;

/// Least progress of a run between two checkpoints \[–\]: twice the usual largest step.
const CHECKPOINT_EVERY: f64 = 0.02;

#[derive(Clone)]
pub(super) struct Checkpoint {
    pub state: State,
    pub last: StepRecord,
    termination: Termination,
    effort: Effort,
}

#[derive(Clone)]
pub(super) struct Course {
    pub now: Checkpoint,
    /// The last two checkpoints: other settings are tried from the first.
    pub behind: [Checkpoint; 2],
    /// Results so far; the end and its frame are still missing.
    pub solution: StageSolution,
    /// True once there is nothing left to solve, and if that is for want of equilibrium.
    pub has_ended: bool,
    pub is_lost: bool,
}

impl Course {
    pub fn new(model: &Model, state: State) -> Self {
        let unsolved = StageSolution::unsolved(model.clone(), Stop::full_travel());
        let solution = StageSolution { start: Some(state.frame(model)), paths: state.paths(model), ..unsolved };
        let last = StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() };
        let now = Checkpoint { last, termination: Termination::new(model, &state), effort: Effort::default(), state };
        Self { behind: [now.clone(), now.clone()], now, solution, has_ended: false, is_lost: false }
    }

    /// Course back at its older checkpoint, without the results that lie beyond.
    pub fn back(&self) -> Self {
        let (mut run, now) = (self.solution.clone(), self.behind[0].clone());
        let (time, travel, steps) = (now.state.time, now.state.travel, now.last.step);
        run.stop = Stop::full_travel();
        run.steps.truncate(steps);
        run.tool_forces.truncate(steps);
        run.frames.retain(|frame| frame.time <= time);
        run.paths.truncate(steps + 1, now.state.instant());
        run.neck = run.neck.filter(|neck| neck.time <= time);
        run.left_at.iter_mut().for_each(|left| *left = left.filter(|left| *left <= travel));
        Self { now, behind: self.behind.clone(), solution: run, has_ended: false, is_lost: false }
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

    pub fn finished(self) -> StageSolution {
        let Self { now: Checkpoint { state, last, effort, .. }, solution: mut run, .. } = self;
        if last.step > 0 {
            run.frames.pop_if(|frame| frame.time >= state.time);
            run.frames.push(state.frame(&run.model));
        }
        StageSolution { effort, end: state, ..run }
    }

    /// Goes on with the settings of `model` up to a `progress` \[–\], or its end; returns the number of tries.
    pub fn go_on(&mut self, model: &Model, progress: f64, observer: &mut dyn Observer) -> usize {
        self.behind = [self.now.clone(), self.now.clone()];
        let mut context = RunContext::new(model, &self.now.state);
        let left = context.tools.iter_mut().zip(&self.solution.left_at);
        left.for_each(|(tool, left)| tool.released = tool.released.or(*left));
        let mut trial = Trial::new(&context, &self.now.state);
        let [mut evaluation, mut before] = [(); 2].map(|()| Evaluation::new(&context, &self.now.state));
        let closes_at = self.now.termination.closed.map(|(travel, ..)| model.time_at(travel));
        let mut control = StepControl::new(model, &self.now.state, closes_at);
        let mut budget = Budget::new(model);
        let mut rejected = 0;
        // Node with the largest residual of the last failed try.
        let mut worst = None;
        if let Some(stop) = unheld(&context).filter(|_| self.now.last.step == 0) {
            self.ends(stop);
            return 0;
        }

        loop {
            let done = model.progress(self.now.state.time);
            if done >= model.progress(self.behind[1].state.time) + CHECKPOINT_EVERY {
                self.behind.swap(0, 1);
                self.behind[1].clone_from(&self.now);
                observer.settled(&self.behind[0].state);
            }
            let dt = control.next(&self.now.state);
            self.has_ended = dt.is_none();
            let Some(dt) = dt.filter(|_| done < progress) else { break };
            if observer.wants_to_stop() {
                self.ends(interrupted(&self.now.state));
                break;
            }
            let run = &mut self.solution;
            let step = Step::new(&context, &self.now.state, dt, self.now.last.step + 1);
            if !budget.spend(done) {
                let necking = self.now.termination.necking(model, &self.now.state);
                let stop = necking.unwrap_or_else(|| creeping(&step, &before, worst, &run.steps, budget.tries));
                self.loses(stop, squeezed(&step, &before));
                break;
            }
            let corrector = Corrector { step: &step, trial: &mut trial, evaluation: &mut evaluation, observer };
            let (start, converged) = match corrector.solve(&mut rejected) {
                Ok(solved) => solved,
                Err(outcome) if outcome.interrupted => {
                    self.ends(interrupted(&self.now.state));
                    break;
                }
                Err(outcome) => {
                    self.now.effort.halved += 1;
                    worst = Some(evaluation.worst_node);
                    let necking = self.now.termination.necking(model, &self.now.state);
                    if necking.is_none() && control.reject() {
                        // No extrapolation of velocities that change abruptly.
                        self.now.state.end_velocity.clone_from(&self.now.state.velocity);
                        continue;
                    }
                    let stop = necking.unwrap_or_else(|| no_equilibrium(&step, &evaluation, &outcome, &run.steps));
                    self.loses(stop, squeezed(&step, &before));
                    break;
                }
            };
            if converged.strain_increment() > OVERSTRAINED * model.settings.strain_step && control.reject() {
                self.now.effort.overstrained += 1;
                rejected += 1;
                continue;
            }
            let (mut next, record) = advance(&before, &converged, rejected, &self.now.last);
            let seen = self.now.termination.after(model, &self.now.state, &next, &record);
            if control.search.look(step.state.time, dt, seen.excess) {
                self.now.effort.overstepped += 1;
                rejected += 1;
                continue;
            }
            (self.now.termination, rejected) = (seen, 0);
            run.neck = run.neck.or_else(|| self.now.termination.necked(model, &next));
            start.count(&mut self.now.effort);
            control.accept(&before, &converged, &record);
            if model.forming_limit.is_some() {
                run.paths.record(next.instant());
            }
            observer.step(&record);
            observer.state(model, &next);
            run.steps.push(record);
            run.tool_forces.push(converged.tool_forces());
            self.now.last = record;
            swap(&mut before, &mut evaluation);
            if let Some(tool) = context.release(&next) {
                next.release(tool);
                before.release(tool);
            }
            if control.at_frame(&next) {
                run.frames.push(Frame { through: ThroughThickness::default(), ..next.frame(model) });
            }
            self.now.state = next;
            if let Some(stop) = self.now.termination.stop(model, &self.now.state, &record) {
                self.ends(stop);
                break;
            }
        }
        self.now.effort.abandoned = rejected;
        if model.release.is_none() {
            self.solution.left_at = context.tools.iter().map(|tool| tool.released).collect();
        }
        budget.tries
    }
}
