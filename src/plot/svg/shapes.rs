//! Lines, markers and areas, in a panel or as samples in the legend.

use super::polygon::dashed;
use super::{Canvas, IN_MEMORY, px, rgb, units};
use crate::plot::chart::{Color, Style};
use crate::plot::palette::WHITE;
use plotters::element::{Drawable, PointCollection};
use plotters::style::{Color as _, ShapeStyle};
use plotters_backend::{BackendCoord, DrawingBackend, DrawingErrorKind};
use std::f64::consts::TAU;

/// Radius of a dot, of a circle, and of the circle about a triangle.
pub(super) const DOT: f64 = 2.6;
const CIRCLE: f64 = 5.0;
const TRIANGLE: f64 = 4.0;

/// Series or legend sample in the coordinates `C` of its area.
pub(super) struct Shape<C> {
    pub style: Style,
    pub points: Vec<C>,
}

impl<'a, C> PointCollection<'a, C> for &'a Shape<C> {
    type Point = &'a C;
    type IntoIter = std::slice::Iter<'a, C>;

    fn point_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl<C, B: DrawingBackend> Drawable<B> for Shape<C> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        points: I,
        backend: &mut B,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        let whole = |(x, y): (f64, f64)| (units(x), units(y));
        match self.style {
            Style::Line { color, width, dash } => {
                for piece in dashed(&points.map(px).collect::<Vec<_>>(), dash) {
                    backend.draw_path(piece.into_iter().map(whole), &pen(color, width))?;
                }
            }
            Style::Circles { color } => {
                for at in points {
                    backend.draw_circle(at, units(CIRCLE) as u32, &rgb(WHITE), true)?;
                    backend.draw_circle(at, units(CIRCLE) as u32, &pen(color, 2.2), false)?;
                }
            }
            Style::Dots { color } => {
                for at in points {
                    backend.draw_circle(at, units(DOT) as u32, &rgb(color), true)?;
                }
            }
            Style::Triangles { color } => {
                let corner = |i: usize| (TAU * (i as f64 / 3.0 - 0.25)).sin_cos();
                for (x, y) in points.map(px) {
                    let corners = (0..3).map(corner).map(|(sin, cos)| (x + TRIANGLE * cos, y + TRIANGLE * sin));
                    backend.fill_polygon(corners.map(whole), &rgb(color))?;
                }
            }
            Style::Area { fill, edge } => {
                let outline: Vec<_> = points.collect();
                backend.fill_polygon(outline.iter().copied(), &rgb(fill))?;
                if let Some(edge) = edge {
                    backend.draw_path(outline.iter().chain(outline.first()).copied(), &pen(edge, 0.8))?;
                }
            }
        }
        Ok(())
    }
}

/// Draws a legend sample; `at` is the middle of its left end, `width` and `half` its width and half its height.
pub(super) fn sample(canvas: &Canvas, style: Style, (x, y): (f64, f64), (width, half): (f64, f64)) {
    let points = match style {
        Style::Line { .. } => vec![(x, y), (x + width, y)],
        Style::Circles { .. } | Style::Dots { .. } | Style::Triangles { .. } => vec![(x + 0.5 * width, y)],
        Style::Area { .. } => vec![(x, y - half), (x + width, y - half), (x + width, y + half), (x, y + half)],
    };
    let points = points.into_iter().map(|(x, y)| (units(x), units(y))).collect();
    canvas.draw(&Shape { style, points }).expect(IN_MEMORY);
}

/// Stroke of a line.
pub(super) fn pen(color: Color, width: f64) -> ShapeStyle {
    rgb(color).stroke_width(units(width) as u32)
}
