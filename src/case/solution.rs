//! A case with what came out of it.

use super::{Case, CaseError};
use crate::solver::solution::StageSolution;
use crate::solver::{Observer, solve};
use std::path::Path;
use std::time::Duration;

/// A solved case.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Solved case.
    pub case: Case,
    /// The stages that were run, in order: up to the first that did not come to its end.
    pub stages: Vec<StageSolution>,
    /// Time that the solution took, by the clock of whoever has one.
    pub wall: Option<Duration>,
}

impl Case {
    /// Reads a case file as it stands.
    ///
    /// # Errors
    /// Those of [`load`](super::load).
    pub fn load(path: impl AsRef<Path>) -> Result<Self, CaseError> {
        super::load(path, &[])
    }

    /// Runs the stages after one another, each on the sheet that the one before left.
    pub fn solve(self, observer: &mut dyn Observer) -> Solution {
        let stages = solve(&self.stages, observer);
        Solution { case: self, stages, wall: None }
    }

    /// Label of stage `i`, counted from 0, in folders and headings: `1-draw`; `None` in a case of one stage.
    pub fn stage_label(&self, i: usize) -> Option<String> {
        let name = self.stage_names().nth(i).filter(|_| self.stages.len() > 1)?;
        Some(format!("{}-{name}", i + 1))
    }
}

impl Solution {
    /// True if every stage was run and came to its end.
    pub fn is_complete(&self) -> bool {
        self.stages.len() == self.case.stages.len() && self.stages.iter().all(|stage| stage.stop.is_complete())
    }
}
