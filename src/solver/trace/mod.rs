//! One step of a run repeated from the same state with any of the corrector's matrices, iteration by iteration.

mod rate;

pub use rate::ConvergenceRate;

use crate::model::{Iteration, Model, Settings, Stage};
use crate::solver::solution::{IterationRecord, StageSolution, StepRecord, StopKind};
use crate::solver::state::State;
use crate::solver::{Iterate, IterateSnapshot, Observer, solve, try_step};

/// Step to trace and matrices to iterate with.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceRequest {
    /// Number of the stage, from 1.
    pub stage: usize,
    /// Number of the step in it, from 1.
    pub step: usize,
    /// Iteration matrices, each from the same state; empty: the case's own.
    pub matrices: Vec<Iteration>,
    /// Tolerance of the norm in this step alone \[–\]; `None`: the case's own.
    pub tolerance: Option<f64>,
}

/// Iterations of one step with each requested matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Number of the stage, from 1.
    pub stage: usize,
    /// Accepted norm of the step \[–\].
    pub tolerance: f64,
    /// State before the step.
    pub before: State,
    /// Record of the step in the run.
    pub record: StepRecord,
    /// Duration of the step \[s\].
    pub dt: f64,
    /// One history per matrix, in the order of the request.
    pub histories: Vec<IterationHistory>,
}

/// Iterations of one step with one matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct IterationHistory {
    /// Matrix of the settings; a secant start uses the secant matrix first.
    pub matrix: Iteration,
    /// Iterations of all tries; a pass of the corrector begins at iteration 0.
    pub rows: Vec<IterationRecord>,
    /// Sheet and forces of every row.
    pub iterates: Vec<IterateSnapshot>,
    /// State after the step; `None` without equilibrium.
    pub end: Option<State>,
}

impl IterationHistory {
    /// Iterations of the last pass of the corrector.
    pub fn last_pass(&self) -> &[IterationRecord] {
        let begin = self.rows.iter().rposition(|row| row.iteration == 0);
        begin.map_or(&[], |begin| &self.rows[begin..])
    }

    /// Number of iterations of all tries.
    pub fn count(&self) -> usize {
        self.rows.iter().filter(|row| row.iteration > 0).count()
    }

    /// Rate of convergence of the last pass; `None` when it is too short.
    pub fn rate(&self) -> Option<ConvergenceRate> {
        let whole = |row: &IterationRecord| (row.share >= 1.0).then_some(row.velocity_norm);
        ConvergenceRate::new(&self.last_pass().iter().map(whole).collect::<Vec<_>>())
    }
}

/// Reason why a step cannot be traced.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSuchStep {
    /// Missing stage or step.
    #[error("{0}")]
    Missing(String),
    /// The observer ended the run before the step.
    #[error("interrupted before the step")]
    Interrupted,
}

/// Runs stages up to a step and repeats that step with each requested matrix; `observer` sees the run and may end it.
///
/// # Errors
/// When the run has no such step.
pub fn trace(stages: &[Stage], request: &TraceRequest, observer: &mut dyn Observer) -> Result<Trace, NoSuchStep> {
    let &TraceRequest { stage, step, .. } = request;
    if stage == 0 || stage > stages.len() {
        let have = stages.len();
        return Err(NoSuchStep::Missing(format!("there is no stage {stage}: the case has {have}, counted from 1")));
    }
    let mut replay = Replay { request, stage: 0, begin: None, record: None, dt: None, observer };
    let solutions = solve(stages, &mut replay);
    let Replay { begin: Some((model, before)), record: Some(record), dt: Some(dt), .. } = replay else {
        let interrupted = |run: &StageSolution| run.stop.kind == StopKind::Interrupted;
        return Err(match solutions.get(stage - 1) {
            _ if solutions.iter().take(stage).any(interrupted) => NoSuchStep::Interrupted,
            Some(StageSolution { steps, .. }) => {
                NoSuchStep::Missing(format!("there is no step {step}: the run has {}, counted from 1", steps.len()))
            }
            None => {
                NoSuchStep::Missing(format!("stage {stage} is not reached: the run ends in stage {}", solutions.len()))
            }
        });
    };
    let tolerance = request.tolerance.unwrap_or(model.settings.tolerance);
    let own = [model.settings.iteration];
    let matrices = if request.matrices.is_empty() { &own[..] } else { &request.matrices };
    let repeat = |&matrix: &Iteration| {
        let mut model = model.clone();
        model.settings = Settings { iteration: matrix, tolerance, ..model.settings };
        let mut history = IterationHistory { matrix, rows: vec![], iterates: vec![], end: None };
        history.end = try_step(&model, &before, dt, step, &mut history);
        history
    };
    let histories = matrices.iter().map(repeat).collect();
    Ok(Trace { stage, tolerance, before, record, dt, histories })
}

/// Keeps the state before the requested step and ends the run after it.
struct Replay<'a> {
    request: &'a TraceRequest,
    stage: usize,
    begin: Option<(Model, State)>,
    record: Option<StepRecord>,
    dt: Option<f64>,
    observer: &'a mut dyn Observer,
}

impl Observer for Replay<'_> {
    fn step(&mut self, record: &StepRecord) {
        self.record = (self.stage == self.request.stage).then_some(*record);
        self.observer.step(record);
    }

    fn state(&mut self, model: &Model, state: &State) {
        if self.stage == self.request.stage {
            let steps = self.record.map_or(0, |record| record.step);
            if steps + 1 == self.request.step {
                self.begin = Some((model.clone(), state.clone()));
            }
            self.dt = (steps > 0 && steps == self.request.step).then_some(state.last_step);
        }
        self.observer.state(model, state);
    }

    fn stage(&mut self, stage: &Stage) {
        self.stage += 1;
        self.observer.stage(stage);
    }

    fn iteration(&mut self, iterate: &Iterate<'_>) {
        self.observer.iteration(iterate);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.dt.is_some() || self.stage > self.request.stage || self.observer.wants_to_stop()
    }
}

impl Observer for IterationHistory {
    fn iteration(&mut self, iterate: &Iterate<'_>) {
        self.rows.push(iterate.record());
        self.iterates.push(iterate.snapshot());
    }
}
