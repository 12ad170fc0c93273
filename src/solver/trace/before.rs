//! The run up to a step.

use super::asked::Asked;
use super::error::NoSuchStep;
use crate::model::{Model, Stage};
use crate::solver::solution::{IterationRecord, StepRecord, Stop};
use crate::solver::state::State;
use crate::solver::{Iterate, Observer, Start, solve};

/// What a step begins with, and how the run took it.
pub(super) struct Before {
    pub model: Model,
    pub state: State,
    pub record: StepRecord,
    /// Duration \[s\].
    pub dt: f64,
}

/// Runs stages up to the step that is asked for.
pub(super) fn before(stages: &[Stage], asked: &Asked, observer: &mut dyn Observer) -> Result<Before, NoSuchStep> {
    if asked.stage == 0 || asked.stage > stages.len() {
        return Err(NoSuchStep::Stage { asked: asked.stage, stages: stages.len() });
    }
    let mut run = UpTo { asked, stage: 0, begin: None, record: None, dt: None, observer };
    let mut solutions = solve(stages, &mut run);
    let UpTo { begin, record, dt, .. } = run;
    if let (Some((model, state)), Some(record), Some(dt)) = (begin, record, dt) {
        return Ok(Before { model, state, record, dt });
    }
    let reached = solutions.len();
    // One that was asked for has ended before a later one begins.
    solutions.truncate(asked.stage);
    let (steps, stop) = solutions.pop().map_or((0, Stop::FullTravel), |last| (last.steps.len(), last.stop));
    Err(match reached >= asked.stage {
        true => NoSuchStep::Step { asked: asked.step, steps, stop },
        false => NoSuchStep::NotReached { asked: asked.stage, reached, stop },
    })
}

/// Keeps the state before a step, and ends the run behind it.
struct UpTo<'a> {
    asked: &'a Asked,
    /// The stage that runs, from 1.
    stage: usize,
    begin: Option<(Model, State)>,
    record: Option<StepRecord>,
    dt: Option<f64>,
    observer: &'a mut dyn Observer,
}

impl Observer for UpTo<'_> {
    fn step(&mut self, record: &StepRecord) {
        if self.stage == self.asked.stage {
            self.record = Some(*record);
        }
        self.observer.step(record);
    }

    fn state(&mut self, model: &Model, state: &State) {
        if self.stage == self.asked.stage {
            let steps = self.record.map_or(0, |record| record.step);
            if steps + 1 == self.asked.step {
                self.begin = Some((model.clone(), state.clone()));
            }
            self.dt = (steps > 0 && steps == self.asked.step).then_some(state.last_step);
        }
        self.observer.state(model, state);
    }

    fn stage(&mut self, stage: &Stage) {
        self.stage += 1;
        self.observer.stage(stage);
    }

    fn attempt(&mut self, start: Start) {
        self.observer.attempt(start);
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.observer.iteration(record);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.dt.is_some() || self.stage > self.asked.stage || self.observer.wants_to_stop()
    }

    fn wants_iterates(&self) -> bool {
        self.observer.wants_iterates()
    }

    fn iterate(&mut self, iterate: &Iterate<'_>) {
        self.observer.iterate(iterate);
    }
}
