//! Friction of lubricated sheet, τ = μ(p) p φ(s) with μ(p) = μ₀ (p/p₀)^(e−1); p in μ is √(p² + (0.01 p₀)²), so that μ is finite.

use super::{FrictionLaw, FrictionStress, Sliding};
use crate::material::law::prelude::*;

parameters! {
    /// Coefficient that falls with pressure: μ = coefficient (p/reference)^(exponent − 1).
    ///
    /// Source: in common use for lubricated sheet; I. Gil et al., Tribology International 103 (2016) 266–273 (not read).
    pub struct PressureDependent {
        /// At the reference pressure, 0 to 1.
        pub coefficient: "As::<Fraction>" = 0.12,
        /// Reference pressure \[MPa\].
        pub reference: "As::<Positive<Stress>>" = "5 MPa",
        /// 0 to 1; 1 is Coulomb's law, 0 a friction stress that does not depend on the pressure.
        pub exponent: "As::<Fraction>" = 0.9,
    }
}

impl PressureDependent {
    /// Share of the reference pressure below which the coefficient levels off \[–\].
    pub const LIGHT: f64 = 0.01;
}

impl FrictionLaw for PressureDependent {
    fn formula(&self) -> String {
        format!("{} (p/{} MPa)^({} − 1)", self.coefficient, self.reference, self.exponent)
    }

    fn at(&self, at: &Sliding) -> FrictionStress {
        let q = at.pressure / self.reference;
        let square = q * q + Self::LIGHT * Self::LIGHT;
        let mu = self.coefficient * square.powf(0.5 * (self.exponent - 1.0));
        FrictionStress::regularised(mu * at.pressure, mu * (1.0 + (self.exponent - 1.0) * q * q / square), at)
    }

    fn largest_coefficient(&self) -> f64 {
        self.coefficient * Self::LIGHT.powf(self.exponent - 1.0)
    }
}
