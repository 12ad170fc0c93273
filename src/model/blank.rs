//! The sheet before forming.

use super::Theory;

/// The sheet before forming.
#[derive(Clone, Debug, PartialEq)]
pub struct Blank {
    /// Radius, or half-length in plane strain \[mm\].
    pub length: f64,
    /// Initial thickness \[mm\].
    pub thickness: f64,
    /// Number of elements from the axis to the edge.
    pub elements: usize,
    pub grading: Grading,
    pub theory: Theory,
    /// Gauss-Lobatto points through the thickness (1 when the theory is membrane).
    pub layers: usize,
    pub edge: Edge,
}

/// How element sizes are spread over the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grading {
    /// Equal elements.
    Uniform,
    /// Smaller elements where the sheet meets the tools' corners.
    Radii,
}

/// How the blank's outer edge is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    Free,
    /// All velocities of the edge are zero.
    Clamped,
    /// The edge moves outward in its plane at `speed` times the punch speed \[–\] and keeps its slope: for tension tests.
    Pulled {
        speed: f64,
    },
}
