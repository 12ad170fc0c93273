//! Custom section of a tool: drawn in steps, read from a file, or made from another tool; then placed.

use super::counter::Counter;
use super::drawn::{Drawn, Origin};
use super::points;
use super::tools::ToolContext;
use crate::case::file::{ProfileStep, Section, SectionTable, Turn};
use crate::case::{CaseError, source::Source};
use crate::geometry::{Arc, Piece, Point, Profile};
use crate::model::Role;
use crate::units::{Dimensioned, Length};

/// Largest move of an arc's centre onto the bisector of its ends \[mm\]: drawings are rounded.
const ROUNDED: f64 = 0.01;
/// Largest turn of one arc \[rad\]: half a circle, and round-off.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;

pub(super) fn convert(section: &Section, role: Role, context: &ToolContext) -> Result<Profile, CaseError> {
    let (path, source) = (format!("tools.{}.profile", role.name()), context.source);
    let alone = |kind: &str, others: &[&str]| {
        source.refuse(&path, others, &format!("does not go with `{kind}`"), "drop one of the two")
    };
    let counter = |of| Counter { role, of, path: path.clone(), context };
    let from_file = |file: &str, key: &str, fillet: Option<f64>| {
        let (profile, points) = points::convert(file, key, fillet, role, context)?;
        Ok::<_, CaseError>((profile, Origin::Points(points)))
    };
    let (profile, origin) = match section {
        Section::Steps(list) => (steps(list, &path, source)?, Origin::Steps),
        Section::File(file) => from_file(file, &path, None)?,
        Section::Table(SectionTable { file: Some(file), fillet, .. }) => {
            alone("file", &["offset_of", "by", "shoulder", "closed_at", "mirror_of"])?;
            from_file(file, &format!("{path}.file"), fillet.map(Dimensioned::value))?
        }
        Section::Table(table @ SectionTable { offset_of: Some(of), .. }) => {
            alone("offset_of", &["fillet", "mirror_of"])?;
            return counter(*of).offset(table);
        }
        Section::Table(SectionTable { mirror_of: Some(of), .. }) => {
            alone("mirror_of", &["fillet", "by", "shoulder", "closed_at"])?;
            return counter(*of).mirror();
        }
        Section::Table(_) => {
            let what = "the profile names neither a file nor a tool to make it from";
            let help =
                "write { file = \"die.csv\" }, { offset_of = \"punch\", by = \"1.2 mm\" } or { mirror_of = \"die\" }";
            return Err(source.error(&path, what, help));
        }
    };
    let drawn = Drawn { profile, path, origin };
    drawn.check_folds(role, source)?;
    drawn.placed(role, context).map(|(profile, _)| profile)
}

/// Lines and arcs of drawn steps.
fn steps(steps: &[ProfileStep], path: &str, source: &Source) -> Result<Profile, CaseError> {
    let mut pieces = Vec::new();
    let mut start = None;
    for (i, step) in steps.iter().enumerate() {
        let fail = |what: &str, help: &str| Err(source.error(&format!("{path}.{i}"), what, help));
        let ProfileStep { from, to, arc_to, center, turn } = *step;
        let end = match (i, from, to, arc_to) {
            (0, Some(first), None, None) => point(first),
            (0, ..) => return fail("a profile begins with its first point", "write { from = [\"0 mm\", \"0 mm\"] }"),
            (_, None, Some(end), None) | (_, None, None, Some(end)) => point(end),
            _ => {
                let help = "write { to = [..] } or { arc_to = [..], center = [..], turn = .. }";
                return fail("a step is either a line or an arc", help);
            }
        };
        if center.is_some() != arc_to.is_some() || turn.is_some() != arc_to.is_some() {
            let help = "write { arc_to = [..], center = [..], turn = \"right\" }";
            return fail("an arc has `arc_to`, `center` and `turn`", help);
        }
        if end.x < 0.0 {
            return fail("a point lies at negative r", "the section is drawn from the axis outward, r >= 0");
        }
        let Some(from) = start.replace(end) else { continue };
        if (end - from as Point).norm() < 1e-6 {
            return fail("a step has no length", "drop it");
        }
        let Some((center, turn)) = center.zip(turn) else {
            pieces.push(Piece::line(from, end));
            continue;
        };
        let (arc, moved) = Arc::between(from, end, point(center), turn == Turn::Left);
        if moved > ROUNDED {
            return fail("the ends of an arc are not equally far from its center", "check `center`");
        }
        if arc.sweep.abs() > HALF_TURN {
            let what = format!("an arc turns by {:.0}°, more than half a circle", arc.sweep.abs().to_degrees());
            return fail(&what, "check `turn`: it is seen with z upward; plots draw z downward");
        }
        pieces.push(Piece::Arc(arc));
    }
    Profile::new(pieces).map_err(|error| source.error(path, format!("profile: {error}"), "add steps"))
}

fn point([r, z]: [Length; 2]) -> Point {
    Point::new(r.value(), z.value())
}
