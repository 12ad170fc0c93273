//! The flow approach: explicit predictor, implicit corrector.

use crate::model::Model;
use crate::record::{IterationRecord, Run, StepRecord};

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
pub fn run(_model: &Model, _observer: &mut dyn Observer) -> Run {
    todo!("lands with the solver")
}
