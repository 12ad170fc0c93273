//! A tool's section of its own: drawn, read from a file, or made from another tool; then placed.

use super::points::{self, Points};
use super::tools::ToolContext;
use super::{counter, place, profile};
use crate::case::file::{Section, SectionTable};
use crate::case::{CaseError, source::Source};
use crate::geometry::{Fold, Point, Profile};
use crate::model::Role;
use crate::units::Quantity;

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

pub(super) fn convert(
    section: &Section,
    role: Role,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let path = format!("tools.{}.profile", role.name());
    let drawn = match section {
        Section::Steps(steps) => {
            Drawn { profile: profile::convert(steps, &path, context.source)?, path, origin: Origin::Steps }
        }
        Section::File(file) => points::convert(file, &path, None, role, context, derived)?,
        Section::Table(table) => match kind(table, &path, context.source)? {
            Kind::Points(file) => {
                let fillet = table.fillet.map(Quantity::value);
                points::convert(file, &format!("{path}.file"), fillet, role, context, derived)?
            }
            Kind::Offset(of) => return counter::offset(of, table, role, path, context, derived),
            Kind::Mirror(of) => return counter::mirror(of, role, path, context, derived),
        },
    };
    drawn.check_folds(role, context.source)?;
    place::place(drawn, role, context, derived).map(|placed| placed.profile)
}

enum Kind<'a> {
    Points(&'a str),
    Offset(Role),
    Mirror(Role),
}

/// What a table asks for: one thing, and only the keys that belong to it.
fn kind<'a>(table: &'a SectionTable, path: &str, source: &Source) -> Result<Kind<'a>, CaseError> {
    let written = [
        ("file", table.file.is_some()),
        ("fillet", table.fillet.is_some()),
        ("offset_of", table.offset_of.is_some()),
        ("by", table.by.is_some()),
        ("shoulder", table.shoulder.is_some()),
        ("closed_at", table.closed_at.is_some()),
        ("mirror_of", table.mirror_of.is_some()),
    ];
    let kinds: [(&str, &[&str]); 3] =
        [("file", &["fillet"]), ("offset_of", &["by", "shoulder", "closed_at"]), ("mirror_of", &[])];
    let asked =
        [table.file.as_deref().map(Kind::Points), table.offset_of.map(Kind::Offset), table.mirror_of.map(Kind::Mirror)];
    let Some(((first, theirs), kind)) = kinds.iter().zip(asked).find_map(|(key, kind)| Some((key, kind?))) else {
        let what = "the profile says neither what to read nor what to make it from";
        let help =
            "write { file = \"die.csv\" }, { offset_of = \"punch\", by = \"1.2 mm\" } or { mirror_of = \"die\" }";
        return Err(source.error(path, what, help));
    };
    if let Some((stray, _)) = written.iter().find(|(name, given)| *given && name != first && !theirs.contains(name)) {
        let what = format!("`{stray}` does not go with `{first}`");
        return Err(source.error(&format!("{path}.{stray}"), what, "drop one of the two"));
    }
    Ok(kind)
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

    fn check_folds(&self, role: Role, source: &Source) -> Result<(), CaseError> {
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

/// Coordinates in words.
pub(super) fn place_of(at: Point) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let round = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    format!("r = {} mm, z = {} mm", round(at.x), round(at.y))
}
