//! Where on the part something is, in words.

use crate::measure::{PartPlace, place_on_part};
use crate::model::Geometry;
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Thickness \[mm\] and initial distance \[mm\] of the thinnest element at the end of a stage.
pub(super) fn thinnest(stage: &StageSolution) -> Option<(f64, f64)> {
    stage.steps.last().map(|step| (step.thinnest, step.thinnest_s0))
}

/// A place by its name on the part, as the last stage has one, and where it is on the flat blank.
pub(super) fn place(stages: &[StageSolution], s0: f64) -> String {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(String::new, |stage| on_part(stage, s0))
}

/// A place of a stage's sheet, by its name on the part and on the flat blank.
pub(super) fn on_part(stage: &StageSolution, s0: f64) -> String {
    let blank = match stage.model.geometry {
        Geometry::Axisymmetric => format!("{s0} from the axis on the flat blank", s0 = Amount::place(s0)),
        Geometry::PlaneStrain => format!("{s0} from the middle of the flat blank", s0 = Amount::place(s0)),
    };
    match place_on_part(stage, s0) {
        Some(PartPlace { band, next_to: None, .. }) => {
            format!("{band} ({blank})", band = band.at())
        }
        Some(PartPlace { band, next_to: Some(other), .. }) => {
            format!("{band}, next to the {other} ({blank})", band = band.at(), other = other.name())
        }
        None => blank,
    }
}
