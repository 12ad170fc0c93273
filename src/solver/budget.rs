//! Limit on the tries of a run, so that one that creeps ends.

use crate::model::{Model, Settings};

/// Tries in which a run must come on by a hundredth, or by its longest step: the shipped cases take at most 7, of 2600 random
/// cases one takes 41.
const IN_A_STRETCH: usize = 500;
/// Tries in all: so many times the steps that the settings ask for, and so many more.
const PLANNED: usize = 5;
const SPARE: usize = 5000;

pub(super) struct Budget {
    pub tries: usize,
    /// Progress at the start of the last stretch \[–\], and the tries before it.
    begun: (f64, usize),
    stretch: f64,
    in_a_stretch: usize,
    in_all: usize,
}

impl Budget {
    /// Budget by the longest step, the strain step, the frames and the changes of speed.
    pub fn new(model: &Model) -> Self {
        let settings = &model.settings;
        let finer = (Settings::default().strain_step / settings.strain_step).max(1.0);
        let landings = model.frames.len() + model.schedule.as_ref().map_or(0, |schedule| schedule.points().len());
        Self {
            tries: 0,
            begun: (0.0, 0),
            stretch: settings.max_step.min(Settings::CUTOFF_STEP),
            in_a_stretch: (IN_A_STRETCH as f64 * finer) as usize + landings,
            in_all: PLANNED * ((finer / settings.max_step) as usize + landings) + SPARE,
        }
    }

    /// Counts a try at this progress \[–\]; `false` when the budget is spent.
    pub fn spend(&mut self, done: f64) -> bool {
        if done >= self.begun.0 + self.stretch {
            self.begun = (done, self.tries);
        }
        self.tries += 1;
        self.tries - self.begun.1 <= self.in_a_stretch && self.tries <= self.in_all
    }
}
