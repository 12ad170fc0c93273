//! Strain paths held against a curve.

use super::*;
use nalgebra::Vector2;

/// Largest distance of a straight path from the line between its ends, over that line's length \[–\], a convention.
pub const CROOKED: f64 = 0.1;
/// Shortest path that is judged \[–\].
pub const SHORTEST: f64 = 0.02;

/// One element at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// Initial distance of its middle from the axis \[mm\].
    pub s0: f64,
    /// Smaller logarithmic strain of the mid-surface \[–\].
    pub minor: f64,
    /// Larger logarithmic strain of the mid-surface \[–\].
    pub major: f64,
    /// Whether the hoop strain is the larger one.
    pub hoop_is_major: bool,
    /// Major strain of the curve at this minor strain; beyond its end what the sheet surely bears \[–\].
    pub limit: f64,
    /// Whether the curve has ended before this minor strain.
    pub beyond_end: bool,
    /// Whether it belongs to the edge of a hole, which has a limit of its own.
    pub of_edge: bool,
    /// Distance of its path from straight, as [`CROOKED`]; 0 for a path shorter than [`SHORTEST`] \[–\].
    pub crookedness: f64,
}

impl Judged {
    /// Distance in major strain to the curve at the same minor strain \[–\]; negative beyond it.
    pub fn margin(&self) -> f64 {
        self.limit - self.major
    }

    /// Major strain over the curve's at the same minor strain \[–\]; 1 on it.
    pub fn ratio(&self) -> f64 {
        self.major / self.limit
    }

    /// Whether nothing is known of it: beyond the end of the curve, and strained more than at its end.
    pub fn is_open(&self) -> bool {
        !self.of_edge && self.beyond_end && self.major > self.limit
    }

    /// Whether its path is too far from straight for the curve to be taken at its word.
    pub fn is_crooked(&self) -> bool {
        self.crookedness > CROOKED
    }
}

/// Place and time at which an element reaches the curve, between two steps in proportion to the margin, or a neck has lasted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Onset {
    /// Time \[s\].
    pub time: f64,
    /// Punch travel then \[mm\].
    pub travel: f64,
    /// Initial distance of the element's middle from the axis \[mm\].
    pub s0: f64,
}

/// Assessment of a run by a forming limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// From the axis outward.
    pub elements: Vec<Judged>,
    /// `None` where the limit was not reached.
    pub reached: Option<Onset>,
}

impl Assessment {
    /// The element with the least margin of those that are judged; of all where none is.
    ///
    /// # Panics
    /// Never: there is one element at least.
    pub fn worst(&self) -> &Judged {
        let last = |one: &Judged| (one.of_edge, one.is_open());
        let order = |a: &&Judged, b: &&Judged| last(a).cmp(&last(b)).then(a.margin().total_cmp(&b.margin()));
        self.elements.iter().min_by(order).expect("an assessment has elements")
    }

    /// The element that is strained most of those that the curve, having ended, does not judge.
    pub fn open(&self) -> Option<&Judged> {
        self.elements.iter().filter(|element| element.is_open()).max_by(|a, b| a.ratio().total_cmp(&b.ratio()))
    }

    /// Whether every element was judged, and none came to the limit.
    pub fn is_kept(&self) -> bool {
        self.reached.is_none() && self.open().is_none()
    }

    /// Elements whose paths are not straight.
    pub fn crooked(&self) -> usize {
        self.elements.iter().filter(|element| element.is_crooked()).count()
    }
}

/// Holds the paths of a run against a curve; `None` where no path was kept.
pub fn assess(curve: &Curve, paths: &Paths) -> Option<Assessment> {
    if paths.instants.is_empty() || paths.s0.is_empty() {
        return None;
    }
    let judged = |(e, &s0): (usize, &f64)| {
        let path = paths.of(e);
        let [minor, major] = path[path.len() - 1];
        let (hoop_is_major, of_edge, crookedness) = (paths.hoop_is_major(e), paths.is_of_edge(e), crookedness(&path));
        let (limit, beyond_end) = (curve.major_at(minor), !curve.knows(minor));
        Judged { s0, minor, major, hoop_is_major, limit, beyond_end, of_edge, crookedness }
    };
    let inner = paths.s0.iter().enumerate().filter(|(e, _)| !paths.is_of_edge(*e));
    let reached = inner.filter_map(|(e, &s0)| crossing(curve, paths, e, s0)).min_by(|a, b| a.time.total_cmp(&b.time));
    Some(Assessment { elements: paths.s0.iter().enumerate().map(judged).collect(), reached })
}

fn crossing(curve: &Curve, paths: &Paths, element: usize, s0: f64) -> Option<Onset> {
    let at = |i: usize| {
        let [a, b] = paths.instants[i].strains[element];
        (a.min(b), curve.major_at(a.min(b)) - a.max(b))
    };
    let i = (0..paths.instants.len()).find(|&i| at(i).1 <= 0.0 && curve.knows(at(i).0))?;
    let now = &paths.instants[i];
    let Some(last) = i.checked_sub(1) else { return Some(Onset { time: now.time, travel: now.travel, s0 }) };
    let (margin, before) = (at(last).1, &paths.instants[last]);
    let between = |from: f64, to: f64| from + margin / (margin - at(i).1) * (to - from);
    Some(Onset { time: between(before.time, now.time), travel: between(before.travel, now.travel), s0 })
}

fn crookedness(path: &[[f64; 2]]) -> f64 {
    let from_start = |p: &[f64; 2]| Vector2::new(p[0] - path[0][0], p[1] - path[0][1]);
    let along = from_start(&path[path.len() - 1]);
    let length = along.norm();
    if path.iter().map(|p| from_start(p).norm()).fold(0.0, f64::max) < SHORTEST {
        return 0.0;
    }
    let distance = |p: &[f64; 2]| {
        // The nearest point of the line itself, so that a way there and back counts.
        let share = from_start(p).dot(&along) / (length * length).max(f64::MIN_POSITIVE);
        (from_start(p) - share.clamp(0.0, 1.0) * along).norm()
    };
    path.iter().map(distance).fold(0.0, f64::max) / length.max(SHORTEST)
}
