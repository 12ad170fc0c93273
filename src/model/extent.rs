//! Extent of the part that forces, work and heat refer to, and their units.

use super::Geometry;
use crate::units::{Amount, Unit};

/// Extent of the part: always the whole section, both halves of a plane one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// Whole ring.
    Ring,
    /// Both halves of a plane section, per mm of its depth.
    PerDepth,
    /// Both halves of a plane section, over this depth \[mm\].
    Depth(f64),
}

impl Extent {
    /// Extent by the geometry, and the depth of a plane section \[mm\] if known.
    pub fn of(geometry: Geometry, depth: Option<f64>) -> Self {
        match (geometry, depth) {
            (Geometry::Axisymmetric, _) => Self::Ring,
            (Geometry::PlaneStrain, None) => Self::PerDepth,
            (Geometry::PlaneStrain, Some(depth)) => Self::Depth(depth),
        }
    }

    /// Factor from the solved part, the ring or one half per mm of depth, to the whole \[–, or mm\].
    pub fn times(self) -> f64 {
        match self {
            Self::Ring => 1.0,
            Self::PerDepth => 2.0,
            Self::Depth(depth) => 2.0 * depth,
        }
    }

    /// Geometry of the section.
    pub fn geometry(self) -> Geometry {
        if self == Self::Ring { Geometry::Axisymmetric } else { Geometry::PlaneStrain }
    }

    /// Area of a flat sheet up to the distance `r` from the axis or symmetry plane \[mm², or mm per mm of depth\].
    pub fn area(self, r: f64) -> f64 {
        self.times() * self.geometry().area(r)
    }

    /// Unit of forces.
    pub fn force_unit(self) -> Unit {
        if self == Self::PerDepth { Unit::NPerMm } else { Unit::N }
    }

    /// Unit of work and heat in tables, after [`JOULES`](crate::table::JOULES).
    pub fn energy_unit(self) -> Unit {
        if self == Self::PerDepth { Unit::JoulePerMm } else { Unit::Joule }
    }

    /// The words for it: `forces of the whole ring`.
    pub fn described(self) -> String {
        match self {
            Self::Ring => "forces of the whole ring".into(),
            Self::PerDepth => "forces of the whole section, both halves, per mm of depth".into(),
            Self::Depth(depth) => format!("forces of the whole part, {} deep", Amount::size(depth)),
        }
    }
}
