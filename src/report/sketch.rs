//! The section at the start with its dimensions, drawn and in a table.

use super::document::{Block, Picture, Row, Section};
use crate::geometry::{Arc, Point};
use crate::model::{Model, Motion, Role, Tool};
use crate::output::{Dimension, Mark, dimensioned, svg};
use crate::rules::tool_sizes::{across, extent, throat};
use crate::table::Unit;
use crate::units::four_digits;

/// More corners than that are a curve's: its smallest radius is given.
const CORNERS: usize = 3;

pub(super) fn section(model: &Model, dimensions: &[Dimension]) -> Section {
    let rows =
        dimensions.iter().map(|d| Row::plain([d.label.clone(), four_digits(d.value), d.unit.symbol().to_owned()]));
    Section {
        heading: "Section".into(),
        blocks: vec![
            Block::Picture(Picture {
                name: "section".into(),
                caption: "the section at the start with its dimensions".into(),
                svg: svg(&dimensioned(model, dimensions)),
            }),
            Block::Table { head: vec!["Dimension", "Value", "Unit"], rows: rows.collect() },
        ],
    }
}

/// Sizes of the blank and of every tool, the holder's load and the travel.
pub(super) fn dimensions(model: &Model) -> Vec<Dimension> {
    let blank = &model.blank;
    let wide = |label: &str, r: f64| of(&format!("{label} {}", across(model.geometry)), r, Unit::Mm, Mark::Across(r));
    let mut found = vec![
        wide("Blank", blank.length),
        of("Thickness", blank.thickness, Unit::Mm, Mark::At(Point::new(0.97 * blank.length, 0.0))),
    ];
    for tool in &model.tools {
        match tool.role {
            Role::Punch => found.push(wide("Punch", extent(tool).1)),
            Role::Die => found.extend(throat(tool).map(|r| wide("Die throat", r))),
            Role::Holder => found.push(wide("Holder inner", extent(tool).0)),
        }
        found.extend(corners(tool));
        found.extend(load(model, tool));
    }
    if model.travel > 0.0
        && let Some(punch) = model.tool(Role::Punch)
    {
        let r = 0.25 * extent(punch).1.min(blank.length);
        found.push(of("Travel", model.travel, Unit::Mm, Mark::Along { r, from: 0.0, to: model.travel }));
    }
    found
}

fn of(label: &str, value: f64, unit: Unit, mark: Mark) -> Dimension {
    Dimension { label: label.to_owned(), value, unit, mark }
}

/// The radii of a tool's corners; of many the smallest.
fn corners(tool: &Tool) -> Vec<Dimension> {
    let mut arcs: Vec<Arc> = tool.profile.corners().collect();
    let name = match tool.role {
        Role::Punch => "Punch nose",
        Role::Die => "Die shoulder",
        Role::Holder => "Holder",
    };
    let label = if arcs.len() > CORNERS { format!("{name} least R") } else { format!("{name} R") };
    if arcs.len() > CORNERS {
        arcs.sort_by(|a, b| a.radius.total_cmp(&b.radius));
        arcs.truncate(1);
    }
    arcs.iter().map(|arc| of(&label, arc.radius, Unit::Mm, Mark::At(arc.at(0.5)))).collect()
}

/// What presses a holder, or how far it stands off.
fn load(model: &Model, tool: &Tool) -> Option<Dimension> {
    let half = 0.5 * model.blank.thickness;
    let at = Mark::At(Point::new(0.5 * (extent(tool).0 + model.blank.length), -half));
    match &tool.motion {
        Motion::Gap(gap) => Some(of("Holder gap", *gap, Unit::Mm, at)),
        Motion::Pressed(press) => Some(of("Holder force", press.force.largest(), model.extent().force_unit(), at)),
        Motion::Fixed | Motion::Travel | Motion::Path(_) => None,
    }
}
