//! Frames of a run for animation and ParaView; no step is made to land on them, so that the run stays the same.

use super::animation::PICTURES;
use crate::model::Model;
use crate::solver::solution::{Frame, StageSolution, ThroughThickness};
use crate::solver::{Observer, state::State};

/// Files that are written on request only, from the frames of a [`FrameRecorder`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extra {
    /// Files for ParaView.
    Vtu,
    /// Animated GIF.
    Animation,
}

/// Keeps frames of every stage, spread as evenly as its steps allow; none without extras.
#[derive(Clone, Debug, Default)]
pub struct FrameRecorder {
    /// Purpose of the frames.
    pub extras: Vec<Extra>,
    stages: Vec<Vec<Frame>>,
    /// Share of the stage \[–\] from which the next frame is kept.
    next: f64,
}

impl FrameRecorder {
    /// Recorder for some extras.
    pub fn new(extras: Vec<Extra>) -> Self {
        Self { extras, ..Self::default() }
    }

    /// Frames of a stage, counted from 0, up to its end.
    pub fn of_stage<'a>(&'a self, i: usize, stage: &'a StageSolution) -> Vec<&'a Frame> {
        let mut frames: Vec<&Frame> = self.stages.get(i).into_iter().flatten().collect();
        let end = stage.frames.last().filter(|end| frames.last().is_none_or(|last| last.time < end.time));
        frames.extend(end);
        frames
    }
}

/// Share of the stage from which the next frame is kept after one at `done` \[–\].
fn after(done: f64) -> f64 {
    ((done * PICTURES as f64).floor() + 1.0) / PICTURES as f64
}

impl Observer for FrameRecorder {
    fn state(&mut self, model: &Model, state: &State) {
        if state.time == 0.0 {
            self.stages.push(Vec::new());
            self.next = 0.0;
        }
        let done = model.progress(state.time) + 1e-9;
        let is_kept = !self.extras.is_empty() && done >= self.next;
        if let Some(frames) = self.stages.last_mut().filter(|_| is_kept) {
            frames.push(Frame { through: ThroughThickness::default(), ..state.frame(model) });
            self.next = after(done);
        }
    }

    fn restart(&mut self, model: &Model, state: &State, _step: usize) {
        if let Some(frames) = self.stages.last_mut() {
            frames.retain(|frame| frame.time <= state.time);
            self.next = after(model.progress(state.time) + 1e-9);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::solution::{IterationRecord, StepRecord};
    use crate::solver::trace::{TraceRequest, trace};
    use crate::solver::{self, Iterate};

    /// Records of a stage, and the number of restarts.
    struct Seen {
        recorder: FrameRecorder,
        steps: Vec<StepRecord>,
        iterations: Vec<IterationRecord>,
        states: Vec<f64>,
        restarts: usize,
    }

    impl Observer for Seen {
        fn step(&mut self, record: &StepRecord) {
            self.steps.push(*record);
        }
        fn state(&mut self, model: &Model, state: &State) {
            self.states.push(state.time);
            self.recorder.state(model, state);
        }
        fn iteration(&mut self, iterate: &Iterate) {
            self.iterations.push(iterate.record());
        }
        fn restart(&mut self, model: &Model, state: &State, step: usize) {
            self.restarts += 1;
            self.steps.truncate(step);
            self.states.truncate(step + 1);
            self.iterations.retain(|row| row.step <= step);
            self.recorder.restart(model, state, step);
        }
    }

    /// Trust: the results of the run; its last stretch is lost and taken with other settings.
    #[test]
    fn an_observer_sees_a_remedied_run_as_its_results_have_it() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/suite/stops/w_bend.toml");
        let overrides = ["blank.elements=36", "tools.punch.travel=36.8 mm"].map(str::to_owned);
        let case = crate::case::load(path, &overrides).expect("sound");
        let recorder = FrameRecorder::new(vec![Extra::Vtu]);
        let mut seen = Seen { recorder, steps: vec![], iterations: vec![], states: vec![], restarts: 0 };
        let run = &solver::solve(&case.stages, &mut seen)[0];
        assert!(seen.restarts > 0 && seen.restarts == run.remedied.len());
        assert_eq!(seen.steps, run.steps);
        let times: Vec<f64> = run.steps.iter().map(|step| step.time).collect();
        assert_eq!(seen.states[1..], times);
        let frames: Vec<f64> = seen.recorder.of_stage(0, run).iter().map(|frame| frame.time).collect();
        assert!(frames.is_sorted_by(|a, b| a < b) && frames[1..].iter().all(|time| times.contains(time)), "{frames:?}");
        let of_step = |n: usize| seen.iterations.iter().filter(move |row| row.step == n);
        assert!(run.steps.iter().all(|step| of_step(step.step).count() >= step.iterations));
        let last = run.steps[run.steps.len() - 1];
        let request = TraceRequest { stage: 1, step: last.step, matrices: vec![], tolerance: None };
        let traced = trace(&case.stages, &request, &mut ()).expect("a step");
        let end = traced.histories[0].end.as_ref().expect("equilibrium");
        assert_eq!((traced.record, end.time), (last, last.time));
    }
}
