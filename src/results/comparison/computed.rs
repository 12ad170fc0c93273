//! Computed values of a stage for comparison.

use super::{CompareError, Point, Reference};
use crate::case::comparison::{ComparedQuantity as Q, Spec};
use crate::forming_limit::Paths;
use crate::model::{Extent, Model};
use crate::plot::fields::{element, step};
use crate::results::tables::edge_diameter;
use crate::solver::solution::{ElementRecord, StageSolution, StepRecord};
use crate::table::{Column, Field, Unit};

/// Computed values of a stage for comparison.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// Extent of the section, which its forces refer to.
    pub extent: Extent,
    /// Length of the undeformed blank from the axis or symmetry plane \[mm\].
    pub length: f64,
    /// Every solved step.
    pub steps: &'a [StepRecord],
    /// Elements of the last frame from the axis outward.
    pub elements: &'a [ElementRecord],
    /// Strain path of every element, if they were kept.
    pub paths: Option<&'a Paths>,
    /// True if the stage came to its end.
    pub complete: bool,
    /// Opening of the ring that is cut from the part, and lower edges and openings of rings along its wall \[mm\].
    pub ring: Option<(f64, &'a [(f64, f64)])>,
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

    /// Judged points of a reference curve with the computed values; a reference may be 0.
    pub fn points(&self, spec: &Spec) -> Result<Vec<Point>, CompareError> {
        let (x, y) = self.columns(spec.quantity);
        let points = Reference::new(spec)?.points([&x, &y])?;
        Ok(points.into_iter().filter(|point| point.judged).collect())
    }

    /// Abscissa and ordinate of a quantity; what a band is compared with is in the ordinate.
    pub fn columns(&self, quantity: Q) -> (Column, Column) {
        let step = |field: Field<StepRecord>| field.column(self.extent, self.steps);
        let element = |field: Field<ElementRecord>| field.column(self.extent, self.elements);
        let over_travel = |values| (step(step::TRAVEL), values);
        match quantity {
            Q::PunchForce | Q::PeakForce => over_travel(step(step::PUNCH_FORCE)),
            Q::Travel | Q::PeakTravel => (step(step::PUNCH_FORCE), step(step::TRAVEL)),
            Q::ThicknessAtS0 => (element(element::S0), element(element::THICKNESS)),
            Q::ThicknessAtRadius | Q::Thickness => (element(element::R), element(element::THICKNESS)),
            Q::StrainPath => self.path(),
            Q::DrawInAtTravel | Q::DrawIn => over_travel(step(step::DRAW_IN)),
            Q::Thinnest => over_travel(step(step::THINNEST)),
            Q::EdgeDiameter => over_travel(edge_diameter(self.extent.geometry(), self.length, self.steps)),
            Q::RingOpening => {
                let (from, openings) = self.ring.map_or(&[][..], |(_, all)| all).iter().copied().unzip();
                let from = Column::new("ring_from", "Lower edge of the ring over the bottom", Unit::Mm, from);
                (from, Column::new("ring_opening", "Opening of the slit ring", Unit::Mm, openings))
            }
        }
    }

    /// Major and minor strain, over the run, of the place that is thinnest at the end.
    fn path(&self) -> (Column, Column) {
        let thinner = |a: &usize, b: &usize| self.elements[*a].thickness.total_cmp(&self.elements[*b].thickness);
        let thinnest = (0..self.elements.len()).min_by(thinner);
        let path = thinnest.zip(self.paths).map_or_else(Vec::new, |(element, paths)| paths.of(element));
        let (minor, major) = path.into_iter().map(|[minor, major]| (minor, major)).unzip();
        let strain = |key, label, values| Column::new(key, label, Unit::None, values);
        (strain("strain_major", "Major true strain", major), strain("strain_minor", "Minor true strain", minor))
    }
}
