//! Table of every accepted step.

use super::StageView;
use crate::model::Geometry;
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::fields::step::{
    DRAW_IN, EDGE_FORCE, HOLDER_FORCE, POLE_HEIGHT, PRESSURE, PUNCH_FORCE, THINNEST, TRAVEL,
};
use crate::table::{Column, Field, JOULES, Table, Unit, worded};
use crate::units::ZERO_CELSIUS;

/// Columns before and behind the diameter at the edge.
const BEFORE: [Field<StepRecord>; 7] = [
    TRAVEL,
    PUNCH_FORCE,
    HOLDER_FORCE,
    EDGE_FORCE,
    DRAW_IN,
    THINNEST,
    Field::worded(
        "thinnest_s0",
        [
            "Initial distance of the thinnest place from the axis",
            "Initial distance of the thinnest place from the symmetry plane",
        ],
        Unit::Mm,
        |s| s.thinnest_s0,
    ),
];
const BEHIND: [Field<StepRecord>; 25] = [
    Field::new("work_external", "External work", Unit::Joule, |s| JOULES * s.work.external),
    Field::new("work_plastic", "Plastic work", Unit::Joule, |s| JOULES * s.work.plastic),
    Field::new("work_friction", "Friction work", Unit::Joule, |s| JOULES * s.work.friction),
    Field::new("work_contact", "Contact work", Unit::Joule, |s| JOULES * s.work.contact),
    Field::new("work_cutoff", "Work in cut-off points", Unit::Joule, |s| JOULES * s.work.cutoff),
    POLE_HEIGHT,
    PRESSURE,
    Field::new("holder_move", "Move of the holder towards the die", Unit::Mm, |s| s.holder_move),
    Field::new("penetration", "Penetration over thickness", Unit::None, |s| s.penetration),
    Field::new("ironing", "Reduction by ironing over thickness", Unit::None, |s| s.ironing),
    Field::new("ironing_force", "Ironing force of the die", Unit::N, |s| s.ironing_force),
    Field::new("ironing_friction", "Friction in the ironing force", Unit::N, |s| s.ironing_friction),
    Field::new("ironing_pressure", "Largest ironing pressure", Unit::MPa, |s| s.ironing_pressure),
    Field::new("rim_share", "Share of the holder force on the rim", Unit::None, |s| s.rim_share),
    Field::new("sticking", "Share of the nodes in contact that stick", Unit::None, |s| s.sticking),
    Field::new("flips", "Contacts that came or went", Unit::None, |s| s.contact_changes as f64),
    Field::new("sharpest_bend", "Thickness over the smallest bending radius", Unit::None, |s| s.sharpest_bend),
    Field::new("strain_increment", "Largest strain of the step", Unit::None, |s| s.strain_increment),
    Field::new("contact_share", "Contact share: the sheet on punch and die", Unit::None, |s| s.contact_share),
    Field::new("step", "Step", Unit::None, |s| s.step as f64),
    Field::new("time", "Time", Unit::Second, |s| s.time),
    Field::new("iterations", "Iterations", Unit::None, |s| s.iterations as f64),
    Field::new("rejected", "Rejected tries", Unit::None, |s| s.rejected as f64),
    Field::new("velocity_norm", "Relative velocity increment", Unit::None, |s| s.velocity_norm),
    Field::new("residual_norm", "Relative residual", Unit::None, |s| s.residual_norm),
];
/// Columns of a sheet with voids.
const VOIDS: [Field<StepRecord>; 1] = [Field::new("porosity", "Largest porosity", Unit::None, |s| s.porosity)];
/// Columns of a sheet with a temperature.
const HEAT: [Field<StepRecord>; 5] = [
    Field::new("coldest", "Lowest temperature", Unit::Celsius, |s| s.coldest - ZERO_CELSIUS),
    Field::new("hottest", "Highest temperature", Unit::Celsius, |s| s.hottest - ZERO_CELSIUS),
    Field::new("heat_plastic", "Heat from plastic work", Unit::Joule, |s| JOULES * s.heat.plastic),
    Field::new("heat_tools", "Heat from the tools", Unit::Joule, |s| JOULES * s.heat.tools),
    Field::new("heat_stored", "Heat stored in the sheet", Unit::Joule, |s| JOULES * s.heat.stored),
];

/// One row per accepted step.
pub fn table(stage: &StageSolution) -> Table {
    let (model, extent) = (&stage.model, stage.model.extent());
    let column = |field: &Field<StepRecord>| field.column(extent, &stage.steps);
    let edge = edge_diameter(model.geometry, model.blank.length, &stage.steps);
    let mut columns: Vec<_> = BEFORE.iter().map(column).chain([edge]).chain(BEHIND.iter().map(column)).collect();
    if model.material.gtn.is_some() {
        columns.extend(VOIDS.iter().map(column));
    }
    if model.heat.is_some() {
        columns.extend(HEAT.iter().map(column));
    }
    Table::new(columns)
}

pub(super) fn of(view: &StageView) -> Option<Table> {
    Some(table(view.stage))
}

/// Diameter at the edge of a blank of this length \[mm\]; in plane strain the width between both edges.
pub(super) fn edge_diameter(geometry: Geometry, length: f64, steps: &[StepRecord]) -> Column {
    let label = worded(geometry, "Diameter at the edge", "Width between the edges");
    let values = steps.iter().map(|s| 2.0 * (length - s.draw_in)).collect();
    Column::new("edge_diameter", label, Unit::Mm, values)
}
