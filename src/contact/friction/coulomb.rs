//! Coulomb's friction: the stress is a fixed share of the pressure.

use super::{Drag, Sliding, direction};

/// τ = μ p φ(s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    /// μ \[–\].
    pub coefficient: f64,
}

impl Coulomb {
    /// The friction stress and its derivatives.
    #[inline]
    pub fn at(&self, at: &Sliding) -> Drag {
        let phi = direction(at.slip, at.scale);
        let full = self.coefficient * at.pressure;
        Drag { value: full * phi.value, by_pressure: self.coefficient * phi.value, by_slip: full * phi.slope }
    }
}
