//! A solution looked over: what all of its outputs are made from.

use super::{Pictures, StageView, verdict};
use crate::assess::{Answer, Finding};
use crate::case::Solution;
use crate::compare::{CompareError, Comparison};
use crate::study::verify::Verification;

/// A solution looked over once: what its outputs are made from.
#[derive(Clone, Debug)]
pub struct Results<'a> {
    /// The case and what came out of it.
    pub solution: &'a Solution,
    /// Every stage that was run.
    pub views: Vec<StageView<'a>>,
    /// What the case is compared with beside what its first stage computed.
    pub comparisons: Vec<Comparison>,
    /// How far its numbers can be trusted, where that was looked at.
    pub verification: Option<&'a Verification>,
}

impl<'a> Results<'a> {
    /// Looks a solution over.
    ///
    /// # Errors
    /// When a reference of the case cannot be read or does not fit.
    pub fn of(solution: &'a Solution) -> Result<Self, CompareError> {
        Ok(Self { solution, views: solution.views(), comparisons: solution.comparisons()?, verification: None })
    }

    /// The same with error bars, where it was verified.
    pub fn verified(mut self, verification: Option<&'a Verification>) -> Self {
        StageView::verify(&mut self.views, &self.solution.stages, verification);
        Self { verification, ..self }
    }

    /// The same with the verdict, which the summary of every stage carries: it is of all stages together.
    pub fn answered(mut self, answer: &Answer, findings: &[Finding]) -> Self {
        let verdict = verdict(answer, findings, self.verification).ok();
        self.views.iter_mut().for_each(|view| view.verdict.clone_from(&verdict));
        self
    }

    /// The same with pictures that are made so.
    pub fn with_pictures(mut self, pictures: &Pictures) -> Self {
        self.views.iter_mut().for_each(|view| view.pictures = pictures.clone());
        self
    }
}
