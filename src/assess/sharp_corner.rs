//! Corners without a radius where the sheet meets them.

use super::Finding;
use crate::geometry::{CORNER, Point};
use crate::model::{Model, Role, Tool};
use crate::rules::tool_sizes::extent;
use crate::table::Unit;
use crate::units::mm;

/// A tool with a sharp corner in the sheet's reach.
pub(super) fn met(model: &Model, tool: &Tool) -> Option<Finding> {
    let sharp: Vec<_> =
        tool.profile.vertices().filter(|v| v.turn.abs() > CORNER && meets(model, tool, v.point)).collect();
    let first = sharp.first()?;
    let others = match sharp.len() {
        1 => String::new(),
        n => format!(" and at {} more", n - 1),
    };
    let found = format!(
        "the {}'s profile has a sharp corner, radius 0, of {:.0}° at r = {} mm, z = {} mm (as placed, z = 0 is the flat sheet's \
         middle){others}: no shell can follow it; draw an arc, or give `fillet`",
        tool.role.name(),
        first.turn.abs().to_degrees(),
        mm(first.point.x),
        mm(first.point.y)
    );
    Some(
        Finding::warning("sharp_corner", "Sharp corner", found)
            .against(first.turn.abs().to_degrees(), Unit::Degree, format!("{:.0}°", CORNER.to_degrees()))
            .source("the radius that a shell follows"),
    )
}

/// Whether the sheet can come to a point of a tool.
fn meets(model: &Model, tool: &Tool, at: Point) -> bool {
    let within_blank = at.x < model.blank.length;
    match tool.role {
        // What lies deeper than the travel stays below the sheet.
        Role::Punch => {
            let top = tool.profile.extreme(true, model.blank.length).map_or(0.0, |top| top.y);
            within_blank && at.y > top - model.travel
        }
        Role::Die => within_blank,
        // The sheet goes up and away from a holder's inner edge.
        Role::Holder => within_blank && at.x > extent(tool).0 + model.blank.thickness,
    }
}
