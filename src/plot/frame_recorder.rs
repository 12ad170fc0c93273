//! Frames of a run for animation and ParaView; no step is made to land on them, so that the run stays the same.

use super::{animation::PICTURES, *};
use crate::solver::{Observer, solution::ThroughThickness, state::State};

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
        frames.extend(stage.frames.last().filter(|end| frames.last().is_none_or(|last| last.time < end.time)));
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
        if let Some(frames) = self.stages.last_mut().filter(|_| !self.extras.is_empty() && done >= self.next) {
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
