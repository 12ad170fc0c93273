//! A section as it was drawn, with where each part was written.

use super::points::Points;
use super::values::place_of;
use crate::case::{CaseError, source::Source};
use crate::geometry::{Fold, Point, Profile};
use crate::model::Role;

/// A section before it is placed, and where its parts were written.
pub(super) struct Drawn {
    pub profile: Profile,
    /// Key path in the case.
    pub path: String,
    pub origin: Origin,
}

/// Where a section comes from.
pub(super) enum Origin {
    /// Piece i is step i + 1.
    Steps,
    Points(Points),
    /// Made from another tool.
    Tool,
}

impl Drawn {
    /// The chain as it was written: of a file the chords between its points.
    fn written(&self) -> &Profile {
        match &self.origin {
            Origin::Points(points) => &points.chords,
            _ => &self.profile,
        }
    }

    /// An error about a place of the section \[mm\], shown where that part was written.
    pub fn error(&self, at: Point, source: &Source, what: String, help: impl Into<String>) -> CaseError {
        self.error_of(self.written().closest(at).piece, source, what, help)
    }

    fn error_of(&self, piece: usize, source: &Source, what: String, help: impl Into<String>) -> CaseError {
        match &self.origin {
            Origin::Steps => source.error(&format!("{}.{}", self.path, piece + 1), what, help),
            Origin::Points(points) => points.error(piece + 1, what, help),
            Origin::Tool => source.error(&self.path, what, help),
        }
    }

    /// The word for the end of a piece in the text it was written in.
    fn word(&self, piece: usize) -> String {
        match &self.origin {
            Origin::Points(points) => format!("line {}", points.lines[piece + 1]),
            _ => format!("step {}", piece + 1),
        }
    }

    /// Refuses a chain that turns back on itself or crosses itself.
    pub fn check_folds(&self, role: Role, source: &Source) -> Result<(), CaseError> {
        let name = role.name();
        match self.written().fold() {
            Some(Fold::Back { at, after, turn }) => {
                let what = format!(
                    "the {name}'s profile turns back on itself at {}: by {:.0}°",
                    place_of(at),
                    turn.abs().to_degrees()
                );
                Err(self.error_of(after, source, what, "drop the point, or round the tip off"))
            }
            Some(Fold::Crossing { at, pieces: [i, j] }) => {
                let what = format!(
                    "the {name}'s profile crosses or touches itself at {}: the pieces to {} and to {}",
                    place_of(at),
                    self.word(i),
                    self.word(j)
                );
                let help = "the section is one open line along the side that meets the sheet, not a closed outline";
                Err(self.error_of(j, source, what, help))
            }
            None => Ok(()),
        }
    }
}
