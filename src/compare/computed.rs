//! Computed values of a stage for comparison.

use crate::forming_limit::Paths;
use crate::measure::RingTest;
use crate::model::{Extent, Model};
use crate::solver::solution::{ElementRecord, StageSolution, StepRecord};
use crate::table::fields::path;
use crate::table::{Column, Field};

/// Computed values of a stage for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// Extent of the section, which its forces refer to.
    pub extent: Extent,
    /// Length of the undeformed blank from the axis or symmetry plane \[mm\].
    pub length: f64,
    /// Every step that was solved.
    pub steps: &'a [StepRecord],
    /// The elements of the last frame from the axis outward.
    pub elements: &'a [ElementRecord],
    /// The way of every element through the plane of strains; empty where none was kept.
    pub paths: Option<&'a Paths>,
    /// Whether the stage came to its end.
    pub complete: bool,
    /// Test of the ring that is cut from the part.
    pub ring: Option<&'a RingTest>,
}

impl<'a> Computed<'a> {
    /// Values of a solved stage.
    pub fn of(stage: &'a StageSolution) -> Self {
        Self {
            steps: &stage.steps,
            elements: stage.frames.last().map_or(&[], |frame| &frame.elements),
            paths: Some(&stage.paths),
            complete: stage.stop.is_complete(),
            ..Self::nothing(&stage.model)
        }
    }

    /// No values, to check references before anything is solved.
    pub fn nothing(model: &Model) -> Self {
        let (extent, length) = (model.extent(), model.blank.length);
        Self { extent, length, steps: &[], elements: &[], paths: None, complete: true, ring: None }
    }

    /// Major and minor strain of the place that is thinnest at the end, over its way there.
    pub(super) fn path(&self) -> (Column, Column) {
        let thinner = |a: &usize, b: &usize| self.elements[*a].thickness.total_cmp(&self.elements[*b].thickness);
        let thinnest = (0..self.elements.len()).min_by(thinner);
        let path = thinnest.zip(self.paths).map_or_else(Vec::new, |(element, paths)| paths.of(element));
        let (minor, major) = path.into_iter().map(|[minor, major]| (minor, major)).unzip();
        let short = |label, column: Column| Column { label, ..column };
        (short("Major true strain", path::major(major)), short("Minor true strain", path::minor(minor)))
    }

    pub(super) fn step(&self, field: Field<StepRecord>) -> Column {
        field.column(self.extent, self.steps)
    }

    pub(super) fn element(&self, field: Field<ElementRecord>) -> Column {
        field.column(self.extent, self.elements)
    }
}
