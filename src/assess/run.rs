//! Solved case, as findings see it.

use super::forming_limit::Nearest;
use crate::case::Case;
use crate::measure::events;
use crate::solver::solution::{StageSolution, StepRecord};

pub(super) struct Run<'a> {
    pub case: &'a Case,
    pub stages: &'a [StageSolution],
    /// The stage that comes nearest to its forming limit.
    pub nearest: Option<Nearest<'a>>,
    /// Whether it is one of many runs, in which no finding may solve the case a second time.
    pub is_one_of_many: bool,
}

impl Run<'_> {
    /// Text with the number of its stage, counted from 0, if there are several.
    pub fn of_stage(&self, text: String, i: usize) -> String {
        if self.stages.len() > 1 { format!("{text}, stage {}", i + 1) } else { text }
    }

    pub fn steps(&self) -> impl Iterator<Item = &StepRecord> {
        self.stages.iter().flat_map(|stage| &stage.steps)
    }

    /// Largest of a figure over all stages, or 0; `None` without a step.
    pub fn largest(&self, value: impl Fn(&StepRecord) -> f64) -> Option<f64> {
        self.steps().map(value).reduce(f64::max).map(|largest| largest.max(0.0))
    }
}

/// Event of a stage in the step of a peak load: `(rim meets the die)`.
pub(super) fn at_event(stage: &StageSolution, peak: &StepRecord) -> String {
    let events = events(stage);
    let begins = stage.steps.iter().rev().find(|step| step.step < peak.step).map_or(0.0, |before| before.travel);
    let here = events.iter().find(|event| event.travel > begins && event.travel <= peak.travel);
    here.map_or_else(String::new, |event| format!("({event})", event = event.kind.label()))
}

/// Largest of a figure over a stage, or 0.
pub(super) fn largest(stage: &StageSolution, value: impl Fn(&StepRecord) -> f64) -> f64 {
    stage.steps.iter().map(value).fold(0.0, f64::max)
}
