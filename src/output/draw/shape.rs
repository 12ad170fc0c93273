//! Lines, circles and areas, in a panel or as samples in the legend.

use super::text::{MARK, SPACING, text, text_width};
use super::{Canvas, FINE, NEVER, units};
use crate::output::chart::{BLACK, Color, Look};
use crate::output::outline::dashed;
use plotters::prelude::*;
use plotters::style::Color as _;

/// A series or a legend sample, points in units.
pub(super) fn draw_shape(canvas: &Canvas, look: Look, label: &str, points: &[(f64, f64)]) {
    let whole = |points: &[(f64, f64)]| -> Vec<(i32, i32)> {
        points.iter().map(|p| (p.0.round() as i32, p.1.round() as i32)).collect()
    };
    match look {
        Look::Line { color, width, dash } => {
            let pattern: Vec<f64> = dash.iter().map(|d| d * FINE).collect();
            for piece in dashed(points, &pattern) {
                canvas.draw(&PathElement::new(whole(&piece), stroke(color, width))).expect(NEVER);
            }
        }
        Look::Circles { color } => {
            for at in whole(points) {
                canvas.draw(&Circle::new(at, units(5.0), WHITE.filled())).expect(NEVER);
                canvas.draw(&Circle::new(at, units(5.0), stroke(color, 2.2))).expect(NEVER);
            }
        }
        Look::Area { fill, edge } => {
            let mut outline = whole(points);
            canvas.draw(&Polygon::new(outline.clone(), rgb(fill).filled())).expect(NEVER);
            if let Some(edge) = edge {
                outline.extend(outline.first().copied());
                canvas.draw(&PathElement::new(outline, stroke(edge, 0.8))).expect(NEVER);
            }
        }
        Look::Text => {
            let (width, half) = (text_width(label, MARK), 0.5 * SPACING * MARK);
            for &(x, y) in points {
                let (x, y) = (x / FINE, y / FINE);
                let corners = [(x - 2.0, y - half), (x + width + 2.0, y + half)].map(|(x, y)| (units(x), units(y)));
                canvas.draw(&Rectangle::new(corners, WHITE.filled())).expect(NEVER);
                text(canvas, label, MARK, BLACK, (x, y - 0.6 * MARK));
            }
        }
    }
}

/// What a series looks like, in the legend; `at` is the middle of its left end, `size` its width and half its height.
pub(super) fn sample(canvas: &Canvas, look: Look, at: (f64, f64), size: (f64, f64)) {
    let (x, y) = (at.0 * FINE, at.1 * FINE);
    let (w, h) = (size.0 * FINE, size.1 * FINE);
    let points = match look {
        Look::Line { .. } => vec![(x, y), (x + w, y)],
        Look::Circles { .. } => vec![(x + 0.5 * w, y)],
        Look::Area { .. } => {
            vec![(x, y - h), (x + w, y - h), (x + w, y + h), (x, y + h)]
        }
        Look::Text => Vec::new(),
    };
    draw_shape(canvas, look, "", &points);
}

pub(super) fn stroke(color: Color, width: f64) -> ShapeStyle {
    rgb(color).stroke_width(units(width) as u32)
}

pub(super) fn rgb(color: Color) -> RGBColor {
    RGBColor(color.0, color.1, color.2)
}
