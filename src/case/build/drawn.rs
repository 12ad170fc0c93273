//! Section as it was drawn: checks, with errors where the part was written, and placing against the flat sheet.

use super::points::Points;
use super::tools::ToolContext;
use super::values::place_of;
use crate::case::{CaseError, source::Source};
use crate::geometry::{Fold, Point, Profile};
use crate::model::Role;
use crate::units::Amount;

/// Checked places along the flat sheet.
const PLACES: usize = 400;

/// Section before it is placed.
pub(super) struct Drawn {
    pub profile: Profile,
    /// Key path in the case.
    pub path: String,
    pub origin: Origin,
}

/// Origin of a section.
pub(super) enum Origin {
    /// Piece i is step i + 1.
    Steps,
    Points(Points),
    /// Made from another tool.
    Tool,
}

impl Drawn {
    /// Chain as it was written: for a file the chords between its points.
    fn written(&self) -> &Profile {
        match &self.origin {
            Origin::Points(points) => &points.chords,
            _ => &self.profile,
        }
    }

    /// Error about a piece of the section, shown where it was written.
    fn error(&self, piece: usize, source: &Source, what: String, help: impl Into<String>) -> CaseError {
        match &self.origin {
            Origin::Steps => source.error(&format!("{}.{}", self.path, piece + 1), what, help),
            Origin::Points(points) => points.error(piece + 1, what, help),
            Origin::Tool => source.error(&self.path, what, help),
        }
    }

    /// Refuses a chain that turns back on itself or crosses itself.
    pub fn check_folds(&self, role: Role, source: &Source) -> Result<(), CaseError> {
        let (name, help) =
            (role.name(), "the section is one open line along the side that meets the sheet, not a closed outline");
        let end_name = |piece: usize| match &self.origin {
            Origin::Points(points) => format!("line {}", points.lines[piece + 1]),
            _ => format!("step {}", piece + 1),
        };
        match self.written().fold() {
            None => Ok(()),
            Some(Fold::Back { at, after, turn }) => {
                let (at, turn) = (place_of(at), turn.abs().to_degrees());
                let what = format!("the {name}'s profile turns back on itself at {at}: by {turn:.0}°");
                Err(self.error(after, source, what, "drop the point, or round the tip off"))
            }
            Some(Fold::Crossing { at, pieces: [i, j] }) => {
                let (at, first, second) = (place_of(at), end_name(i), end_name(j));
                let what = format!(
                    "the {name}'s profile crosses or touches itself at {at}: the pieces to {first} and to {second}"
                );
                Err(self.error(j, source, what, help))
            }
        }
    }

    /// Section where it touches the flat sheet, the sheet on its left, and its move along z \[mm\].
    pub fn placed(self, role: Role, context: &ToolContext) -> Result<(Profile, f64), CaseError> {
        let (length, name, source) = (context.sheet.length, role.name(), context.source);
        // The die lies above the sheet, the others below.
        let side = if role == Role::Die { 1.0 } else { -1.0 };
        let Some(first) = self.profile.extreme(side < 0.0, length) else {
            let what = format!("the {name} lies beyond the blank's edge at {length} mm");
            return Err(source.error(&self.path, what, "check the r coordinates and the size of the blank"));
        };
        let shift = side * 0.5 * context.sheet.thickness - first.y;
        if shift.abs() > 1e-6 {
            let by = Amount::size(shift);
            source.note(format!("the {name}'s profile is moved by {by} along z to touch the flat sheet"));
        }
        let profile = self.profile.shifted(shift);
        let piece_at = |at: Point| self.written().closest(at).piece;
        // First r at which the middle of the flat sheet lies on the tool's side.
        let sheet_inside = |profile: &Profile| {
            let mut places = (0..=PLACES).map(|i| length * i as f64 / PLACES as f64);
            places.find(|r| profile.closest(Point::new(*r, 0.0)).distance < 0.0)
        };
        if let Some(r) = sheet_inside(&profile) {
            let what = format!("the {name}'s profile has the sheet on its right, inside the tool, at r = {r:.3} mm");
            let help = match sheet_inside(&profile.reversed()) {
                None => "list the points the other way round: the sheet lies on the left",
                Some(_) => "the sheet lies on the left all along: check the order of the points there",
            };
            return Err(self.error(piece_at(Point::new(r, -shift)), source, what, help));
        }
        // Steeper than 45°: an undrawn outline could hardly turn away again.
        let into_sheet = |(at, away): &(Point, Point)| at.x < length && -side * away.y > 0.7;
        if let Some((at, _)) = self.profile.ends().into_iter().flatten().find(into_sheet) {
            let (towards, away) = if side > 0.0 { ("down", "up") } else { ("up", "down") };
            let what = format!("the {name}'s profile ends on its way {towards} to the sheet, at {}", place_of(at));
            let help = format!("a {name}'s walls go {away}, away from the sheet: check the sign of z");
            return Err(self.error(piece_at(at), source, what, help));
        }
        Ok((profile, shift))
    }
}
