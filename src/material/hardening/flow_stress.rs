//! Interface of the hardening laws: the yield stress, its slope, and the range of both.

use crate::material::law::{Law, LawError, require};
use crate::units::rounded;

/// Yield stress and its slope at one strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowStress {
    /// σ_y \[MPa\].
    pub stress: f64,
    /// dσ_y/dε̄ \[MPa\].
    pub slope: f64,
}

impl FlowStress {
    /// `share` of the way to another flow stress.
    #[inline]
    pub(super) fn towards(self, other: Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self { stress: between(self.stress, other.stress), slope: between(self.slope, other.slope) }
    }

    /// The same metal, `factor` times as strong.
    #[inline]
    pub(in crate::material) fn times(self, factor: f64) -> Self {
        Self { stress: factor * self.stress, slope: factor * self.slope }
    }
}

/// Interface of a hardening law.
pub(super) trait HardeningLaw: Law {
    /// σ_y and dσ_y/dε̄ at the equivalent plastic strain `strain` ≥ 0 and a temperature \[K\]; continuous and finite.
    fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress;

    /// Largest strain the law was given for, where it says so.
    fn valid_up_to(&self) -> Option<f64> {
        None
    }

    /// The coldest and the hottest temperature the law was given for, where it depends on it \[K\].
    fn temperatures(&self) -> Option<[f64; 2]> {
        None
    }
}

/// Strain below which ε^n is replaced by its chord from the origin: its slope at 0 is infinite for n < 1 \[–\].
const CHORD_UP_TO: f64 = 1e-6;

/// ε^n and its derivative, finite at ε = 0.
#[inline]
pub(super) fn power(strain: f64, n: f64) -> (f64, f64) {
    if strain > CHORD_UP_TO {
        let value = strain.powf(n);
        return (value, n * value / strain);
    }
    let chord = CHORD_UP_TO.powf(n) / CHORD_UP_TO;
    (chord * strain, chord)
}

/// Checks what saturating laws share: 0 < σ₀ ≤ σ_s \[MPa\], a rate ≥ 0 and an exponent above 0 and up to 1 \[–\].
///
/// # Errors
/// When a parameter is out of range.
pub(super) fn saturating([initial, saturation, rate, exponent]: [f64; 4]) -> Result<(), LawError> {
    require("saturation", initial > 0.0 && saturation >= initial && saturation.is_finite(), || {
        format!("needs 0 < initial <= saturation, found {} and {} MPa", rounded(initial), rounded(saturation))
    })?;
    require("rate", rate >= 0.0 && rate.is_finite(), || format!("rate must not be negative, found {rate}"))?;
    require("exponent", exponent > 0.0 && exponent <= 1.0, || {
        format!("exponent must lie above 0 and up to 1, found {exponent}")
    })
}
