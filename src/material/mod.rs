//! What the sheet is made of: hardening laws and the flow law.

pub mod flow;
pub mod hardening;

pub use hardening::{FlowStress, Hardening};

/// Isotropic elastic constants; the flow law has no elasticity, they serve laws that start at the elastic line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
}

/// The sheet's material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub hardening: Hardening,
    pub elastic: Option<Elastic>,
}
