//! The sheet before forming.

use super::Theory;
use crate::numerics::quadrature::{ThicknessPoint, lobatto, midpoint};
use crate::units::{As, NonNegative, Positive, Ratio};

/// The sheet before forming.
#[derive(Clone, Debug, PartialEq)]
pub struct Blank {
    /// Radius, or half-length in plane strain \[mm\].
    pub length: f64,
    /// Radius of a hole around the axis, whose edge is free \[mm\]; 0 without one.
    pub hole: f64,
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
    /// Free blank of 100 graded elements that bend, with 5 points through the thickness; `length` is the radius, or the
    /// half-length in plane strain \[mm\].
    pub fn new(length: f64, thickness: f64) -> Self {
        Self {
            length,
            hole: 0.0,
            edge_limit: None,
            thickness,
            elements: 100,
            grading: Grading::Radii,
            theory: Theory::Bending,
            layers: 5,
            rule: ThicknessRule::Parts,
            edge: Edge::Free,
        }
    }

    /// Distances of both ends from the axis or symmetry plane \[mm\].
    pub fn ends(&self) -> [f64; 2] {
        [self.hole, self.length]
    }

    /// The points through the thickness.
    pub fn points(&self) -> Vec<ThicknessPoint> {
        match self.rule {
            ThicknessRule::Parts if self.layers > 1 => midpoint(self.layers),
            _ => lobatto(self.layers),
        }
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

/// The blank's outer edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Edge {
    /// Draws in under the holder.
    #[default]
    Free,
    /// Does not move: a locking bead.
    Clamped,
    /// Moves outward in its plane at `speed` times the punch speed \[–\] and keeps its slope: for tension tests, which no case
    /// file asks for.
    #[serde(skip)]
    Pulled {
        /// Over the punch speed \[–\].
        speed: f64,
    },
}
