//! What a stage offers for comparison.

use crate::measure::RingTest;
use crate::model::{Extent, Model};
use crate::solution::{ElementRecord, StageSolution, StepRecord};
use crate::table::{Column, Field};

/// What a stage offers for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// What the section stands for, and what its forces are of.
    pub extent: Extent,
    /// Length of the undeformed blank from the axis or symmetry plane \[mm\].
    pub length: f64,
    /// Every step that was solved.
    pub steps: &'a [StepRecord],
    /// The elements of the last frame from the axis outward.
    pub elements: &'a [ElementRecord],
    /// Whether the stage came to its end.
    pub complete: bool,
    /// Of the ring that is cut from the case's part.
    pub ring: Option<&'a RingTest>,
}

impl<'a> Computed<'a> {
    /// What a solved stage offers.
    pub fn of(stage: &'a StageSolution) -> Self {
        Self {
            steps: &stage.steps,
            elements: stage.frames.last().map_or(&[], |frame| &frame.elements),
            complete: stage.stop.is_complete(),
            ..Self::nothing(&stage.model)
        }
    }

    /// Nothing yet, to find out whether references fit before anything is solved.
    pub fn nothing(model: &Model) -> Self {
        Self { extent: model.extent(), length: model.blank.length, steps: &[], elements: &[], complete: true, ring: None }
    }

    pub(super) fn step(&self, field: Field<StepRecord>) -> Column {
        field.column(self.extent, self.steps)
    }

    pub(super) fn element(&self, field: Field<ElementRecord>) -> Column {
        field.column(self.extent, self.elements)
    }
}
