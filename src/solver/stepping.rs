//! How long the next step is.

use super::corrector::patience;
use crate::model::Model;
use crate::state::State;

/// A step that needed at most this many iterations was easy: the next may be longer.
const EASY: usize = 8;
/// A step that needed more than this many was hard: the next is shorter.
const HARD: usize = 15;
const GROWTH: f64 = 1.5;
const SHRINK: f64 = 0.7;

/// Chooses steps between the first, smallest and largest of the settings, and lands on every frame.
pub(super) struct StepControl<'a> {
    model: &'a Model,
    /// Wanted step \[s\].
    wanted: f64,
    largest: f64,
    smallest: f64,
    next_frame: usize,
}

impl<'a> StepControl<'a> {
    pub fn new(model: &'a Model) -> Self {
        let duration = model.travel / model.speed;
        let settings = &model.settings;
        Self {
            model,
            wanted: settings.first_step * duration,
            largest: settings.max_step * duration,
            smallest: settings.min_step * duration,
            next_frame: 0,
        }
    }

    /// Length of the next step \[s\]; `None` at the end of the travel.
    pub fn next(&self, state: &State) -> Option<f64> {
        let target = self.model.frames.get(self.next_frame)?;
        let rest = (target - state.travel) / self.model.speed;
        // Equal steps up to the frame, so that none is tiny.
        Some(rest / (rest / self.wanted - 1e-9).ceil().max(1.0))
    }

    /// After an accepted step.
    pub fn accept(&mut self, dt: f64, iterations: usize) {
        let patience = patience(self.model.settings.iteration);
        if iterations <= EASY * patience {
            self.wanted = (self.wanted * GROWTH).min(self.largest);
        } else if iterations > HARD * patience {
            self.wanted = (dt * SHRINK).max(self.smallest);
        }
    }

    /// After a rejected step of `dt`; `false` when there is none shorter to try.
    pub fn reject(&mut self, dt: f64) -> bool {
        self.wanted = 0.5 * dt;
        self.wanted >= self.smallest
    }

    /// Whether the state is at a travel to keep; moves on to the next one.
    pub fn at_frame(&mut self, state: &State) -> bool {
        let Some(target) = self.model.frames.get(self.next_frame) else { return false };
        let reached = state.travel >= target * (1.0 - 1e-12);
        self.next_frame += usize::from(reached);
        reached
    }
}
