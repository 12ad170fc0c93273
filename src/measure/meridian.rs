//! Meridian of a frame: slope, curvature, bends and the straight legs between them.

use crate::geometry::{Point, turn};
use crate::numerics::interpolated;
use crate::solver::solution::Frame;
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;

/// Largest curvature of a leg over that of the bends at its ends \[–\].
const FLAT: f64 = 0.25;
/// Least turn of a bend \[rad\].
const BEND: f64 = 10.0 * std::f64::consts::PI / 180.0;
/// Least turn of half a bend on the axis or symmetry plane \[rad\].
const HALF: f64 = 0.25 * BEND;
/// Factor on the curvature of a bend from one search to the next \[–\].
const FINER: f64 = 0.8;
/// Share of a leg left out at both ends \[–\].
const ENDS: f64 = 0.1;
/// Least length of a leg without its ends, over the thickness.
const LEAST: f64 = 4.0;

/// Mid-surface from the axis outward, mirrored so that its middle lies above its edge.
pub(super) struct Meridian {
    pub(super) points: Vec<Point>,
    /// −1 if mirrored.
    pub(super) up: f64,
    /// Length from the axis to each node \[mm\].
    pub(super) along: Vec<f64>,
    /// Slope of each element, without jumps of 2π \[rad\].
    slope: Vec<f64>,
    /// dφ/ds at each node over a window of two thicknesses \[1/mm\].
    pub(super) curvature: Vec<f64>,
    /// Mean thickness \[mm\].
    pub(super) thickness: f64,
}

struct Part {
    nodes: Range<usize>,
    /// −1 for a clockwise and 1 for a counter-clockwise bend; 0 straight.
    sense: i8,
    /// True for a bend of at least the searched curvature.
    sharp: bool,
}

impl Meridian {
    /// Meridian of a frame; `None` with fewer than three nodes, coincident or infinite nodes, or no thickness.
    pub(super) fn of(frame: &Frame) -> Option<Self> {
        let (first, last) = (frame.nodes.first()?, frame.nodes.last()?);
        let up = if first.z < last.z { -1.0 } else { 1.0 };
        let points: Vec<Point> = frame.nodes.iter().map(|n| Point::new(n.r, up * n.z)).collect();
        let steps: Vec<Point> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let is_line = |step: &Point| step.norm() > 0.0 && step.norm().is_finite();
        if steps.len() < 2 || !steps.iter().all(is_line) {
            return None;
        }
        let mut slope: Vec<f64> = Vec::with_capacity(steps.len());
        let mut before = Point::new(1.0, 0.0);
        for step in &steps {
            slope.push(slope.last().unwrap_or(&0.0) + turn(before, *step));
            before = *step;
        }
        let thickness = frame.nodes.iter().map(|n| n.thickness).sum::<f64>() / frame.nodes.len() as f64;
        if !(thickness > 0.0 && thickness.is_finite()) {
            return None;
        }
        let along = super::along(frame);
        let curvature = curvature(&along, &slope, thickness);
        Some(Self { points, up, along, slope, curvature, thickness })
    }

    /// Searches for a leg at falling curvatures of bends; `wanted` picks one of the legs with the senses of their inner bends: −1
    /// where the bend made the sheet descend, 1 where it brought it back.
    pub(super) fn leg(&self, wanted: impl Fn(&[(Range<usize>, i8)]) -> Option<Range<usize>>) -> Option<Range<usize>> {
        let sharpest = self.sharpest();
        let length = self.along[self.along.len() - 1];
        let levels = std::iter::successors(Some(sharpest), |level| Some(FINER * level));
        levels.take_while(|level| level * length > BEND).find_map(|level| wanted(&self.legs(level)))
    }

    /// Legs between bends of at least this curvature \[1/mm\], without their ends.
    fn legs(&self, level: f64) -> Vec<(Range<usize>, i8)> {
        let parts = self.parts(level);
        let inside = |i: usize| parts[..i].last();
        let is_leg = |i: usize| {
            let sharp_inside = inside(i).is_some_and(|bend| bend.sharp);
            parts[i].sense == 0 && sharp_inside && parts.get(i + 1).is_none_or(|bend| bend.sharp)
        };
        let legs = (0..parts.len()).filter(|&i| is_leg(i));
        legs.filter_map(|i| Some((self.without_ends(&parts[i].nodes)?, inside(i)?.sense))).collect()
    }

    fn parts(&self, level: f64) -> Vec<Part> {
        let senses: Vec<i8> =
            self.curvature.iter().map(|k| if k.abs() < FLAT * level { 0 } else { k.signum() as i8 }).collect();
        let mut parts: Vec<Part> = Vec::new();
        let mut from = 0;
        for stretch in senses.chunk_by(|a, b| a == b) {
            let nodes = from..from + stretch.len();
            from = nodes.end;
            let peak = self.curvature[nodes.clone()].iter().fold(0.0_f64, |most, k| most.max(k.abs()));
            let least = if nodes.start == 0 { HALF } else { BEND };
            let sense = if self.turn_of(&nodes).abs() < least { 0 } else { stretch[0] };
            match parts.last_mut() {
                Some(before) if before.sense == 0 && sense == 0 => before.nodes.end = nodes.end,
                _ => parts.push(Part { nodes, sense, sharp: peak >= level }),
            }
        }
        parts
    }

    /// Turn of the sheet over these nodes \[rad\]; level on the axis.
    fn turn_of(&self, nodes: &Range<usize>) -> f64 {
        let before = if nodes.start == 0 { 0.0 } else { self.slope[nodes.start - 1] };
        self.slope[(nodes.end - 1).min(self.slope.len() - 1)] - before
    }

    fn without_ends(&self, nodes: &Range<usize>) -> Option<Range<usize>> {
        let (from, to) = (self.along[nodes.start], self.along[nodes.end - 1]);
        let end = ENDS * (to - from);
        let start = nodes.start + self.along[nodes.clone()].partition_point(|s| *s < from + end);
        let stop = nodes.start + self.along[nodes.clone()].partition_point(|s| *s <= to - end);
        let is_long = stop >= start + 3 && self.along[stop - 1] - self.along[start] >= LEAST * self.thickness;
        is_long.then_some(start..stop)
    }

    /// Descent of a stretch over its length \[–\]: 1 upright.
    pub(super) fn descent(&self, nodes: &Range<usize>) -> f64 {
        let chord = self.points[nodes.end - 1] - self.points[nodes.start];
        -chord.y / chord.norm()
    }

    /// Largest absolute curvature \[1/mm\].
    pub(super) fn sharpest(&self) -> f64 {
        self.curvature.iter().fold(0.0, |most, k| k.abs().max(most))
    }

    /// Node nearest to a length from the axis \[mm\].
    pub(super) fn node_at(&self, along: f64) -> usize {
        let distance = |i: &usize| (self.along[*i] - along).abs();
        (0..self.along.len()).min_by(|i, j| distance(i).total_cmp(&distance(j))).unwrap_or(0)
    }
}

/// Curvature at each node: difference of the slopes a `reach` before and behind it over their distance.
fn curvature(along: &[f64], slope: &[f64], reach: f64) -> Vec<f64> {
    let middles = along.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let slopes: Vec<(f64, f64)> = middles.zip(slope.iter().copied()).collect();
    let (first, last) = (slopes[0].0, slopes[slopes.len() - 1].0);
    let of_node = |s: &f64| {
        let (from, to) = ((s - reach).clamp(first, last), (s + reach).clamp(first, last));
        // Farther than the reach from every middle, in a long first or last element, there is no window.
        if to > from { (interpolated(&slopes, to) - interpolated(&slopes, from)) / (to - from) } else { 0.0 }
    };
    along.iter().map(of_node).collect()
}

/// Least-squares line and circle through a stretch, weighted by length.
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
        let moment = |of: fn(Point) -> f64| points.iter().zip(&weights).map(|(p, w)| w * of(p - middle)).sum::<f64>();
        let difference = moment(|d| d.x * d.x) - moment(|d| d.y * d.y);
        let angle = 0.5 * (2.0 * moment(|d| d.x * d.y)).atan2(difference);
        let mut direction = Point::new(angle.cos(), angle.sin());
        if direction.dot(&(last - first)) < 0.0 {
            direction = -direction;
        }
        let curvature = circle(points, &weights, middle, direction)?;
        Some(Self { middle, direction, curvature })
    }
}

fn weights(points: &[Point]) -> Vec<f64> {
    let length = |i: usize| if i == 0 || i == points.len() { 0.0 } else { (points[i] - points[i - 1]).norm() };
    (0..points.len()).map(|i| 0.5 * (length(i) + length(i + 1))).collect()
}

/// The circle A (u² + v²) + B u + v + D = 0 with the least Σ w (left-hand side)², u along and v across the line, in
/// units of the stretch: linear in A, B and D, and a line where A = 0. Its curvature is −2A/√(1 + B² − 4AD).
fn circle(points: &[Point], weights: &[f64], middle: Point, direction: Point) -> Option<f64> {
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
