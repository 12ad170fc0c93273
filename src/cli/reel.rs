//! Frames for a film and for ParaView, kept on the way: no step is made to land on them, so that the run is the same with
//! and without.

use stampflow::State;
use stampflow::model::Model;
use stampflow::output::film;
use stampflow::solution::{Frame, StageSolution};

/// The frames of every stage, from its start, spread over it as evenly as its steps allow.
#[derive(Clone, Debug, Default)]
pub struct Reels {
    stages: Vec<Vec<Frame>>,
    /// Share of the stage \[–\] from which the next frame is kept.
    next: f64,
}

impl Reels {
    /// Keeps the state where the next frame is due.
    pub fn see(&mut self, model: &Model, state: &State) {
        let pictures = film::PICTURES as f64;
        if state.time == 0.0 {
            self.stages.push(Vec::new());
            self.next = 0.0;
        }
        let done = model.progress(state.time);
        let Some(frames) = self.stages.last_mut().filter(|_| done >= self.next - 1e-9) else { return };
        frames.push(state.frame(model));
        self.next = (((done + 1e-9) * pictures).floor() + 1.0) / pictures;
    }

    /// The frames of a stage, counted from 0, up to where its run ended.
    pub fn of_stage(&self, stage: usize, run: &StageSolution) -> Vec<Frame> {
        let mut frames = self.stages.get(stage).cloned().unwrap_or_default();
        let end = run.frames.last().filter(|end| frames.last().is_none_or(|last| last.time < end.time));
        frames.extend(end.cloned());
        frames
    }
}
