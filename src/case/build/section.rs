//! Custom section of a tool: drawn in steps, read from a file, or made from another tool; then placed.

use super::counter::Counter;
use super::drawn::{Drawn, Origin};
use super::points;
use super::tools::ToolContext;
use super::values::keys_present;
use crate::case::file::{ProfileStep, Section, SectionTable, Turn};
use crate::case::{CaseError, source::Source};
use crate::geometry::{Arc, Piece, Point, Profile, Segment};
use crate::model::Role;
use crate::units::{Dimensioned, Length};

/// Largest move of an arc's centre onto the bisector of its ends \[mm\]: drawings are rounded.
const ROUNDED: f64 = 0.01;
/// Largest turn of one arc \[rad\]: half a circle, and round-off.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;

pub(super) fn convert(section: &Section, role: Role, context: &ToolContext) -> Result<Profile, CaseError> {
    let path = format!("tools.{}.profile", role.name());
    let from_file = |file: &str, key: &str, fillet: Option<f64>| {
        let (profile, points) = points::convert(file, key, fillet, role, context)?;
        Ok::<_, CaseError>(Drawn { profile, path: path.clone(), origin: Origin::Points(points) })
    };
    let drawn = match section {
        Section::Steps(list) => {
            Drawn { profile: steps(list, &path, context.source)?, path: path.clone(), origin: Origin::Steps }
        }
        Section::File(file) => from_file(file, &path, None)?,
        Section::Table(table) => {
            check_keys(table, &path, context.source)?;
            let counter = |of| Counter { role, of, path: path.clone(), context };
            match table {
                SectionTable { file: Some(file), fillet, .. } => {
                    from_file(file, &format!("{path}.file"), fillet.map(Dimensioned::value))?
                }
                SectionTable { offset_of: Some(of), .. } => return counter(*of).offset(table),
                SectionTable { mirror_of: Some(of), .. } => return counter(*of).mirror(),
                _ => unreachable!("one of them is given"),
            }
        }
    };
    drawn.check_folds(role, context.source)?;
    drawn.placed(role, context).map(|placed| placed.profile)
}

/// Checks that a table asks for one thing, with only the keys that belong to it.
fn check_keys(table: &SectionTable, path: &str, source: &Source) -> Result<(), CaseError> {
    let written = keys_present([
        ("file", table.file.is_some()),
        ("fillet", table.fillet.is_some()),
        ("offset_of", table.offset_of.is_some()),
        ("by", table.by.is_some()),
        ("shoulder", table.shoulder.is_some()),
        ("closed_at", table.closed_at.is_some()),
        ("mirror_of", table.mirror_of.is_some()),
    ]);
    let kinds: [&[&str]; 3] = [&["file", "fillet"], &["offset_of", "by", "shoulder", "closed_at"], &["mirror_of"]];
    let Some(keys) = kinds.into_iter().find(|keys| written.contains(&keys[0])) else {
        let what = "the profile names neither a file nor a tool to make it from";
        let help =
            "write { file = \"die.csv\" }, { offset_of = \"punch\", by = \"1.2 mm\" } or { mirror_of = \"die\" }";
        return Err(source.error(path, what, help));
    };
    let Some(stray) = written.iter().find(|key| !keys.contains(key)) else { return Ok(()) };
    let what = format!("`{stray}` does not go with `{}`", keys[0]);
    Err(source.error(&format!("{path}.{stray}"), what, "drop one of the two"))
}

/// Lines and arcs of drawn steps.
fn steps(steps: &[ProfileStep], path: &str, source: &Source) -> Result<Profile, CaseError> {
    let mut pieces = Vec::new();
    let mut start = None;
    for (i, step) in steps.iter().enumerate() {
        let fail = |what: &str, help: &str| Err(source.error(&format!("{path}.{i}"), what, help));
        let end = match (step.from, step.to, step.arc_to, step.center, step.turn) {
            (Some(from), None, None, None, None) if i == 0 => point(from),
            (None, Some(to), None, None, None) if i > 0 => point(to),
            (None, None, Some(to), Some(_), Some(_)) if i > 0 => point(to),
            (None, None, Some(_), ..) if i > 0 => {
                let help = "write { arc_to = [..], center = [..], turn = \"right\" }";
                return fail("an arc needs `center` and `turn`", help);
            }
            _ if i == 0 => {
                return fail("a profile begins with its first point", "write { from = [\"0 mm\", \"0 mm\"] }");
            }
            _ => {
                let help = "write { to = [..] } or { arc_to = [..], center = [..], turn = .. }";
                return fail("a step is either a line or an arc", help);
            }
        };
        if end.x < 0.0 {
            return fail("a point lies at negative r", "the section is drawn from the axis outward, r >= 0");
        }
        let Some(from) = start.replace(end) else { continue };
        if (end - from as Point).norm() < 1e-6 {
            return fail("a step has no length", "drop it");
        }
        let Some((center, turn)) = step.center.zip(step.turn) else {
            pieces.push(Piece::Segment(Segment::new(from, end)));
            continue;
        };
        let (arc, moved) = Arc::between(from, end, point(center), turn == Turn::Left);
        if moved > ROUNDED {
            return fail("the ends of an arc are not equally far from its center", "check `center`");
        }
        if arc.sweep.abs() > HALF_TURN {
            let what = format!("an arc turns by {:.0}°, more than half a circle", arc.sweep.abs().to_degrees());
            return fail(
                &what,
                "check `turn`: it is seen with z upward, as plots, which draw z downward, do not show it",
            );
        }
        pieces.push(Piece::Arc(arc));
    }
    Profile::new(pieces).map_err(|error| source.error(path, format!("profile: {error}"), "add steps"))
}

fn point([r, z]: [Length; 2]) -> Point {
    Point::new(r.value(), z.value())
}
