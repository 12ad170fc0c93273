//! Lines, markers and areas, in a panel or as samples in the legend; polygons clipped at a window.

use super::*;
use kurbo::PathEl;
use plotters::element::{Circle, PathElement, Polygon};
use plotters::style::{Color as _, ShapeStyle};
use std::f64::consts::TAU;

const DOT: f64 = 2.6;
const CIRCLE: f64 = 5.0;
const TRIANGLE: f64 = 4.0;

type Points = [(f64, f64)];

pub(super) fn pen(color: Color, width: f64) -> ShapeStyle {
    rgb(color).stroke_width(units(width) as u32)
}

fn whole(points: &Points) -> Vec<(i32, i32)> {
    points.iter().map(|(x, y)| (units(*x), units(*y))).collect()
}

pub(super) fn line(canvas: &Canvas, points: &Points, color: Color, width: f64) {
    canvas.draw(&PathElement::new(whole(points), pen(color, width))).expect(IN_MEMORY);
}

pub(super) fn area(canvas: &Canvas, outline: &Points, fill: Color) {
    canvas.draw(&Polygon::new(whole(outline), rgb(fill))).expect(IN_MEMORY);
}

pub(super) fn dot(canvas: &Canvas, at: (f64, f64), radius: f64, color: Color) {
    canvas.draw(&Circle::new(whole(&[at])[0], units(radius), rgb(color).filled())).expect(IN_MEMORY);
}

pub(super) fn blank(canvas: &Canvas, from: (f64, f64), to: (f64, f64)) {
    area(canvas, &[from, (to.0, from.1), to, (from.0, to.1)], WHITE);
}

fn dashed(line: &Points, pattern: &[f64]) -> Vec<Vec<(f64, f64)>> {
    if pattern.is_empty() {
        return vec![line.to_vec()];
    }
    let begin = line.first().map(|&at| PathEl::MoveTo(at.into()));
    let path = begin.into_iter().chain(line.iter().skip(1).map(|&at| PathEl::LineTo(at.into())));
    let mut dashes: Vec<Vec<(f64, f64)>> = Vec::new();
    for element in kurbo::dash(path, 0.0, pattern) {
        match (element, dashes.last_mut()) {
            (PathEl::LineTo(at), Some(dash)) => dash.push(at.into()),
            (element, _) => dashes.push(element.end_point().into_iter().map(Into::into).collect()),
        }
    }
    dashes
}

pub(super) fn draw(canvas: &Canvas, style: Style, points: &Points) {
    match style {
        Style::Line { color, width, dash } => {
            dashed(points, dash).iter().for_each(|piece| line(canvas, piece, color, width));
        }
        Style::Circles { color } => {
            for at in points {
                dot(canvas, *at, CIRCLE, WHITE);
                canvas.draw(&Circle::new(whole(&[*at])[0], units(CIRCLE), pen(color, 2.2))).expect(IN_MEMORY);
            }
        }
        Style::Dots { color } => points.iter().for_each(|at| dot(canvas, *at, DOT, color)),
        Style::Triangles { color } => {
            let corner = |i: usize| (TAU * (i as f64 / 3.0 - 0.25)).sin_cos();
            for (x, y) in points {
                area(canvas, &[0, 1, 2].map(corner).map(|(sin, cos)| (x + TRIANGLE * cos, y + TRIANGLE * sin)), color);
            }
        }
        Style::Area { fill, edge } => {
            area(canvas, points, fill);
            if let Some(edge) = edge {
                line(canvas, &[points, &points[..1.min(points.len())]].concat(), edge, 0.8);
            }
        }
    }
}

pub(super) fn sample(canvas: &Canvas, style: Style, (x, y): (f64, f64), (width, half): (f64, f64)) {
    let points = match style {
        Style::Line { .. } => vec![(x, y), (x + width, y)],
        Style::Circles { .. } | Style::Dots { .. } | Style::Triangles { .. } => vec![(x + 0.5 * width, y)],
        Style::Area { .. } => vec![(x, y - half), (x + width, y - half), (x + width, y + half), (x, y + half)],
    };
    draw(canvas, style, &points);
}

/// Polygon clipped at a window; separate parts stay joined along the border.
///
/// Source: I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32–42.
pub(super) fn clipped(polygon: &[(f64, f64)], x: (f64, f64), y: (f64, f64)) -> Vec<(f64, f64)> {
    type Inside = fn((f64, f64), f64) -> f64;
    let sides: [(Inside, f64); 4] =
        [(|p, b| p.0 - b, x.0), (|p, b| b - p.0, x.1), (|p, b| p.1 - b, y.0), (|p, b| b - p.1, y.1)];
    let mut points = polygon.to_vec();
    for (inside, border) in sides {
        let mut kept = Vec::with_capacity(points.len() + 4);
        for (i, &to) in points.iter().enumerate() {
            let from = points[(i + points.len() - 1) % points.len()];
            let (a, b) = (inside(from, border), inside(to, border));
            if (a >= 0.0) != (b >= 0.0) {
                let f = a / (a - b);
                kept.push((from.0 + f * (to.0 - from.0), from.1 + f * (to.1 - from.1)));
            }
            if b >= 0.0 {
                kept.push(to);
            }
        }
        points = kept;
    }
    points
}

#[cfg(test)]
#[test]
fn polygons_are_clipped() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    assert_eq!(clipped(&square, (1.0, 9.0), (-5.0, 2.0)), [(1.0, 2.0), (1.0, 0.0), (4.0, 0.0), (4.0, 2.0)]);
    assert!(clipped(&square, (5.0, 9.0), (0.0, 1.0)).is_empty());
}
