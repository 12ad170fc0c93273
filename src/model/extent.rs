//! What of the part the forces, works and heat of a run are of, and the units that follow.

use super::Geometry;
use crate::units::Amount;
use crate::units::Unit;

/// What forces, works and heat are of: always of the whole section, both halves of a plane one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// The whole ring.
    Ring,
    /// Both halves of a plane section, per mm of its depth.
    PerDepth,
    /// Both halves of a plane section, over this depth \[mm\].
    Depth(f64),
}

impl Extent {
    /// Of a geometry, and the depth of a plane section \[mm\] where it is known.
    pub fn of(geometry: Geometry, depth: Option<f64>) -> Self {
        match (geometry, depth) {
            (Geometry::Axisymmetric, _) => Self::Ring,
            (Geometry::PlaneStrain, None) => Self::PerDepth,
            (Geometry::PlaneStrain, Some(depth)) => Self::Depth(depth),
        }
    }

    /// How many times what is solved, the ring or one half per mm of depth, the whole is \[–, or mm\]: here alone the second
    /// half and the depth enter.
    pub fn times(self) -> f64 {
        match self {
            Self::Ring => 1.0,
            Self::PerDepth => 2.0,
            Self::Depth(depth) => 2.0 * depth,
        }
    }

    /// The section.
    pub fn geometry(self) -> Geometry {
        match self {
            Self::Ring => Geometry::Axisymmetric,
            Self::PerDepth | Self::Depth(_) => Geometry::PlaneStrain,
        }
    }

    /// Area of a flat sheet up to the distance `r` from the axis, or from the symmetry plane on both sides of it \[mm², or mm
    /// per mm of depth\].
    pub fn area(self, r: f64) -> f64 {
        self.times() * self.geometry().area(r)
    }

    /// Unit of forces.
    pub fn force_unit(self) -> Unit {
        if self == Self::PerDepth { Unit::NPerMm } else { Unit::N }
    }

    /// Unit in which work and heat are written, after [`JOULES`](crate::table::JOULES).
    pub fn energy_unit(self) -> Unit {
        if self == Self::PerDepth { Unit::JoulePerMm } else { Unit::Joule }
    }

    /// The words for it: `forces of the whole ring`.
    pub fn described(self) -> String {
        match self {
            Self::Ring => "forces of the whole ring".into(),
            Self::PerDepth => "forces of the whole section, both halves, per mm of depth".into(),
            Self::Depth(depth) => {
                format!("forces of the whole part, {depth} deep", depth = Amount::size(depth))
            }
        }
    }
}
