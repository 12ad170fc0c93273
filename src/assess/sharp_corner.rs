//! Corners without a radius where the sheet meets them.

use super::Finding;
use crate::geometry::{CORNER, Point};
use crate::model::tool_sizes::extent;
use crate::model::{Model, Role, Tool};
use crate::table::Unit;
use crate::units::{Amount, Digits};

/// A tool with a sharp corner in the sheet's reach.
pub(super) fn met(model: &Model, tool: &Tool) -> Option<Finding> {
    let sharp: Vec<_> =
        tool.profile.vertices().filter(|v| v.turn.abs() > CORNER && meets(model, tool, v.point)).collect();
    let first = sharp.first()?;
    let others = match sharp.len() {
        1 => String::new(),
        n => format!(" and at {n} more", n = n - 1),
    };
    let turn = first.turn.abs().to_degrees();
    let found = format!(
        "the {tool}'s profile has a sharp corner, radius 0, of {turn} at r = {r}, z = {z} (as placed, z = 0 is the flat sheet's \
         middle){others}: no sheet can follow it",
        tool = tool.role.name(),
        turn = Amount::angle(turn).to(Digits::Given(1)),
        r = Amount::size(first.point.x),
        z = Amount::size(first.point.y)
    );
    Some(
        Finding::warning("sharp_corner", "Sharp corner", found)
            .against(turn, Unit::Degree, Amount::angle(CORNER.to_degrees()).to(Digits::Given(1)))
            .at_most(CORNER.to_degrees(), None)
            .advice("draw an arc, or give `fillet`")
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
