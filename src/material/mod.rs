//! What the sheet is made of: hardening, rate and softening laws, anisotropy, voids, and the flow law.

mod anisotropy;
pub mod flow;
pub mod hardening;
pub mod rate;
pub mod softening;
pub mod voids;

pub use anisotropy::Anisotropy;
pub use hardening::{FlowStress, Hardening};
pub use rate::Rate;
pub use softening::Softening;
pub use voids::Voids;

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
    /// `None` for a metal whose strength does not feel its temperature, or says so in its hardening law.
    pub softening: Option<Softening>,
    pub anisotropy: Anisotropy,
    /// `None` for a metal without voids.
    pub voids: Option<Voids>,
}

impl Material {
    /// The flow stress as a formula, and the anisotropy and the voids where there are any.
    pub fn describe(&self) -> String {
        let rate = self.rate.map_or(String::new(), |rate| format!(" times {rate}"));
        let softening = self.softening.map_or(String::new(), |softening| format!(" times {softening}"));
        let r = self.anisotropy.ratio();
        let anisotropy = if r == 1.0 { String::new() } else { format!("; Hill 1948, r̄ = {r}") };
        let voids = self.voids.map_or(String::new(), |voids| format!("; {voids}"));
        format!("{}{rate}{softening}{anisotropy}{voids}", self.hardening.describe())
    }

    /// An isotropic, rate-free sheet that does not feel its temperature.
    pub fn plain(hardening: Hardening) -> Self {
        let anisotropy = Anisotropy::default();
        Self { hardening, elastic: None, rate: None, softening: None, anisotropy, voids: None }
    }

    /// Yield stress at a strain and a temperature \[K\], without the rate \[MPa\].
    pub fn yield_stress(&self, strain: f64, temperature: f64) -> f64 {
        let cold = self.hardening.at_temperature(strain, temperature).stress;
        self.softening.map_or(cold, |softening| cold * softening.at(temperature))
    }
}
