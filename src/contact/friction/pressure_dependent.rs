//! Coulomb's friction with a coefficient that falls as the pressure rises.

use super::{Drag, Sliding, direction};

/// τ = μ(p) p φ(s) with μ(p) = μ₀ (p/p₀)^(e−1): lubricated sheet, whose pockets of lubricant carry more as they are pressed.
///
/// Below [`Self::LIGHT`] p₀ the coefficient levels off, so that it stays finite where the pressure sets in:
/// p is replaced there by √(p² + (0.01 p₀)²).
///
/// # References
/// The form in common use for lubricated sheet; not read: I. Gil, J. Mendiguren, L. Galdos, E. Mugarra, E. Saenz de Argandoña, Influence of the pressure dependent coefficient
/// of friction on deep drawing springback predictions, Tribology International 103 (2016) 266–273.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureDependent {
    /// μ₀ at the reference pressure \[–\].
    pub coefficient: f64,
    /// p₀ \[MPa\].
    pub reference: f64,
    /// e, 0 to 1: 1 is Coulomb's law, 0 a friction stress that does not depend on the pressure \[–\].
    pub exponent: f64,
}

impl PressureDependent {
    /// Share of the reference pressure below which the coefficient levels off \[–\].
    pub const LIGHT: f64 = 0.01;

    /// The coefficient without pressure, its largest \[–\].
    pub fn largest(&self) -> f64 {
        self.coefficient * Self::LIGHT.powf(self.exponent - 1.0)
    }

    /// The friction stress and its derivatives.
    #[inline]
    pub fn at(&self, at: &Sliding) -> Drag {
        let phi = direction(at.slip, at.scale);
        let q = at.pressure / self.reference;
        let square = q * q + Self::LIGHT * Self::LIGHT;
        let mu = self.coefficient * square.powf(0.5 * (self.exponent - 1.0));
        let by_pressure = mu * (1.0 + (self.exponent - 1.0) * q * q / square);
        Drag {
            value: mu * at.pressure * phi.value,
            by_pressure: by_pressure * phi.value,
            by_slip: mu * at.pressure * phi.slope,
        }
    }

    /// The law in words and numbers.
    pub fn describe(&self) -> String {
        format!("{} (p/{} MPa)^({} − 1)", self.coefficient, self.reference, self.exponent)
    }
}
