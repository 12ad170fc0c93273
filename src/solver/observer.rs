//! Who looks on while a model is solved, and may end it.

use crate::element::Node;
use crate::geometry::Point;
use crate::material::flow::StressUpdate;
use crate::model::Model;
use crate::model::stage::Stage;
use crate::numerics::Grid;
use crate::solution::{IterationRecord, StepRecord};
use crate::state::State;
use nalgebra::Vector3;

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
    /// Whether the run is to end here; asked before every step and after every iteration. The run then keeps all that it has
    /// computed and ends with [`Stop::Interrupted`](crate::Stop::Interrupted).
    fn wants_to_stop(&mut self) -> bool {
        false
    }
    /// Whether [`iterate`](Self::iterate) is to be called; asked at the first iteration of every try of a step.
    fn wants_iterates(&self) -> bool {
        false
    }
    /// Before every iteration of a step, and when it has converged: the sheet as it is tried.
    fn iterate(&mut self, _iterate: &Iterate<'_>) {}
}

/// An observer that looks away.
impl Observer for () {}

/// The sheet and its tools as an iteration tries them at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Iterate<'a> {
    /// Number of the step that is tried, from 1.
    pub step: usize,
    /// Number of the iteration, from 0.
    pub iteration: usize,
    /// Time at the end of the step \[s\].
    pub time: f64,
    /// From the axis outward.
    pub nodes: &'a [Node],
    /// −r: force on every node along r and z \[N, or N/mm\] and moment \[N mm, or N\] that are not in balance; 0 where a
    /// freedom is held.
    pub imbalance: &'a [Vector3<f64>],
    /// Of each element \[mm\].
    pub thickness: &'a [f64],
    /// Elements by thickness points: stress \[MPa\] and equivalent strain added in the step \[–\]; of a membrane the first.
    pub updates: &'a Grid<StressUpdate>,
    /// Displacement of each tool (away from the axis, along z) from where it is drawn \[mm\].
    pub tools: &'a [Point],
}
