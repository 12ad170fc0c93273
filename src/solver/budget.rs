//! How many tries of a step a run may take: one that creeps ends, instead of going on for hours.

use crate::model::{Model, Settings};

/// Tries of a step, accepted or not, in which a run comes on by a hundredth, or by its longest step where that is less: the
/// shipped cases take at most 7, of 2600 random pieces of work one takes 41, a cup whose corrector may take but four
/// iterations 106.
const IN_A_STRETCH: usize = 500;
/// Tries in all: this many times the steps that the settings ask for, of which these took at most 4, and so many more.
const PLANNED: usize = 5;
const SPARE: usize = 5000;

/// Tries of a step that were made so far, and how many there may be.
pub(super) struct Budget {
    tries: usize,
    /// Share of the run that was done when its last stretch began \[–\], and the tries before it.
    begun: (f64, usize),
    stretch: f64,
    in_a_stretch: usize,
    in_all: usize,
}

impl Budget {
    /// Of a run of `model`: its steps are as many as its longest step makes, and more where each may strain less than usual;
    /// and it lands on its frames and changes of speed.
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

    /// Counts a try of a step from where the run has done this share \[–\]; `false` when it may not be made any more.
    pub fn spend(&mut self, done: f64) -> bool {
        if done >= self.begun.0 + self.stretch {
            self.begun = (done, self.tries);
        }
        self.tries += 1;
        self.tries - self.begun.1 <= self.in_a_stretch && self.tries <= self.in_all
    }

    /// Tries so far, the last one included.
    pub fn tries(&self) -> usize {
        self.tries
    }
}
