//! Lines, circles and areas, in a panel or as samples in the legend.

use super::text::{MARK, SPACING, text, text_width};
use super::{Mark, Point};
use crate::output::chart::{BLACK, Look, WHITE};
use crate::output::outline::dashed;

/// A series or a legend sample.
pub(super) fn draw_shape(marks: &mut Vec<Mark>, look: Look, label: &str, points: Vec<Point>) {
    match look {
        Look::Line { color, width, dash } => marks.push(Mark::Line { pieces: dashed(&points, dash), color, width }),
        Look::Circles { color } => {
            marks.extend(points.into_iter().map(|at| Mark::Circle { at, radius: 5.0, color, width: 2.2 }));
        }
        Look::Area { fill, edge } => {
            let closed = edge.map(|color| {
                let around = points.iter().chain(points.first()).copied().collect();
                Mark::Line { pieces: vec![around], color, width: 0.8 }
            });
            marks.push(Mark::Area { outline: points, fill });
            marks.extend(closed);
        }
        Look::Text => {
            let (width, half) = (text_width(label, MARK), 0.5 * SPACING * MARK);
            for (x, y) in points {
                marks.push(Mark::Area {
                    outline: rectangle((x - 2.0, y - half), (x + width + 2.0, y + half)),
                    fill: WHITE,
                });
                marks.push(text(label, MARK, BLACK, (x, y - 0.6 * MARK)));
            }
        }
    }
}

/// What a series looks like, in the legend; `at` is the middle of its left end, `size` its width and half its height.
pub(super) fn sample(marks: &mut Vec<Mark>, look: Look, at: Point, size: (f64, f64)) {
    let ((x, y), (w, h)) = (at, size);
    let points = match look {
        Look::Line { .. } => vec![(x, y), (x + w, y)],
        Look::Circles { .. } => vec![(x + 0.5 * w, y)],
        Look::Area { .. } => rectangle((x, y - h), (x + w, y + h)),
        Look::Text => Vec::new(),
    };
    draw_shape(marks, look, "", points);
}

/// The corners of a rectangle between two opposite ones.
pub(super) fn rectangle(from: Point, to: Point) -> Vec<Point> {
    vec![from, (to.0, from.1), to, (from.0, to.1)]
}
