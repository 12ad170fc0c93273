//! A drawn tool section: steps → pieces, moved along z until it touches the flat sheet.

use super::tools::Sheet;
use crate::case::file::{ProfileStep, Turn};
use crate::case::{CaseError, source::Source};
use crate::geometry::{Arc, Piece, Point, Profile, Segment};
use crate::model::Role;
use crate::quantity::{Length, Quantity};
use std::f64::consts::TAU;

/// How far the centre of an arc may lie from where its ends want it [mm]: drawings are rounded.
const ROUNDED: f64 = 0.01;

pub(super) fn convert(
    steps: &[ProfileStep],
    role: Role,
    sheet: &Sheet,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let path = format!("tools.{}.profile", role.name());
    let fail = |i: usize, what: &str, help: &str| Err(source.error(&format!("{path}.{i}"), what, help));
    let mut pieces = Vec::new();
    let mut here = None;
    for (i, step) in steps.iter().enumerate() {
        let end = match (step.from, step.to, step.arc_to, step.center, step.turn) {
            (Some(from), None, None, None, None) if i == 0 => point(from),
            (None, Some(to), None, None, None) if i > 0 => point(to),
            (None, None, Some(to), Some(_), Some(_)) if i > 0 => point(to),
            (None, None, Some(_), ..) if i > 0 => {
                return fail(
                    i,
                    "an arc needs `center` and `turn`",
                    "write { arc_to = [..], center = [..], turn = \"right\" }",
                );
            }
            _ if i == 0 => {
                return fail(0, "a profile begins with its first point", "write { from = [\"0 mm\", \"0 mm\"] }");
            }
            _ => {
                return fail(
                    i,
                    "a step is either a line or an arc",
                    "write { to = [..] } or { arc_to = [..], center = [..], turn = .. }",
                );
            }
        };
        if end.x < 0.0 {
            return fail(i, "a point lies at negative r", "the section is drawn from the axis outward, r >= 0");
        }
        if let Some(start) = here {
            if (end - start as Point).norm() < 1e-6 {
                return fail(i, "a step has no length", "drop it");
            }
            match (step.center, step.turn) {
                (Some(center), Some(turn)) => match arc(start, end, point(center), turn) {
                    Some(arc) if arc.sweep.abs() > HALF_TURN => {
                        return fail(
                            i,
                            &format!("an arc turns by {:.0}°, more than half a circle", arc.sweep.abs().to_degrees()),
                            "check `turn`: it is seen with z upward, as plots, which draw z downward, do not show it",
                        );
                    }
                    Some(arc) => pieces.push(Piece::Arc(arc)),
                    None => return fail(i, "the ends of an arc are not equally far from its center", "check `center`"),
                },
                _ => pieces.push(Piece::Segment(Segment::new(start, end))),
            }
        }
        here = Some(end);
    }
    let drawn = Profile::new(pieces).map_err(|error| source.error(&path, format!("profile: {error}"), "add steps"))?;
    place(drawn, role, sheet, &path, source, derived)
}

/// The most that one arc of a tool turns \[rad\]: half a circle, and round-off.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;

fn point([r, z]: [Length; 2]) -> Point {
    Point::new(r.value(), z.value())
}

/// The arc between two points; the given centre is moved onto their bisector.
fn arc(start: Point, end: Point, center: Point, turn: Turn) -> Option<Arc> {
    let (middle, chord) = (0.5 * (start + end), (end - start).normalize());
    let off = (center - middle).dot(&chord);
    let center = center - off * chord;
    let radius = (start - center).norm();
    if off.abs() > ROUNDED {
        return None;
    }
    let angle = |p: Point| (p.y - center.y).atan2(p.x - center.x);
    let sweep = match turn {
        Turn::Left => (angle(end) - angle(start)).rem_euclid(TAU),
        Turn::Right => -(angle(start) - angle(end)).rem_euclid(TAU),
    };
    Some(Arc::new(center, radius, angle(start), sweep))
}

/// Moves a profile along z until it touches the sheet, and checks that it has the sheet on its left.
fn place(
    drawn: Profile,
    role: Role,
    sheet: &Sheet,
    path: &str,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let above = role == Role::Die;
    let side = if above { 1.0 } else { -1.0 };
    let under_sheet = drawn.polyline(1e-3).into_iter().filter(|p| p.x <= sheet.length);
    let Some(first) = under_sheet.min_by(|a, b| (side * a.y).total_cmp(&(side * b.y))) else {
        let what = format!("the {} lies beyond the blank's edge at {} mm", role.name(), sheet.length);
        return Err(source.error(path, what, "check the r coordinates and the size of the blank"));
    };
    let shift = side * 0.5 * sheet.thickness - first.y;
    if shift.abs() > 1e-6 {
        derived
            .push(format!("the {}'s profile is moved by {shift:+.4} mm along z to touch the flat sheet", role.name()));
    }
    let move_up = |p: Point| p + Point::new(0.0, shift);
    let pieces = drawn.pieces().iter().map(|piece| match piece {
        Piece::Segment(s) => Piece::Segment(Segment::new(move_up(s.from), move_up(s.to))),
        Piece::Arc(a) => Piece::Arc(Arc::new(move_up(a.center), a.radius, a.start, a.sweep)),
    });
    let placed = Profile::new(pieces.collect()).expect("a moved chain stays connected");
    if placed.closest(Point::new(first.x, 0.0)).distance < 0.0 {
        let what = format!("the {}'s profile has the sheet on its right", role.name());
        return Err(source.error(path, what, "list the points the other way round: the sheet lies on the left"));
    }
    Ok(placed)
}
