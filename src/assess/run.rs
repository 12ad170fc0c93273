//! What the questions after a run are put to.

use super::nearest::Nearest;
use crate::case::Case;
use crate::measure::events;
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::joined;

/// A case with its solved stages.
pub(super) struct Run<'a> {
    pub case: &'a Case,
    pub stages: &'a [StageSolution],
    /// The stage that comes nearest to its forming limit.
    pub nearest: Option<Nearest<'a>>,
    /// Whether it is one of many, which no question solves a second time.
    pub is_one_of_many: bool,
}

impl Run<'_> {
    /// What was found in a stage, counted from 0; with its number where there are several.
    pub fn of_stage(&self, found: String, i: usize) -> String {
        let stage = if self.stages.len() > 1 { format!("stage {n}", n = i + 1) } else { String::new() };
        joined([found, stage], ", ")
    }

    /// Every step of every stage.
    pub fn steps(&self) -> impl Iterator<Item = &StepRecord> {
        self.stages.iter().flat_map(|stage| &stage.steps)
    }

    /// The largest of a figure over all stages, or 0; `None` where no step was solved.
    pub fn largest(&self, value: impl Fn(&StepRecord) -> f64) -> Option<f64> {
        self.steps().map(value).reduce(f64::max).map(|largest| largest.max(0.0))
    }
}

/// Where a peak of the load lies on an event of its stage, to a step, what happens there: `(rim meets the die)`.
pub(super) fn at_event(stage: &StageSolution, peak: &StepRecord) -> String {
    let events = events(stage);
    let begins = stage.steps.iter().rev().find(|step| step.step < peak.step).map_or(0.0, |before| before.travel);
    let here = events.iter().find(|event| event.travel > begins && event.travel <= peak.travel);
    here.map_or_else(String::new, |event| format!("({event})", event = event.kind.label()))
}

/// A run whose steps strain the sheet by less in all forms nothing: shares of its work say nothing \[–\].
const FORMED: f64 = 2e-3;

/// Whether a stage strains the sheet enough for shares of its work to say something.
pub(super) fn formed(stage: &StageSolution) -> bool {
    stage.steps.iter().map(|step| step.strain_increment).sum::<f64>() > FORMED
}

/// The largest of a figure over a stage; 0 where there is none.
pub(super) fn largest(stage: &StageSolution, value: impl Fn(&StepRecord) -> f64) -> f64 {
    stage.steps.iter().map(value).fold(0.0, f64::max)
}
