//! Yield stress with its slope, and the formulas that several hardening laws share.

use crate::material::{Rate, law::LawError, law::require};
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
    pub(super) fn towards(self, other: Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self { stress: between(self.stress, other.stress), slope: between(self.slope, other.slope) }
    }

    /// Flow stress times the factor of a rate law; `by_increment` is the derivative of the rate by the strain increment \[1/s\].
    pub(in crate::material) fn at_rate(self, law: Option<&Rate>, rate: f64, by_increment: f64) -> Self {
        let Some(law) = law else { return self };
        let factor = law.at(rate);
        let slope = self.slope * factor.value + self.stress * (factor.slope * by_increment);
        Self { stress: self.stress * factor.value, slope }
    }

    pub(in crate::material) fn times(self, factor: f64) -> Self {
        Self { stress: factor * self.stress, slope: factor * self.slope }
    }
}

/// Strain below which ε^n is replaced by its chord from the origin: its slope at 0 is infinite for n < 1 \[–\].
const CHORD_UP_TO: f64 = 1e-6;

/// ε^n and its derivative, finite at ε = 0.
pub(super) fn power(strain: f64, n: f64) -> (f64, f64) {
    if strain > CHORD_UP_TO {
        let value = strain.powf(n);
        return (value, n * value / strain);
    }
    let chord = CHORD_UP_TO.powf(n) / CHORD_UP_TO;
    (chord * strain, chord)
}

/// σ = k (offset + ε)^n and its slope.
pub(super) fn offset_power(k: f64, offset: f64, n: f64, strain: f64) -> FlowStress {
    let total = strain + offset;
    let stress = k * total.powf(n);
    FlowStress { stress, slope: stress * n / total }
}

/// σ = σ_s − (σ_s − σ₀) exp(−rate x) and its slope, where x is a power of the strain and x' its derivative.
pub(super) fn saturating(initial: f64, saturation: f64, rate: f64, (x, slope): (f64, f64)) -> FlowStress {
    let rest = (saturation - initial) * (-rate * x).exp();
    FlowStress { stress: saturation - rest, slope: rest * rate * slope }
}

/// Checks 0 < σ₀ ≤ σ_s \[MPa\], a rate ≥ 0 and an exponent above 0 and up to 1 \[–\] of a saturating law.
pub(super) fn check_saturating([initial, saturation, rate, exponent]: [f64; 4]) -> Result<(), LawError> {
    require("saturation", initial > 0.0 && saturation >= initial && saturation.is_finite(), || {
        format!("needs 0 < initial <= saturation, found {} and {} MPa", rounded(initial), rounded(saturation))
    })?;
    require("rate", rate >= 0.0 && rate.is_finite(), || format!("rate must not be negative, found {rate}"))?;
    require("exponent", exponent > 0.0 && exponent <= 1.0, || format!("exponent must be in (0, 1], found {exponent}"))
}
