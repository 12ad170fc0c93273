//! Ludwik's law.

use super::{FlowStress, LawError, power, require};
use crate::units::rounded;

/// σ_y = σ₀ + K ε̄^n.
///
/// # References
/// P. Ludwik, Elemente der technologischen Mechanik, Springer, Berlin (1909).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ludwik {
    initial: f64,
    k: f64,
    n: f64,
}

impl Ludwik {
    /// `initial` yield stress σ₀ > 0 \[MPa\], `k` ≥ 0 \[MPa\], 0 < n ≤ 1.
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn new(initial: f64, k: f64, n: f64) -> Result<Self, LawError> {
        require("initial", initial > 0.0 && initial.is_finite(), || {
            format!("the initial yield stress must be positive, found {initial} MPa")
        })?;
        require("k", k >= 0.0 && k.is_finite(), || format!("k must not be negative, found {k} MPa"))?;
        require("n", n > 0.0 && n <= 1.0, || format!("n must lie above 0 and up to 1, found {n}"))?;
        Ok(Self { initial, k, n })
    }

    #[inline]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        let (value, slope) = power(strain, self.n);
        FlowStress { stress: self.initial + self.k * value, slope: self.k * slope }
    }

    pub(super) fn describe(&self) -> String {
        format!("Ludwik, σ = {} + {} ε^{} MPa", rounded(self.initial), rounded(self.k), rounded(self.n))
    }
}
