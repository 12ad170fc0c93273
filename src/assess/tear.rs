//! Location of a tear, in numbers and words.

use super::forming_limit::Nearest;
use super::thinning::torn;
use crate::measure::place_on_part;
use crate::model::Geometry;
use crate::solver::solution::{StageSolution, Stop};
use crate::units::{Amount, joined};

pub(super) struct Tear<'a> {
    stage: usize,
    on: &'a StageSolution,
    /// \[mm\]; `None` in a stage without travel.
    travel: Option<f64>,
    /// Initial distance from the axis or symmetry plane \[mm\].
    s0: Option<f64>,
}

/// Tear where the forming limit is first reached, else where the run ended by one.
pub(super) fn tear(stages: &[StageSolution]) -> Option<Tear<'_>> {
    if let Some((on, reached)) =
        Nearest::of(stages).and_then(|nearest| Some((nearest.stage, nearest.assessment.reached?)))
    {
        let stage = stages.iter().position(|stage| std::ptr::eq(stage, on))?;
        return Some(Tear {
            stage,
            on,
            travel: (on.model.travel > 0.0).then_some(reached.travel),
            s0: Some(reached.s0),
        });
    }
    stages.iter().enumerate().find_map(|(stage, on)| {
        let (travel, s0) = match on.stop {
            Stop::Localised { travel, s0, .. } | Stop::Coalesced { travel, s0, .. } => (Some(travel), Some(s0)),
            Stop::LoadMaximum { travel, .. } => (Some(travel), thinnest(on).map(|(_, s0)| s0)),
            Stop::PressureMaximum { s0, .. } => (None, Some(s0)),
            _ => return None,
        };
        Some(Tear { stage, on, travel, s0 })
    })
}

impl Tear<'_> {
    /// `it tears in the wall, next to the punch radius, in stage 2`
    pub fn sentence(&self, stages: usize) -> String {
        let place = self.s0.map_or_else(String::new, |s0| on_part(self.on, s0));
        let stage = if stages > 1 { format!("in stage {}", self.stage + 1) } else { String::new() };
        joined([joined(["it tears".into(), place], " "), stage], ", ")
    }

    /// `after 18.2 mm of 32.0 mm of travel`
    pub fn instant(&self) -> String {
        let whole = Amount::place(self.on.model.travel);
        self.travel.map_or_else(String::new, |travel| format!("after {} of {whole} of travel", Amount::place(travel)))
    }
}

/// Whether and where it tears: `it tears on the dome`.
pub(super) fn tear_sentence(stages: &[StageSolution]) -> String {
    match (tear(stages), stages.last().and_then(torn)) {
        (Some(tear), _) => tear.sentence(stages.len()),
        (None, Some(neck)) => format!("it thins too far {}", place(stages, neck.s0)),
        (None, None) => "no tear is seen".into(),
    }
}

/// Initial distance of a stage's tear from the axis \[mm\], also where the sheet is too thin to be whole.
pub fn tears_at(stage: &StageSolution) -> Option<f64> {
    stage.steps.last()?;
    let tear = tear(std::slice::from_ref(stage)).and_then(|tear| tear.s0);
    tear.or_else(|| torn(stage).map(|neck| neck.s0))
}

/// Thickness and initial distance of the thinnest element at the end of a stage \[mm\].
pub(super) fn thinnest(stage: &StageSolution) -> Option<(f64, f64)> {
    stage.steps.last().map(|step| (step.thinnest, step.thinnest_s0))
}

/// Location by its name on the part, as the last stage with a name has it, and on the flat blank.
pub(super) fn place(stages: &[StageSolution], s0: f64) -> String {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(String::new, |stage| on_part(stage, s0))
}

/// Location on a stage's sheet by its name on the part, and on the flat blank.
pub(super) fn on_part(stage: &StageSolution, s0: f64) -> String {
    let from = match stage.model.geometry {
        Geometry::Axisymmetric => "from the axis on the flat blank",
        Geometry::PlaneStrain => "from the middle of the flat blank",
    };
    let blank = format!("{} {from}", Amount::place(s0));
    match place_on_part(stage, s0) {
        Some(place) => format!("{place} ({blank})"),
        None => blank,
    }
}
