//! Whether the holder closed on the die over the sheet before the punch came.

use super::Finding;
use crate::assess::bead;
use crate::model::{Geometry, Model};
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::{Amount, joined};

/// Gap over the thickness that a holder may keep \[–\]: what a flange thickens by as it is drawn.
const OPEN: f64 = 0.1;

/// A holder that closes before the draw, told where the case is checked.
pub(super) fn closes(model: &Model) -> Option<Finding> {
    let way = crate::solver::closing_way(model)?;
    let found = format!(
        "holder and die do not lie flat on the sheet: the holder closes over it by {way} before the punch comes",
        way = Amount::place(way)
    );
    Some(Finding::assumed(found))
}

/// How far the holder stood open when the draw began \[mm\], where that is too far.
pub(super) fn open(stage: &StageSolution) -> Option<f64> {
    Some(stage.closing?.gap).filter(|gap| *gap > OPEN * stage.model.blank.thickness)
}

/// A holder that its force did not close.
pub(super) fn stays_open(stage: &StageSolution) -> Option<Finding> {
    let gap = open(stage)?;
    let found = format!(
        "the holder did not close: with its force of {force} it stands open by {gap} when the draw begins",
        force = Amount::force(stage.closing?.force, stage.model.extent().force_unit()),
        gap = Amount::thickness(gap)
    );
    let limit = format!("open by at most {open} t", open = Amount::number(OPEN));
    Some(Finding::warning("holder_open", "Holder", found).against(gap, Unit::Mm, limit).advice(advice(&stage.model)))
}

/// What closes a holder, and of a bead how else it is written.
pub(super) fn advice(model: &Model) -> String {
    let more: String = "more holder force, until it closes".into();
    let Some(bead) = bead::drawn(model) else { return more };
    let line = format!(
        "or a flat holder and die with the bead as a line, [[tools.beads]] at = \"{at}\", restraining = \"{force} N/mm\": declared, \
         the work of bending over its radii",
        at = Amount::place(bead.at),
        force = Amount::number(bead.restraining.round())
    );
    joined([more, line], "; ")
}

/// A bead that is drawn, and how it would be written as a line; told where the case is checked.
pub(super) fn drawn(model: &Model) -> Option<Finding> {
    let bead = bead::drawn(model).filter(|_| crate::solver::closing_way(model).is_some())?;
    let around = match model.geometry {
        Geometry::Axisymmetric => "from the axis",
        Geometry::PlaneStrain => "from the symmetry plane",
    };
    Some(Finding::assumed(format!(
        "the bead {at} {around} is drawn and closes with the holder; as a line on a flat holder and die it would be \
         [[tools.beads]] at = \"{at}\", restraining = \"{force} N/mm\" (declared: the work of bending over its radii)",
        at = Amount::place(bead.at),
        force = Amount::number(bead.restraining.round())
    )))
}
