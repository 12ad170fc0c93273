//! Lines, circles and areas, in a panel or as samples in the legend.

use super::backend::{px, units};
use super::canvas::{Canvas, NEVER, rgb};
use super::letters::{CALLOUT, MARK, SPACING, text_width};
use super::mark::Point;
use super::text::style;

use crate::plot::chart::{BLACK, Color, Look, WHITE};
use crate::plot::outline::{dashed, hatched};
use plotters::element::{Drawable, PointCollection};
use plotters::style::ShapeStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters_backend::{BackendCoord, DrawingBackend, DrawingErrorKind};
use std::f64::consts::TAU;

/// Radius of a dot, and of the circle about a triangle of the same area.
pub(super) const DOT: f64 = 2.6;
const TRIANGLE: f64 = 4.0;
/// Between the lines of a hatched area, and their width.
const HATCH: f64 = 9.0;
const HATCH_LINE: f64 = 1.0;
/// Radii of a callout's dot and of the white about it: it is seen before all else, on every colour and in grey print.
const CALLOUT_DOT: f64 = 7.0;
const CALLOUT_EDGE: f64 = 10.5;

/// A series or a legend sample, as plotters draws it wherever the points come to lie.
pub(super) struct Shape<'a, C> {
    pub look: Look,
    pub label: &'a str,
    pub points: Vec<C>,
}

impl<'a, C> PointCollection<'a, C> for &'a Shape<'_, C> {
    type Point = &'a C;
    type IntoIter = std::slice::Iter<'a, C>;

    fn point_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl<C, B: DrawingBackend> Drawable<B> for Shape<'_, C> {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        points: I,
        backend: &mut B,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        let whole = |(x, y): (f64, f64)| (units(x), units(y));
        match self.look {
            Look::Line { color, width, dash } => {
                for piece in dashed(&points.map(px).collect::<Vec<_>>(), dash) {
                    backend.draw_path(piece.into_iter().map(whole), &stroke(color, width))?;
                }
            }
            Look::Circles { color } => {
                for at in points {
                    backend.draw_circle(at, units(5.0) as u32, &stroke(color, 2.2), false)?;
                }
            }
            Look::Dots { color } => {
                for at in points {
                    backend.draw_circle(at, units(DOT) as u32, &rgb(color), true)?;
                }
            }
            Look::Triangles { color } => {
                let corner = |i: usize| (TAU * (i as f64 / 3.0 - 0.25)).sin_cos();
                for (x, y) in points.map(px) {
                    let corners = (0..3).map(corner).map(|(sin, cos)| (x + TRIANGLE * cos, y + TRIANGLE * sin));
                    backend.fill_polygon(corners.map(whole), &rgb(color))?;
                }
            }
            Look::Area { fill, edge } => {
                let outline: Vec<_> = points.collect();
                backend.fill_polygon(outline.iter().copied(), &rgb(fill))?;
                if let Some(edge) = edge {
                    let around = outline.iter().chain(outline.first()).copied();
                    backend.draw_path(around, &stroke(edge, 0.8))?;
                }
            }
            Look::Hatched { fill, line, rise } => {
                let outline: Vec<_> = points.collect();
                if let Some(fill) = fill {
                    backend.fill_polygon(outline.iter().copied(), &rgb(fill))?;
                }
                for stroke_of in hatched(&outline.into_iter().map(px).collect::<Vec<_>>(), rise, HATCH) {
                    backend.draw_path(stroke_of.map(whole), &stroke(line, HATCH_LINE))?;
                }
            }
            // Where they stand follows from all of them: the panel draws them.
            Look::Flag => {}
            Look::Text | Look::Before | Look::Name => {
                let (width, half) = (text_width(self.label, MARK), 0.5 * SPACING * MARK);
                let style = style(MARK, BLACK).pos(Pos::new(HPos::Left, VPos::Top));
                let before = match self.look {
                    Look::Name => 0.5 * width,
                    Look::Before => width,
                    _ => 0.0,
                };
                for (x, y) in points.map(px).map(|(x, y)| (x - before, y)) {
                    let (from, to) = ((x - 2.0, y - half), (x + width + 2.0, y + half));
                    backend.draw_rect(whole(from), whole(to), &rgb(WHITE), true)?;
                    backend.draw_text(self.label, &style, whole((x, y - 0.6 * MARK)))?;
                }
            }
            Look::Callout => {
                let points: Vec<Point> = points.map(px).collect();
                let [at, (x, y)] = points[..] else { return Ok(()) };
                backend.draw_path([whole(at), whole((x, y))], &stroke(BLACK, 1.4))?;
                backend.draw_circle(whole(at), units(CALLOUT_EDGE) as u32, &rgb(WHITE), true)?;
                backend.draw_circle(whole(at), units(CALLOUT_DOT) as u32, &rgb(BLACK), true)?;
                let (half, high) = (0.5 * text_width(self.label, CALLOUT) + 3.0, 0.5 * SPACING * CALLOUT);
                backend.draw_rect(whole((x - half, y - high)), whole((x + half, y + high)), &rgb(WHITE), true)?;
                let style = style(CALLOUT, BLACK).pos(Pos::new(HPos::Center, VPos::Center));
                backend.draw_text(self.label, &style, whole((x, y)))?;
            }
        }
        Ok(())
    }
}

/// What a series looks like, in the legend; `at` is the middle of its left end, `size` its width and half its height.
pub(super) fn sample(canvas: &Canvas, look: Look, at: (f64, f64), size: (f64, f64)) {
    let ((x, y), (w, h)) = (at, size);
    let points = match look {
        Look::Line { .. } => vec![(x, y), (x + w, y)],
        Look::Circles { .. } | Look::Dots { .. } | Look::Triangles { .. } => vec![(x + 0.5 * w, y)],
        Look::Area { .. } | Look::Hatched { .. } => vec![(x, y - h), (x + w, y - h), (x + w, y + h), (x, y + h)],
        Look::Text | Look::Before | Look::Name | Look::Flag | Look::Callout => Vec::new(),
    };
    let points = points.into_iter().map(|(x, y)| (units(x), units(y))).collect();
    canvas.draw(&Shape { look, label: "", points }).expect(NEVER);
}

pub(super) fn stroke(color: Color, width: f64) -> ShapeStyle {
    ShapeStyle::from(rgb(color)).stroke_width(units(width) as u32)
}
