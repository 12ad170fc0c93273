//! A tool's section of its own: drawn, read from a file, or made from another tool; then placed.

use super::context::ToolContext;
use super::counter::Counter;
use super::drawn::{Drawn, Origin};
use super::{place, points, profile};
use crate::case::file::{Section, SectionTable};
use crate::case::{CaseError, source::Source};
use crate::geometry::Profile;
use crate::model::Role;
use crate::units::Dimensioned;

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
        Section::File(file) => {
            let (profile, points) = points::convert(file, &path, None, role, context, derived)?;
            Drawn { profile, path, origin: Origin::Points(points) }
        }
        Section::Table(table) => match kind(table, &path, context.source)? {
            Kind::Points(file) => {
                let fillet = table.fillet.map(Dimensioned::value);
                let (profile, points) = points::convert(file, &format!("{path}.file"), fillet, role, context, derived)?;
                Drawn { profile, path, origin: Origin::Points(points) }
            }
            Kind::Offset(of) => return Counter { role, of, path, context }.offset(table, derived),
            Kind::Mirror(of) => return Counter { role, of, path, context }.mirror(derived),
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
