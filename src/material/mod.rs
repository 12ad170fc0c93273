//! What the sheet is made of: hardening and rate laws, anisotropy, and the flow law.

mod anisotropy;
pub mod flow;
pub mod hardening;
pub mod rate;

pub use anisotropy::Anisotropy;
pub use hardening::{FlowStress, Hardening};
pub use rate::Rate;

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
    /// `None` for a rate-free metal.
    pub rate: Option<Rate>,
    pub anisotropy: Anisotropy,
}

impl Material {
    /// The flow stress as a formula, and the anisotropy where there is one.
    pub fn describe(&self) -> String {
        let rate = self.rate.map_or(String::new(), |rate| format!(" times {rate}"));
        let r = self.anisotropy.ratio();
        let anisotropy = if r == 1.0 { String::new() } else { format!("; Hill 1948, r̄ = {r}") };
        format!("{}{rate}{anisotropy}", self.hardening.describe())
    }

    /// An isotropic, rate-free sheet.
    pub fn plain(hardening: Hardening) -> Self {
        Self { hardening, elastic: None, rate: None, anisotropy: Anisotropy::default() }
    }
}
