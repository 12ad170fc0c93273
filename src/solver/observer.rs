//! Callbacks of a run.

use super::iterate::Iterate;
use crate::model::{Model, Stage};
use crate::solver::solution::StepRecord;
use crate::solver::state::State;

/// Receives the progress of a run and may end it; the solver itself never prints.
pub trait Observer {
    /// Called after every accepted step.
    fn step(&mut self, _record: &StepRecord) {}
    /// Called at the start and after every accepted step.
    fn state(&mut self, _model: &Model, _state: &State) {}
    /// Called after every evaluation of the corrector.
    fn iteration(&mut self, _iterate: &Iterate<'_>) {}
    /// Called before each stage of a sequence.
    fn stage(&mut self, _stage: &Stage) {}
    /// Returns `true` to end the run with [`StopKind::Interrupted`](crate::solver::solution::StopKind::Interrupted) and all results so far; asked before
    /// every step and every iteration.
    fn wants_to_stop(&mut self) -> bool {
        false
    }
}

/// No-op observer.
impl Observer for () {}
