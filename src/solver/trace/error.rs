//! A step that a run does not have.

use crate::solver::solution::Stop;

/// Why there is nothing to take apart.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoSuchStep {
    /// The case has fewer stages, or it was 0.
    #[error("there is no stage {asked}: the case has {stages}, counted from 1")]
    Stage {
        /// What was asked for.
        asked: usize,
        /// How many there are.
        stages: usize,
    },
    /// The stage has fewer steps, or it was 0.
    #[error("there is no step {asked}: the run has {steps}, counted from 1")]
    Step {
        /// What was asked for.
        asked: usize,
        /// How many there are.
        steps: usize,
        /// Why there are no more.
        stop: Stop,
    },
    /// The run has ended in an earlier stage.
    #[error("stage {asked} is not reached: the run ends in stage {reached}")]
    NotReached {
        /// The stage that was asked for, from 1.
        asked: usize,
        /// The last stage that was run, from 1.
        reached: usize,
        /// Why it was the last.
        stop: Stop,
    },
}

impl NoSuchStep {
    /// Whether an observer ended the run before it came to the step.
    pub fn is_interrupted(&self) -> bool {
        let (Self::Step { stop, .. } | Self::NotReached { stop, .. }) = self else { return false };
        matches!(stop, Stop::Interrupted { .. })
    }
}
