//! Swift's power law.

use super::{FlowStress, LawError, require};
use crate::units::rounded;

/// σ_y = K (ε₀ + ε̄)^n.
///
/// # References
/// H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1–18.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swift {
    k: f64,
    n: f64,
    offset: f64,
}

impl Swift {
    /// `k` \[MPa\], exponent `n` (0 ≤ n ≤ 1), offset strain `offset` > 0.
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn new(k: f64, n: f64, offset: f64) -> Result<Self, LawError> {
        require("k", k > 0.0 && k.is_finite(), || format!("k must be positive, found {k} MPa"))?;
        require("n", (0.0..=1.0).contains(&n), || format!("n must lie between 0 and 1, found {n}"))?;
        require("offset", (1e-6..=1.0).contains(&offset), || {
            format!("the offset strain must lie between 1e-6 and 1, found {offset:e}; 1e-4 to 1e-2 is usual")
        })?;
        Ok(Self { k, n, offset })
    }

    #[inline]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        let total = self.offset + strain;
        let stress = self.k * total.powf(self.n);
        FlowStress { stress, slope: self.n * stress / total }
    }

    pub(super) fn formula(&self) -> String {
        format!("σ = {} ({} + ε)^{} MPa", rounded(self.k), rounded(self.offset), rounded(self.n))
    }

    pub(super) fn describe(&self) -> String {
        format!("Swift, {}", self.formula())
    }
}
