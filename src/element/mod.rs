//! The two-node shell element: pure functions of its nodes and of its thickness points.

pub mod kinematics;
pub mod section;
pub mod surface;

use std::str::FromStr;

named! {
    /// Kind of section.
    #[derive(Default, serde::Deserialize, schemars::JsonSchema)]
    #[serde(rename_all = "snake_case")]
    pub enum Geometry;
    /// Key in case files.
    fn key;
    #[default]
    Axisymmetric: "axisymmetric", "Body of revolution.";
    PlaneStrain: "plane_strain", "A section that is the same at every depth; one half of it is solved, symmetric to the other.";
}

impl Geometry {
    /// Area of a flat sheet up to the distance `r` from the axis or symmetry plane \[mm², or mm per mm of depth\].
    pub fn area(self, r: f64) -> f64 {
        if self == Self::Axisymmetric { std::f64::consts::PI * r * r } else { r }
    }

    /// Length of a line round the axis or along the depth at the distance `r` \[mm, or 1 per mm of depth\].
    pub fn line(self, r: f64) -> f64 {
        if self == Self::Axisymmetric { std::f64::consts::TAU * r } else { 1.0 }
    }
}

impl FromStr for Geometry {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let geometry = Self::ALL.into_iter().find(|geometry| geometry.key() == text);
        geometry.ok_or_else(|| format!("give {}", Self::ALL.map(Self::key).join(", ")))
    }
}

/// Shell theory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Theory {
    /// Membrane, bending and transverse shear.
    #[default]
    Bending,
    /// Membrane only.
    Membrane,
}

/// A node's position and fibre rotation `[r, z, θ]` \[mm, mm, rad\], or an increment of them.
pub type Node = [f64; 3];

/// The element's freedoms in order: r₁, z₁, θ₁, r₂, z₂, θ₂.
pub type Vector6 = nalgebra::SVector<f64, 6>;

#[cfg(test)]
#[path = "theory/tests.rs"]
pub(crate) mod theory;
