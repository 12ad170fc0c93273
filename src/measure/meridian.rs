//! Meridian of a frame: slope, curvature, bends and the legs between them.

use crate::geometry::{Point, turn};
use crate::numerics::{interpolated, running_sums};
use crate::solver::solution::Frame;
use std::ops::Range;

/// Largest curvature of a leg over that of the bend at its end \[–\]; of a curled leg, of the difference between both.
const FLAT: f64 = 0.25;
/// Curvature over that of the outer bend up to which a leg may curl with its sense \[–\].
const CURLED: f64 = 0.5;
/// Least turn of a bend \[rad\].
const BEND: f64 = 10.0 * std::f64::consts::PI / 180.0;
/// Least turn of half a bend on the axis or symmetry plane \[rad\].
const HALF: f64 = 0.25 * BEND;
/// Share of a leg left out at both ends \[–\].
pub(super) const ENDS: f64 = 0.1;
/// Least length of a leg without its ends, over the thickness.
const LEAST: f64 = 4.0;
/// Share of the whole height by which the sheet leaves the level of its middle for good \[–\]: an embossed bottom does not.
const DEPARTED: f64 = 0.25;

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

struct Bend {
    /// −1 clockwise, 1 counter-clockwise.
    sense: f64,
    sharpest: usize,
    /// Largest curvature in its sense \[1/mm\].
    curvature: f64,
}

#[derive(Clone)]
pub(super) struct Stretch {
    /// Lengths from the axis to its ends \[mm\].
    pub(super) ends: [f64; 2],
    pub(super) sense: f64,
}

impl Meridian {
    /// Meridian of a frame; `None` with fewer than three nodes, coincident or infinite nodes, or no thickness.
    pub(super) fn of(frame: &Frame) -> Option<Self> {
        // The first wall descends where the sheet first leaves the level of its middle downward.
        let middle = frame.nodes.first()?.z;
        let (low, high) = frame.nodes.iter().fold((middle, middle), |(low, high), n| (low.min(n.z), high.max(n.z)));
        let departure = frame.nodes.iter().map(|n| n.z - middle).find(|by| by.abs() > DEPARTED * (high - low));
        let up = departure.map_or(1.0, |by| -by.signum());
        let points: Vec<Point> = frame.nodes.iter().map(|n| Point::new(n.r, up * n.z)).collect();
        let steps: Vec<Point> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
        if steps.len() < 2 || !steps.iter().all(|step| step.norm() > 0.0 && step.norm().is_finite()) {
            return None;
        }
        let before = std::iter::once(Point::x()).chain(steps.iter().copied());
        let slope = running_sums(before.zip(&steps).map(|(before, step)| turn(before, *step))).split_off(1);
        let thickness = frame.nodes.iter().map(|n| n.thickness).sum::<f64>() / frame.nodes.len() as f64;
        if !(thickness > 0.0 && thickness.is_finite()) {
            return None;
        }
        let along = super::along(frame);
        Some(Self { curvature: curvature(&along, &slope, thickness), points, up, along, slope, thickness })
    }

    /// Bends from the axis outward, of alternating sense: turns of the slope, less than [`BEND`] back not counted.
    fn bends(&self) -> Vec<Bend> {
        let slope = |i: usize| if i == 0 { 0.0 } else { self.slope[i - 1] };
        let (mut bends, mut from, mut extreme, mut sense) = (Vec::new(), 0, 0, 0.0);
        let bend = |nodes: Range<usize>, sense: f64| {
            let curvature = |i: &usize| sense * self.curvature[*i];
            let sharpest = nodes.max_by(|i, j| curvature(i).total_cmp(&curvature(j)))?;
            Some(Bend { sense, sharpest, curvature: curvature(&sharpest) })
        };
        for i in 1..=self.slope.len() {
            let onward = slope(i) - slope(extreme);
            if sense == 0.0 && onward.abs() >= HALF {
                (extreme, sense) = (i, onward.signum());
            } else if sense * onward > 0.0 {
                extreme = i;
            } else if -sense * onward >= BEND {
                bends.extend(bend(from..extreme, sense));
                (from, extreme, sense) = (extreme, i, -sense);
            }
        }
        bends.extend(bend(from..extreme, sense));
        bends
    }

    /// Legs from the axis outward. A leg curls with the sense of its outer bend up to [`CURLED`] of that bend's curvature.
    pub(super) fn legs(&self) -> Vec<Stretch> {
        let bends = self.bends();
        let mut legs = Vec::new();
        for (i, inner) in bends.iter().enumerate() {
            let outer = bends.get(i + 1);
            let turned = |i: usize, bend: &Bend, share: f64| bend.sense * self.curvature[i] - share * bend.curvature;
            let is_leg = |i: &usize| turned(*i, inner, FLAT) < 0.0 && outer.is_none_or(|b| turned(*i, b, CURLED) < 0.0);
            let nodes: Vec<usize> = (inner.sharpest..=outer.map_or(self.along.len() - 1, |b| b.sharpest)).collect();
            let (mut stretches, mut between): (Vec<(Range<usize>, f64)>, _) = (Vec::new(), inner.sense * BEND);
            for run in nodes.chunk_by(|i, j| is_leg(i) == is_leg(j)) {
                let run = run[0]..run[run.len() - 1] + 1;
                match (is_leg(&run.start), stretches.last_mut()) {
                    (false, None) => {}
                    (false, _) => between = self.turn_of(&run),
                    (true, Some(before)) if between.abs() < BEND => before.0.end = run.end,
                    (true, _) => stretches.push((run, between.signum())),
                }
            }
            let before = legs.len();
            for (nodes, sense) in stretches {
                let curl = outer.map_or(0.0, |bend| bend.sense * self.mean_curvature(&nodes) / bend.curvature).max(0.0);
                let flat = FLAT + (1.0 - FLAT) * curl;
                let behind = |bend| nodes.clone().rfind(|i| turned(*i, bend, flat) < 0.0);
                let end = outer.map_or(nodes.end, |bend| behind(bend).map_or(nodes.start, |i| i + 1));
                let start = self.crossing(nodes.start.saturating_sub(1), nodes.start, |i| turned(i, inner, FLAT));
                let end = outer.map_or(self.along[end - 1], |b| self.crossing(end, end - 1, |i| turned(i, b, flat)));
                legs.extend(self.leg([start, end], sense));
            }
            // Without a straight stretch the slope of the wall is that of its inflection.
            legs.extend(outer.filter(|bend| bend.sense != inner.sense && legs.len() == before).and_then(|bend| {
                let i = (inner.sharpest..bend.sharpest).find(|i| inner.sense * self.curvature[i + 1] <= 0.0)?;
                let (at, half) = (self.crossing(i, i + 1, |i| inner.sense * self.curvature[i]), 0.5 * self.thickness);
                Some(Stretch { ends: [at - half, at + half], sense: inner.sense })
            }));
        }
        legs
    }

    /// Length from the axis at which a function changes its sign between two nodes, the second with the negative one \[mm\].
    fn crossing(&self, outside: usize, inside: usize, of: impl Fn(usize) -> f64) -> f64 {
        let (beyond, below) = (of(outside), of(inside));
        let share = if beyond > 0.0 && below < 0.0 { below / (below - beyond) } else { 0.0 };
        self.along[inside] + share * (self.along[outside] - self.along[inside])
    }

    /// Turn of the sheet over these nodes \[rad\]; level on the axis.
    fn turn_of(&self, nodes: &Range<usize>) -> f64 {
        let before = if nodes.start == 0 { 0.0 } else { self.slope[nodes.start - 1] };
        self.slope[(nodes.end - 1).min(self.slope.len() - 1)] - before
    }

    /// Mean curvature over the middle of a stretch \[1/mm\].
    fn mean_curvature(&self, nodes: &Range<usize>) -> f64 {
        let end = nodes.len() / 4;
        let middle = nodes.start + end..nodes.end - end;
        self.turn_of(&middle) / (self.along[middle.end.min(self.along.len() - 1)] - self.along[middle.start])
    }

    fn leg(&self, ends: [f64; 2], sense: f64) -> Option<Stretch> {
        let [from, to] = [ENDS, 1.0 - ENDS].map(|share| ends[0] + share * (ends[1] - ends[0]));
        let nodes = self.along.partition_point(|s| *s < from)..self.along.partition_point(|s| *s <= to);
        (nodes.len() >= 3 && to - from >= LEAST * self.thickness).then_some(Stretch { ends, sense })
    }

    /// Point at a length from the axis \[mm\].
    pub(super) fn point_at(&self, along: f64) -> Point {
        let after = self.along.partition_point(|s| *s < along).clamp(1, self.along.len() - 1);
        let (from, to) = (self.along[after - 1], self.along[after]);
        self.points[after - 1] + (along - from) / (to - from) * (self.points[after] - self.points[after - 1])
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
