//! Where on the part something is, in words.

use crate::measure::{PartPlace, place_on_part};
use crate::message::{Amount, Message, message};
use crate::model::Geometry;
use crate::solver::solution::StageSolution;

/// Thickness \[mm\] and initial distance \[mm\] of the thinnest element at the end of a stage.
pub(super) fn thinnest(stage: &StageSolution) -> Option<(f64, f64)> {
    stage.steps.last().map(|step| (step.thinnest, step.thinnest_s0))
}

/// A place by its name on the part, as the last stage has one, and where it is on the flat blank.
pub(super) fn place(stages: &[StageSolution], s0: f64) -> Message {
    let named = stages.iter().rev().find(|stage| place_on_part(stage, s0).is_some());
    named.or(stages.last()).map_or_else(Message::default, |stage| on_part(stage, s0))
}

/// A place of a stage's sheet, by its name on the part and on the flat blank.
pub(super) fn on_part(stage: &StageSolution, s0: f64) -> Message {
    let blank = match stage.model.geometry {
        Geometry::Axisymmetric => message!("{s0} from the axis on the flat blank", s0 = Amount::place(s0)),
        Geometry::PlaneStrain => message!("{s0} from the middle of the flat blank", s0 = Amount::place(s0)),
    };
    match place_on_part(stage, s0) {
        Some(PartPlace { band, next_to: None, .. }) => {
            message!("{band} ({blank})", band = band.at(), blank = blank)
        }
        Some(PartPlace { band, next_to: Some(other), .. }) => {
            message!("{band}, next to the {other} ({blank})", band = band.at(), other = other.name(), blank = blank)
        }
        None => blank,
    }
}
