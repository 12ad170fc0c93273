//! Rational B-splines as chains of tangent arcs.
//!
//! Source: C. de Boor, J. Approx. Theory 6 (1972) 50–62 (the algorithm, as commonly given; not read).

use super::dxf::{Entity, MOST};
use crate::geometry::{Piece, Point, biarc, turn};
use nalgebra::Vector3;

const DEEPEST: usize = 12;
/// Largest turn of the ends of a biarc from their chord \[rad\].
const TURN: f64 = 0.5;
const POINTS: usize = 16;
/// Share of the tolerance at those points \[–\]; between them the distance may rise.
const BETWEEN: f64 = 0.9;
const DEGREE: usize = 25;
/// Largest distance of coinciding points \[mm\].
const COINCIDENT: f64 = 1e-9;

struct Curve {
    degree: usize,
    knots: Vec<f64>,
    control: Vec<Vector3<f64>>,
    /// \[mm\]
    tolerance: f64,
}

/// Arcs within `tolerance` of a spline through control points \[mm\], with its ends and tangents.
pub(super) fn pieces(entity: &Entity, control: &[Point], tolerance: f64) -> Result<Vec<Piece>, String> {
    let curve = Curve::new(entity, control, tolerance)?;
    let mut pieces = Vec::new();
    for span in curve.degree..curve.control.len() {
        let [from, to] = [curve.knots[span], curve.knots[span + 1]];
        // More than a tool may have is refused, whatever follows.
        if to > from && pieces.len() <= MOST {
            pieces.extend(curve.arcs(span, [from, to], DEEPEST)?);
        }
    }
    if pieces.is_empty() { Err("has no length".to_owned()) } else { Ok(pieces) }
}

impl Curve {
    fn new(entity: &Entity, control: &[Point], tolerance: f64) -> Result<Self, String> {
        let (degree, knots, weights) = (entity.number(71, 1.0) as usize, entity.numbers(40), entity.numbers(41));
        if control.is_empty() {
            return Err("has fit points only, and what runs between them is not in the file".to_owned());
        }
        if degree == 0 || degree > DEGREE || control.len() <= degree || knots.len() != control.len() + degree + 1 {
            let (points, knots) = (control.len(), knots.len());
            return Err(format!("is damaged: degree {degree}, {points} control points and {knots} knots do not match"));
        }
        let inner = &knots[1..knots.len() - 1];
        let rises = knots.windows(2).all(|w| w[0] <= w[1]) && inner.windows(degree + 1).all(|w| w[0] < w[degree]);
        if !rises || knots.iter().any(|knot| !knot.is_finite()) {
            return Err("is damaged: its knots do not rise".to_owned());
        }
        let usable = weights.len() == control.len() && weights.iter().all(|w| *w > 0.0 && w.is_finite());
        if !(weights.is_empty() || usable) {
            return Err("is damaged: its weights are not one positive number for each control point".to_owned());
        }
        let weight = |i: usize| weights.get(i).copied().unwrap_or(1.0);
        let control = control.iter().enumerate().map(|(i, p)| weight(i) * Vector3::new(p.x, p.y, 1.0)).collect();
        Ok(Self { degree, knots, control, tolerance })
    }

    fn at(&self, span: usize, u: f64) -> (Point, Point) {
        let (p, t) = (self.degree, &self.knots);
        let mut d: Vec<Vector3<f64>> = self.control[span - p..=span].to_vec();
        let mut rate = Vector3::zeros();
        for round in 1..=p {
            if round == p {
                rate = p as f64 / (t[span + 1] - t[span]) * (d[p] - d[p - 1]);
            }
            for j in (round..=p).rev() {
                let i = j + span - p;
                let share = (u - t[i]) / (t[i + p + 1 - round] - t[i]);
                d[j] = (1.0 - share) * d[j - 1] + share * d[j];
            }
        }
        let point = d[p].xy() / d[p].z;
        (point, (rate.xy() - rate.z * point) / d[p].z)
    }

    fn arcs(&self, span: usize, [from, to]: [f64; 2], halvings: usize) -> Result<Vec<Piece>, String> {
        let u = |f: f64| from + f * (to - from);
        let ((a, along_a), (b, along_b)) = (self.at(span, from), self.at(span, to));
        let points: Vec<Point> = (1..POINTS).map(|i| self.at(span, u(i as f64 / POINTS as f64)).0).collect();
        if points.iter().all(|p| (p - a).norm() < COINCIDENT) && (b - a).norm() < COINCIDENT {
            return Ok(Vec::new());
        }
        // Where control points coincide the curve starts with no speed, towards the next point.
        let ta = along_a.try_normalize(COINCIDENT).unwrap_or_else(|| (points[0] - a).normalize());
        let tb = along_b.try_normalize(COINCIDENT).unwrap_or_else(|| (b - points[POINTS - 2]).normalize());
        if (b - a).norm() > COINCIDENT && turn(ta, b - a).abs() < TURN && turn(b - a, tb).abs() < TURN {
            let arcs = biarc(a, ta, b, tb);
            let away = |p: &Point| arcs.iter().map(|a| (a.closest_point(*p) - p).norm()).fold(f64::INFINITY, f64::min);
            if points.iter().all(|p| away(p) <= BETWEEN * self.tolerance) {
                return Ok(arcs);
            }
        }
        if halvings == 0 {
            let (x, y) = (a.x, a.y);
            return Err(format!("has a place near ({x:.4}, {y:.4}) mm where it turns too sharply to be followed"));
        }
        let mut pieces = self.arcs(span, [from, u(0.5)], halvings - 1)?;
        pieces.extend(self.arcs(span, [u(0.5), to], halvings - 1)?);
        Ok(pieces)
    }
}
