//! The beginning of a run.

use stampflow::{Observer, StepRecord};

/// Ends a run after so many steps.
pub struct Few(pub usize);

impl Observer for Few {
    fn step(&mut self, _: &StepRecord) {
        self.0 = self.0.saturating_sub(1);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.0 == 0
    }
}
