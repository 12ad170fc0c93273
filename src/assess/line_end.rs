//! Tools whose line ends where the sheet still bends over them.

use super::Finding;
use crate::model::{Model, Role, Tool};
use crate::table::Unit;
use crate::units::Amount;

/// Cosine of a lean to the axis that is none, to 2°: the sheet runs on along an upright wall where its line ends.
const UPRIGHT: f64 = 0.9994;

/// A punch or die whose line ends before the travel, on its way along the sheet: a tool acts only where it is drawn.
pub(super) fn passed(model: &Model, tool: &Tool) -> Option<Finding> {
    // Punches go up through the sheet; dies are passed by it on its way up.
    let (behind, whole) = match tool.role {
        Role::Punch => (-1.0, "its nose and its wall"),
        Role::Die => (1.0, "its shoulder and its wall"),
        Role::Holder => return None,
    };
    let face = tool.profile.extreme(tool.role == Role::Punch, model.blank.length)?.y;
    // With the sheet on its left a punch's line goes out from the axis, a die's in towards it: the last end is passed.
    let (at, away) = tool.profile.ends()[1]?;
    let depth = behind * (at.y - face);
    if at.x >= model.blank.length || depth >= model.travel || away.y.abs() >= UPRIGHT {
        return None;
    }
    let found = format!(
        "the {tool}'s line ends at r = {r}, z = {z} (as placed, z = 0 is the flat sheet's middle), {depth} of the {travel} of \
         travel behind its face: the sheet passes the end and bends over it as over a sharp edge",
        tool = tool.role.name(),
        r = Amount::size(at.x),
        z = Amount::size(at.y),
        depth = Amount::size(depth),
        travel = Amount::size(model.travel)
    );
    let to = face + behind * model.travel;
    Some(
        Finding::warning("line_end", "End of a tool", found)
            .against(depth, Unit::Mm, Amount::size(model.travel))
            .at_least(model.travel, None)
            .source("a tool acts only where it is drawn")
            .advice(format!("draw {whole} on to an upright wall, or as far as z = {to}", to = Amount::size(to))),
    )
}
