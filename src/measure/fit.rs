//! Least-squares lines and circles through stretches of the meridian, weighted by length.

use crate::geometry::Point;
use nalgebra::{Matrix3, Vector3};

pub(super) struct Fit {
    /// Middle of the line, and its direction from the first point to the last.
    pub(super) middle: Point,
    pub(super) direction: Point,
    /// Curvature of the fitted circle \[1/mm\], positive to the left of the direction.
    pub(super) curvature: f64,
}

impl Fit {
    /// Fit; `None` with fewer than three points or coincident ones.
    pub(super) fn through(points: &[Point]) -> Option<Self> {
        let ([first, .., last], true) = (points, points.len() > 2) else { return None };
        let weights = weights(points);
        let total: f64 = weights.iter().sum();
        let middle = points.iter().zip(&weights).map(|(p, w)| *w * p).sum::<Point>() / total;
        let mut moments = [0.0; 3];
        for (p, w) in points.iter().zip(&weights) {
            let d = p - middle;
            moments[0] += w * d.x * d.x;
            moments[1] += w * d.x * d.y;
            moments[2] += w * d.y * d.y;
        }
        let angle = 0.5 * (2.0 * moments[1]).atan2(moments[0] - moments[2]);
        let mut direction = Point::new(angle.cos(), angle.sin());
        if direction.dot(&(last - first)) < 0.0 {
            direction = -direction;
        }
        let curvature = curvature(points, &weights, middle, direction)?;
        Some(Self { middle, direction, curvature })
    }
}

fn weights(points: &[Point]) -> Vec<f64> {
    let length = |i: usize| if i == 0 || i == points.len() { 0.0 } else { (points[i] - points[i - 1]).norm() };
    (0..points.len()).map(|i| 0.5 * (length(i) + length(i + 1))).collect()
}

/// The circle A (u² + v²) + B u + v + D = 0 with the least Σ w (left-hand side)², u along and v across the line, in
/// units of the stretch: linear in A, B and D, and a line where A = 0. Its curvature is −2A/√(1 + B² − 4AD).
fn curvature(points: &[Point], weights: &[f64], middle: Point, direction: Point) -> Option<f64> {
    let unit = (points[points.len() - 1] - points[0]).norm();
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (p, w) in points.iter().zip(weights) {
        let d = (p - middle) / unit;
        let (u, v) = (direction.dot(&d), direction.perp(&d));
        let row = Vector3::new(u * u + v * v, u, 1.0);
        matrix += *w * row * row.transpose();
        right -= *w * v * row;
    }
    let circle = matrix.lu().solve(&right)?;
    let (a, b, d) = (circle[0], circle[1], circle[2]);
    let curvature = 2.0 * a / (1.0 + b * b - 4.0 * a * d).sqrt() / unit;
    // v = −A u² − …: the left side of the direction is v > 0, and a curve that turns left has v'' = −2A > 0.
    Some(-curvature).filter(|k| k.is_finite())
}
