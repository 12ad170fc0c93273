//! The history of every accepted step over the punch travel.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{JOULES, Subject, energy_unit, force_unit, worded};
use crate::model::{Geometry, Model};
use crate::solution::{StageSolution, StepRecord};
use crate::table::{Axis, Column, Table, Unit};
use crate::units::ZERO_CELSIUS;

/// One row per accepted step.
pub fn table(model: &Model, run: &StageSolution) -> Table {
    let force = force_unit(model.geometry);
    let column = |key, label, unit, value: fn(&StepRecord) -> f64| {
        Column::new(key, label, unit, run.steps.iter().map(value).collect())
    };
    let energy = |key, label, value: fn(&StepRecord) -> f64| {
        let values = run.steps.iter().map(|step| JOULES * value(step)).collect();
        Column::new(key, label, energy_unit(model.geometry), values)
    };
    let edge = match model.geometry {
        Geometry::Axisymmetric => "Diameter at the edge",
        Geometry::PlaneStrain => "Width between the edges",
    };
    let diameters = run.steps.iter().map(|s| 2.0 * (model.blank.length - s.draw_in)).collect();
    let thinnest_s0 = worded(
        model.geometry,
        "Initial distance of the thinnest place from the axis",
        "Initial distance of the thinnest place from the symmetry plane",
    );
    let mut columns = vec![
        column("travel", "Punch travel", Unit::Mm, |s| s.travel),
        column("punch_force", "Punch force", force, |s| s.punch_force),
        column("holder_force", "Holder force", force, |s| s.holder_force),
        column("edge_force", "Edge force", force, |s| s.edge_force),
        column("draw_in", "Draw-in of the edge", Unit::Mm, |s| s.draw_in),
        column("thinnest", "Least thickness", Unit::Mm, |s| s.thinnest),
        column("thinnest_s0", thinnest_s0, Unit::Mm, |s| s.thinnest_s0),
        Column::new("edge_diameter", edge, Unit::Mm, diameters),
        energy("work_external", "External work", |s| s.work.external),
        energy("work_plastic", "Plastic work", |s| s.work.plastic),
        energy("work_friction", "Friction work", |s| s.work.friction),
        energy("work_contact", "Contact work", |s| s.work.contact),
        energy("work_cutoff", "Work in cut-off points", |s| s.work.cutoff),
        column("pole_height", "Height of the middle", Unit::Mm, |s| s.pole_height),
        column("pressure", "Gas pressure", Unit::MPa, |s| s.pressure),
        column("holder_move", "Move of the holder towards the die", Unit::Mm, |s| s.holder_move),
        column("penetration", "Penetration over thickness", Unit::None, |s| s.penetration),
        column("squeeze", "Squeeze between two tools over thickness", Unit::None, |s| s.ironing),
        column("rim_share", "Share of the holder force on the rim", Unit::None, |s| s.rim_share),
        column("sticking", "Share of the nodes in contact that stick", Unit::None, |s| s.sticking),
        column("flips", "Contacts that came or went", Unit::None, |s| s.contact_changes as f64),
        column("sharpest_bend", "Thickness over the smallest bending radius", Unit::None, |s| s.sharpest_bend),
        column("strain_increment", "Largest strain of the step", Unit::None, |s| s.strain_increment),
        column("contact_share", "Contact share: the sheet on punch and die", Unit::None, |s| s.contact_share),
        column("step", "Step", Unit::None, |s| s.step as f64),
        column("time", "Time", Unit::Second, |s| s.time),
        column("iterations", "Iterations", Unit::None, |s| s.iterations as f64),
        column("rejected", "Rejected tries", Unit::None, |s| s.rejected as f64),
        column("velocity_norm", "Relative velocity increment", Unit::None, |s| s.velocity_norm),
        column("residual_norm", "Relative residual", Unit::None, |s| s.residual_norm),
    ];
    if model.material.voids.is_some() {
        columns.push(column("porosity", "Largest porosity", Unit::None, |s| s.porosity));
    }
    if model.heat.is_some() {
        columns.push(column("coldest", "Lowest temperature", Unit::Celsius, |s| s.coldest - ZERO_CELSIUS));
        columns.push(column("hottest", "Highest temperature", Unit::Celsius, |s| s.hottest - ZERO_CELSIUS));
        columns.push(energy("heat_plastic", "Heat from plastic work", |s| s.heat.plastic));
        columns.push(energy("heat_tools", "Heat from the tools", |s| s.heat.tools));
        columns.push(energy("heat_stored", "Heat stored in the sheet", |s| s.heat.stored));
    }
    Table::new(columns)
}

pub(super) fn of(subject: &Subject) -> Option<Table> {
    Some(table(subject.model, subject.run))
}

pub(super) fn plot(subject: &Subject) -> Option<Chart> {
    let panel = panel(subject, 350.0)?;
    let what = if subject.model.travel == 0.0 { "pressure" } else { "forces" };
    Some(Chart {
        title: format!("{}: {what}", subject.model.title),
        legend: "",
        panels: vec![panel],
        notes: subject.notes(),
    })
}

/// Punch and holder force over the travel, and the held edge's force where there is one; under gas alone, its pressure
/// over the height of the dome; nothing while the tools are taken away. One point per step in every series.
pub(super) fn panel(subject: &Subject, height: f64) -> Option<Panel> {
    subject.run.steps.first().filter(|_| subject.model.release.is_none())?;
    let table = table(subject.model, subject.run);
    let scale = Scale::Fit { height, least: 0.0 };
    if subject.model.travel == 0.0 {
        let (x, pressure) = (table.column("pole_height"), table.column("pressure"));
        let series = vec![Series::new(pressure.label, table.pairs(x.key, pressure.key), Look::curve(0))];
        return Some(Panel { x: x.axis(), y: pressure.axis(), series, scale });
    }
    let acts = |key: &str| key == "punch_force" || table.column(key).values.iter().any(|v| *v != 0.0);
    let keys: Vec<&str> = ["punch_force", "holder_force", "edge_force"].into_iter().filter(|k| acts(k)).collect();
    let columns: Vec<&Column> = keys.iter().map(|key| table.column(key)).collect();
    let series = columns
        .iter()
        .enumerate()
        .map(|(i, column)| Series::new(column.label, table.pairs("travel", column.key), Look::curve(i)))
        .collect();
    Some(Panel { x: table.column("travel").axis(), y: Axis::shared(&columns), series, scale })
}
