//! One step of a run repeated from the same state with any of the corrector's matrices, iteration by iteration.
//!
//! ```text
//! e_k = |δȧ_k|/|ȧ|                   the increment of iteration k stands for the error that it removed
//! e_k+1 = C e_k^p                    p = ln(e_k+1/e_k)/ln(e_k/e_k−1): 1 linear, 2 quadratic
//! ```

use super::*;

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

/// Runs stages up to a step and repeats it with each matrix; `observer` may end the run. Fails without such a step.
pub fn trace(stages: &[Stage], request: &TraceRequest, observer: &mut dyn Observer) -> Result<Trace, NoSuchStep> {
    let &TraceRequest { stage, step, .. } = request;
    let missing = |last: Option<&StageSolution>, text: String| match last {
        Some(last) if last.stop.kind == StopKind::Interrupted => Err(NoSuchStep::Interrupted),
        _ => Err(NoSuchStep::Missing(text)),
    };
    if stage == 0 || stage > stages.len() {
        return missing(None, format!("there is no stage {stage}: the case has {}, counted from 1", stages.len()));
    }
    let mut replay = Replay { request, stage: 0, steps: 0, begin: None, dt: 0.0, is_settled: false, observer };
    let solutions = solve(stages, &mut replay);
    let Replay { begin, dt, .. } = replay;
    let Some(run) = solutions.get(stage - 1) else {
        let what = format!("stage {stage} is not reached: the run ends in stage {}", solutions.len());
        return missing(solutions.last(), what);
    };
    let record = step.checked_sub(1).and_then(|step| run.steps.get(step));
    let (Some((model, before)), Some(record)) = (begin, record) else {
        return missing(Some(run), format!("there is no step {step}: the run has {}, counted from 1", run.steps.len()));
    };
    let tolerance = request.tolerance.unwrap_or(model.settings.tolerance);
    let matrices = if request.matrices.is_empty() { &[model.settings.iteration][..] } else { &request.matrices };
    let repeat = |&matrix: &Iteration| {
        let mut model = model.clone();
        model.settings = Settings { iteration: matrix, tolerance, ..model.settings };
        let mut history = IterationHistory { matrix, rows: vec![], iterates: vec![], end: None };
        history.end = try_step(&model, &before, dt, step, &mut history);
        history
    };
    Ok(Trace { histories: matrices.iter().map(repeat).collect(), stage, tolerance, before, record: *record, dt })
}

struct Replay<'a> {
    request: &'a TraceRequest,
    stage: usize,
    steps: usize,
    begin: Option<(Model, State)>,
    /// Duration of the requested step \[s\].
    dt: f64,
    is_settled: bool,
    observer: &'a mut dyn Observer,
}

impl Replay<'_> {
    fn take(&mut self, model: &Model, state: &State) {
        if self.stage == self.request.stage && self.steps + 1 == self.request.step {
            (self.begin, self.dt) = (Some((model.clone(), state.clone())), 0.0);
        } else if self.stage == self.request.stage && self.steps == self.request.step {
            self.dt = state.last_step;
        }
    }
}

impl Observer for Replay<'_> {
    fn step(&mut self, record: &StepRecord) {
        self.steps = record.step;
        self.observer.step(record);
    }

    fn state(&mut self, model: &Model, state: &State) {
        self.take(model, state);
        self.observer.state(model, state);
    }

    fn restart(&mut self, model: &Model, state: &State, step: usize) {
        self.steps = step;
        self.take(model, state);
        self.observer.restart(model, state, step);
    }

    fn settled(&mut self, state: &State) {
        let is_behind = |(_, begin): &(Model, State)| self.dt > 0.0 && begin.time < state.time;
        self.is_settled |= self.stage == self.request.stage && self.begin.as_ref().is_some_and(is_behind);
        self.observer.settled(state);
    }

    fn stage(&mut self, stage: &Stage) {
        (self.stage, self.steps) = (self.stage + 1, 0);
        self.observer.stage(stage);
    }

    fn iteration(&mut self, iterate: &Iterate<'_>) {
        self.observer.iteration(iterate);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.is_settled || self.stage > self.request.stage || self.observer.wants_to_stop()
    }
}

impl Observer for IterationHistory {
    fn iteration(&mut self, iterate: &Iterate<'_>) {
        self.rows.push(iterate.record());
        self.iterates.push(iterate.snapshot());
    }
}

/// Velocity norm below which an increment is mostly round-off \[–\].
const ROUND_OFF: f64 = 1e-13;
/// Plausible orders \[–\]: beyond them contact or flow changed between two iterations.
const POSSIBLE: std::ops::RangeInclusive<f64> = 0.8..=2.5;
/// Largest relative difference of two successive orders in the asymptotic range \[–\].
const APART: f64 = 0.4;

/// Rate of convergence at the end of a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConvergenceRate {
    /// Order p of the last three increments \[–\]; `None` outside the asymptotic range.
    pub order: Option<f64>,
    /// Ratio of the last increment to the one before \[–\].
    pub left: f64,
}

impl ConvergenceRate {
    /// Rate of the last increments above round-off; `None` unless the last three fall and were taken whole (`Some`).
    pub fn new(increments: &[Option<f64>]) -> Option<Self> {
        let end = increments.iter().rposition(|norm| norm.is_none_or(|norm| norm > ROUND_OFF))? + 1;
        let whole = &increments[..end];
        let last = end.checked_sub(3).and_then(|start| triple(&whole[start..]))?;
        let before = end.checked_sub(4).and_then(|start| triple(&whole[start..end - 1]));
        let agrees = |(before, _): (f64, f64)| {
            let possible = POSSIBLE.contains(&last.0) && POSSIBLE.contains(&before);
            possible && (last.0 - before).abs() <= APART * last.0.max(before)
        };
        Some(Self { order: before.is_some_and(agrees).then_some(last.0), left: last.1 })
    }
}

fn triple(increments: &[Option<f64>]) -> Option<(f64, f64)> {
    match *increments {
        [Some(a), Some(b), Some(c)] if a > b && b > c => Some(((c / b).ln() / (b / a).ln(), c / b)),
        _ => None,
    }
}
