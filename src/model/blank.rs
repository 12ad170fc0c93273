//! The sheet before forming.

use super::{Geometry, Theory};
use crate::element::Node;
use crate::geometry::{Point, Profile};
use crate::material::Material;
use crate::numerics::{PiecewiseLinear, quadrature::ThicknessPoint, quadrature::lobatto, quadrature::midpoint};
use crate::units::{As, NonNegative, Positive, Ratio};
use std::f64::consts::TAU;

const CHORDS: usize = 1000;

/// The sheet before forming; of no size by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blank {
    /// Radius, or half-length in plane strain; of a sheet that is not flat the length of its meridian \[mm\].
    pub length: f64,
    /// Distance of the first end from the axis \[mm\], the radius of a hole; 0 without one.
    pub hole: f64,
    /// Meridian of a sheet that is not flat, such as a tube's; it begins at the distance `hole` from the axis.
    pub meridian: Option<Profile>,
    /// Sheet that an earlier run has formed.
    pub preform: Option<Preform>,
    /// Parts of another thickness or metal of a flat blank.
    pub zones: Vec<Zone>,
    /// How the first end is held where it is not on the axis.
    pub inner_edge: Edge,
    /// Expansion that the edge of the hole bears; `None` where it is not known.
    pub edge_limit: Option<EdgeLimit>,
    /// Initial thickness \[mm\].
    pub thickness: f64,
    /// Number of elements from the axis to the edge.
    pub elements: usize,
    /// How element sizes are spread.
    pub grading: Grading,
    /// Shell theory of the elements.
    pub theory: Theory,
    /// Points through the thickness (1 when the theory is membrane).
    pub layers: usize,
    /// Integration rule of the points.
    pub rule: ThicknessRule,
    /// How the outer edge is held.
    pub edge: Edge,
}

/// Part of a tailored blank.
#[derive(Clone, Debug, PartialEq)]
pub struct Zone {
    /// Initial distances from the axis or symmetry plane between which it lies \[mm\].
    pub within: [f64; 2],
    /// Thickness, at most that of the blank \[mm\].
    pub thickness: f64,
    /// Its metal, if it is not that of the blank; only the hardening may be another.
    pub material: Option<Material>,
}

/// Sheet that an earlier run has formed, over the distance along it \[mm\].
#[derive(Clone, Debug, PartialEq)]
pub struct Preform {
    /// Folder of that run.
    pub folder: String,
    /// Description of its material; empty where its summary is not there, as the next two.
    pub material: String,
    /// Reason why its sheet is not sound.
    pub doubt: String,
    /// Radii of its blank and of the punches that drew it \[mm\].
    pub draws: Vec<f64>,
    /// Thickness \[mm\].
    pub thickness: PiecewiseLinear,
    /// Logarithmic mid-surface strains, meridional and hoop, and equivalent plastic strain \[–\].
    pub strains: [PiecewiseLinear; 3],
}

/// Expansion that the edge of a hole bears before it cracks: what the hole expansion test of ISO 16630 (not read) measures.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EdgeLimit {
    /// Limiting hole expansion ratio (d − d₀)/d₀ of this sheet and this edge, punched or reamed.
    #[serde(with = "As::<Positive<Ratio>>")]
    pub expansion: f64,
    /// Scatter of this ratio, in its own percent: from `expansion` less it on the edge may crack; 0 % when not given.
    #[serde(default, with = "As::<NonNegative<Ratio>>")]
    pub scatter: f64,
}

/// Integration rule through the thickness, the same in all stages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ThicknessRule {
    /// Equal parts of the thickness: for the flow law, whose stress jumps where bending turns the flow about.
    #[default]
    Parts,
    /// Gauss-Lobatto points, on both faces too: where the sheet is elastic and its stress does not jump.
    Lobatto,
}

impl Blank {
    /// Free blank of 100 graded elements that bend, with 5 thickness points; `length` is the radius or half-length \[mm\].
    pub fn new(length: f64, thickness: f64) -> Self {
        Self { length, thickness, elements: 100, layers: 5, ..Self::default() }
    }

    /// Distances of both ends from the axis or symmetry plane; of a sheet that is not flat along it from the first end on \[mm\].
    pub fn ends(&self) -> [f64; 2] {
        [if self.meridian.is_some() { 0.0 } else { self.hole }, self.length]
    }

    /// Node at a distance between the [ends](Self::ends) \[mm, rad\].
    pub fn node(&self, s: f64) -> Node {
        let Some(meridian) = &self.meridian else { return [s, 0.0, 0.0] };
        let (at, along) = meridian.at(s);
        [at.x, at.y, along.y.atan2(along.x)]
    }

    /// Distance of the outer edge from the axis or symmetry plane \[mm\].
    pub fn edge_radius(&self) -> f64 {
        self.node(self.length)[0]
    }

    /// Distance from the axis of the edge that may be widened: a hole's, or the outer one of a sheet that is not flat \[mm\].
    pub fn widened_radius(&self) -> f64 {
        if self.meridian.is_some() { self.edge_radius() } else { self.hole }
    }

    /// True of a sheet that is not flat and open at its first end, as a tube.
    pub fn is_open(&self) -> bool {
        self.meridian.is_some() && self.hole > 0.0
    }

    /// True if the first end is the free edge of a hole.
    pub fn has_hole(&self) -> bool {
        self.hole > 0.0 && self.inner_edge == Edge::Free
    }

    /// Largest distance of the mid-surface from the axis or symmetry plane \[mm\].
    pub fn reach(&self) -> f64 {
        let farthest = |_: &Profile| self.mid_surface(CHORDS).map(|(point, _)| point.x).fold(0.0, f64::max);
        self.meridian.as_ref().map_or(self.length, farthest)
    }

    /// Points along the mid-surface, `count` and one more, with half the thickness \[mm\].
    pub fn mid_surface(&self, count: usize) -> impl Iterator<Item = (Point, f64)> {
        let [from, to] = self.ends();
        let places = (0..=count).map(move |i| from + (to - from) * i as f64 / count as f64);
        places.map(|s| (Point::new(self.node(s)[0], self.node(s)[1]), 0.5 * self.thickness_at(s)))
    }

    /// Zone at a distance between the [ends](Self::ends) \[mm\].
    pub fn zone(&self, s: f64) -> Option<&Zone> {
        self.zones.iter().find(|zone| (zone.within[0]..zone.within[1]).contains(&s))
    }

    /// Thickness there of the sheet that nothing has formed yet \[mm\].
    pub fn unformed_thickness(&self, s: f64) -> f64 {
        self.zone(s).map_or(self.thickness, |zone| zone.thickness)
    }

    /// Strains there before the run, as in [`Preform`] \[–\].
    pub fn strains_at(&self, s: f64) -> [f64; 3] {
        self.preform.as_ref().map_or([0.0; 3], |preform| preform.strains.each_ref().map(|strain| strain.at(s)))
    }

    /// Thickness there before the run \[mm\].
    pub fn thickness_at(&self, s: f64) -> f64 {
        self.preform.as_ref().map_or_else(|| self.unformed_thickness(s), |preform| preform.thickness.at(s))
    }

    /// Volume \[mm³, or mm² per mm of depth\], by chords where it is curved.
    pub fn volume(&self, geometry: Geometry) -> f64 {
        let points: Vec<(Point, f64)> = self.mid_surface(CHORDS).collect();
        let ring = |w: &[(Point, f64)]| 0.5 * TAU * (w[0].0.x + w[1].0.x);
        let around = |w: &[(Point, f64)]| if geometry == Geometry::Axisymmetric { ring(w) } else { 1.0 };
        let chord = |w: &[(Point, f64)]| around(w) * (w[1].0 - w[0].0).norm() * (w[0].1 + w[1].1);
        points.windows(2).map(chord).sum()
    }

    /// The points through the thickness.
    pub fn points(&self) -> Vec<ThicknessPoint> {
        let is_in_parts = self.rule == ThicknessRule::Parts && self.layers > 1;
        if is_in_parts { midpoint(self.layers) } else { lobatto(self.layers) }
    }
}

/// How element sizes are spread over the blank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Grading {
    /// Equal elements.
    Uniform,
    /// Smaller elements where the sheet meets the tools' radii.
    #[default]
    Radii,
    /// Mesh of `Radii` with another number of elements, divided or joined: similar meshes for refinement, not in case files.
    #[serde(skip)]
    Divided {
        /// Elements of the mesh that is divided.
        of: usize,
    },
}

impl Edge {
    /// Prescribed moves of the edge in a step \[mm, rad\], `None` if free; `punch` is the step's travel at the mean speed.
    pub fn held(self, punch: f64, travel: f64) -> [Option<f64>; 3] {
        match self {
            Self::Free => [None; 3],
            Self::Axis => [Some(0.0), None, Some(0.0)],
            Self::Guided => [None, Some(0.0), Some(0.0)],
            Self::Clamped => [Some(0.0); 3],
            Self::Fed => [None, Some(travel), Some(0.0)],
            Self::Pulled { speed } => [Some(speed * punch), Some(0.0), Some(0.0)],
        }
    }
}

/// How an edge of the blank is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Edge {
    /// Draws in under the holder.
    #[default]
    Free,
    /// Does not move: a locking bead.
    Clamped,
    /// Keeps its height and its slope, and moves away from the axis freely: the middle plane of a tube, or an end in its seat.
    Guided,
    /// Guided, and moved upward with the travel: the end of a tube that is fed.
    Fed,
    /// Stays on the axis or the symmetry plane: the first end of a blank without a hole.
    #[serde(skip)]
    Axis,
    /// Moves outward at `speed` times the punch speed \[–\] and keeps its slope: for tension tests, in no case file.
    #[serde(skip)]
    Pulled {
        /// Over the punch speed \[–\].
        speed: f64,
    },
}
