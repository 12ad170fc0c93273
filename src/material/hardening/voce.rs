//! Voce's saturating law, with an optional exponent on the strain.

use super::{FlowStress, LawError, power, require};
use crate::units::rounded;

/// σ_y = σ_s − (σ_s − σ₀) exp(−b ε̄^m); m = 1 is Voce's law.
///
/// The BRITE steels of Sosnowski (1994, figure 6) are given in this form: 320 − 195 exp(−7.5 ε^0.97) MPa.
///
/// # References
/// E. Voce, The relationship between stress and strain for homogeneous deformation, J. Inst. Metals 74 (1948) 537–562;
/// the exponent: J. E. Hockett, O. D. Sherby, J. Mech. Phys. Solids 23 (1975) 87–98.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Voce {
    initial: f64,
    saturation: f64,
    rate: f64,
    exponent: f64,
}

impl Voce {
    /// `initial` σ₀ > 0 and `saturation` σ_s ≥ σ₀ \[MPa\], `rate` b ≥ 0 \[–\], `exponent` m (0 < m ≤ 1).
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn new(initial: f64, saturation: f64, rate: f64, exponent: f64) -> Result<Self, LawError> {
        require("saturation", initial > 0.0 && saturation >= initial && saturation.is_finite(), || {
            format!("needs 0 < initial <= saturation, found {} and {} MPa", rounded(initial), rounded(saturation))
        })?;
        require("rate", rate >= 0.0 && rate.is_finite(), || format!("rate must not be negative, found {rate}"))?;
        require("exponent", exponent > 0.0 && exponent <= 1.0, || {
            format!("exponent must lie above 0 and up to 1, found {exponent}")
        })?;
        Ok(Self { initial, saturation, rate, exponent })
    }

    #[inline]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        let (value, slope) = if self.exponent == 1.0 { (strain, 1.0) } else { power(strain, self.exponent) };
        let rest = (self.saturation - self.initial) * (-self.rate * value).exp();
        FlowStress { stress: self.saturation - rest, slope: rest * self.rate * slope }
    }

    pub(super) fn describe(&self) -> String {
        let exponent = if self.exponent == 1.0 { String::new() } else { format!("^{}", rounded(self.exponent)) };
        format!(
            "Voce, σ = {} − {} exp(−{} ε{exponent}) MPa",
            rounded(self.saturation),
            rounded(self.saturation - self.initial),
            rounded(self.rate)
        )
    }
}
