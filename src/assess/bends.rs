//! Bends: radii of tools and of the formed sheet over its thickness.

use super::*;
use crate::geometry::{CORNER, Point};
use crate::model::Theory;
use crate::rules::THIN;

pub(super) fn tool_radius(model: &Model, tool: &Tool) -> Option<Finding> {
    let smallest = tool.profile.corners().min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let why = match model.blank.theory {
        Theory::Bending => "beyond thin-shell theory",
        Theory::Membrane => "bending, which membrane theory leaves out, matters there",
    };
    let text = format!("the {}'s radius of {} is {{}}: {why}", model.name_of(tool.role), Amount::size(smallest.radius));
    let ratio = Amount::thicknesses(smallest.radius / model.blank.thickness);
    Finding::warning("tool_radius", "Tool radius", text).number(ratio).at_least(THIN, None).if_beyond()
}

pub(super) fn sharp_corner(model: &Model, tool: &Tool) -> Option<Finding> {
    let is_met = |at: Point| reaches(model, tool, at);
    let sharp: Vec<_> = tool.profile.vertices().filter(|v| v.turn.abs() > CORNER && is_met(v.point)).collect();
    let first = sharp.first()?;
    let others = if sharp.len() > 1 { format!(" and at {} more", sharp.len() - 1) } else { String::new() };
    let (name, [r, z]) = (model.name_of(tool.role), [first.point.x, first.point.y].map(Amount::size));
    let text = format!(
        "the {name}'s profile has a sharp corner, radius 0, of {{}} at r = {r}, z = {z} (as placed, z = 0 is the flat sheet's \
         middle){others}: no sheet can follow it"
    );
    let turn = Amount::angle(first.turn.abs().to_degrees()).to(Digits::Given(1));
    let warning = Finding::warning("sharp_corner", "Sharp corner", text).number(turn);
    let warning = warning.at_most(CORNER.to_degrees(), None).advice("draw an arc, or give `fillet`");
    Some(warning.source("the radius that a shell follows"))
}

fn reaches(model: &Model, tool: &Tool, at: Point) -> bool {
    let within_blank = at.x < model.blank.length;
    match tool.role {
        Role::Punch => {
            let top = tool.profile.extreme(true, model.blank.ends()).map_or(0.0, |top| top.y);
            within_blank && at.y > top - model.travel
        }
        // The sheet goes up and away from a holder's inner edge.
        Role::Holder => within_blank && at.x > extent(tool).0 + model.blank.thickness,
        _ => within_blank,
    }
}
