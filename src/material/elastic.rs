//! Elasticity of the sheet.

use super::yield_condition::{SHEAR_FACTOR, Triple};

/// Isotropic elastic constants: of the elastoplastic law, of unloading, and of laws that start at the elastic line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
}

impl Elastic {
    /// D in the sum and the difference of the meridional and the hoop stress, and in the transverse shear \[MPa\].
    pub fn moduli(&self) -> Triple {
        let Self { young, poisson } = *self;
        [young / (1.0 - poisson), young / (1.0 + poisson), 0.5 * SHEAR_FACTOR * young / (1.0 + poisson)]
    }

    /// ln J of a stress per initial volume, with none across the sheet \[–\].
    pub fn volume_strain(&self, stress: Triple) -> f64 {
        (1.0 - 2.0 * self.poisson) / self.young * (stress[0] + stress[1])
    }

    /// Strain energy per volume of a stress \[MPa\].
    pub fn energy(&self, stress: Triple) -> f64 {
        let [s, t, shear] = stress;
        let [sum, difference, slip] = self.moduli();
        0.25 * ((s + t) * (s + t) / sum + (s - t) * (s - t) / difference) + 0.5 * shear * shear / slip
    }
}
