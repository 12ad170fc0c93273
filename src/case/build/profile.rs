//! A drawn tool section: steps → pieces.

use crate::case::file::{ProfileStep, Turn};
use crate::case::{CaseError, source::Source};
use crate::geometry::{Arc, Piece, Point, Profile, Segment};
use crate::units::{Dimensioned, Length};

/// How far the centre of an arc may lie from where its ends want it [mm]: drawings are rounded.
const ROUNDED: f64 = 0.01;

pub(super) fn convert(steps: &[ProfileStep], path: &str, source: &Source) -> Result<Profile, CaseError> {
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
    Profile::new(pieces).map_err(|error| source.error(path, format!("profile: {error}"), "add steps"))
}

/// The most that one arc of a tool turns \[rad\]: half a circle, and round-off.
const HALF_TURN: f64 = std::f64::consts::PI + 1e-6;

fn point([r, z]: [Length; 2]) -> Point {
    Point::new(r.value(), z.value())
}

/// The arc between two points; the given centre is moved onto their bisector.
fn arc(start: Point, end: Point, center: Point, turn: Turn) -> Option<Arc> {
    let (arc, moved) = Arc::between(start, end, center, turn == Turn::Left);
    (moved <= ROUNDED).then_some(arc)
}
