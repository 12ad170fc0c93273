//! A drawn section, moved along z to where it touches the flat sheet, the sheet on its left.

use super::context::ToolContext;
use super::drawn::Drawn;
use super::values::place_of;
use crate::case::CaseError;
use crate::geometry::{Point, Profile};
use crate::model::Role;
use crate::units::Amount;

/// Places along the flat sheet that are looked at.
const LOOKS: usize = 400;

/// A tool's section in its place.
pub(super) struct Placed {
    pub profile: Profile,
    /// How far it was moved along z \[mm\].
    pub shift: f64,
}

pub(super) fn place(
    drawn: Drawn,
    role: Role,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Placed, CaseError> {
    let (sheet, name) = (&context.sheet, role.name());
    // The die lies above the sheet, the others below.
    let side = if role == Role::Die { 1.0 } else { -1.0 };
    let Some(first) = drawn.profile.extreme(side < 0.0, sheet.length) else {
        let what = format!("the {name} lies beyond the blank's edge at {} mm", sheet.length);
        return Err(context.source.error(&drawn.path, what, "check the r coordinates and the size of the blank"));
    };
    let shift = side * 0.5 * sheet.thickness - first.y;
    if shift.abs() > 1e-6 {
        let shift = Amount::size(shift);
        derived.push(format!("the {name}'s profile is moved by {shift} along z to touch the flat sheet"));
    }
    let profile = drawn.profile.shifted(shift);
    if let Some(r) = sheet_inside(&profile, sheet.length) {
        let what = format!("the {name}'s profile has the sheet on its right, inside the tool, at r = {r:.3} mm");
        let help = match sheet_inside(&profile.reversed(), sheet.length) {
            None => "list the points the other way round: the sheet lies on the left",
            Some(_) => "the sheet lies on the left all along: check the order of the points there",
        };
        let place = Point::new(r, -shift);
        return Err(drawn.error(place, context.source, what, help));
    }
    if let Some(at) = wall_into_sheet(&drawn.profile, side, sheet.length) {
        let (towards, away) = if side > 0.0 { ("down", "up") } else { ("up", "down") };
        let what = format!("the {name}'s profile ends on its way {towards} to the sheet, at {}", place_of(at));
        let help = format!("a {name}'s walls go {away}, away from the sheet: check the sign of z");
        return Err(drawn.error(at, context.source, what, help));
    }
    Ok(Placed { profile, shift })
}

/// The first r where the middle of the flat sheet lies on the tool's side of a profile \[mm\].
fn sheet_inside(profile: &Profile, length: f64) -> Option<f64> {
    (0..=LOOKS).map(|i| length * i as f64 / LOOKS as f64).find(|r| profile.closest(Point::new(*r, 0.0)).distance < 0.0)
}

/// An end of the line below the blank (for a die: above) that runs steeply towards it.
fn wall_into_sheet(profile: &Profile, side: f64, length: f64) -> Option<Point> {
    // Steeper than 45°: an undrawn outline could hardly turn away again.
    let into = |(at, away): &(Point, Point)| at.x < length && -side * away.y > 0.7;
    profile.ends().into_iter().flatten().find(into).map(|(at, _)| at)
}
