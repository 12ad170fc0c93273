//! Coulomb's friction: the stress is a fixed share of the pressure.

use super::{Drag, FrictionLaw, Sliding, direction};
use crate::material::law::prelude::*;
use crate::numerics::Real;

/// τ = μ p φ(s). A case writes it as a plain number, μ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    /// μ \[–\].
    pub coefficient: f64,
}

impl From<f64> for Coulomb {
    fn from(coefficient: f64) -> Self {
        Self { coefficient }
    }
}

impl Coulomb {
    /// Of one point or of several.
    #[inline(always)]
    pub(super) fn drag<T: Real>(&self, pressure: T, slip: T, scale: f64) -> Drag<T> {
        let phi = direction(slip, scale);
        let full = pressure * self.coefficient;
        Drag { value: full * phi.value, by_pressure: phi.value * self.coefficient, by_slip: full * phi.slope }
    }
}

impl Law for Coulomb {
    fn examples() -> Vec<Self> {
        vec![Self { coefficient: 0.12 }]
    }

    fn formula(&self) -> String {
        self.coefficient.to_string()
    }
}

impl FrictionLaw for Coulomb {
    #[inline]
    fn at(&self, at: &Sliding) -> Drag {
        self.drag(at.pressure, at.slip, at.scale)
    }

    fn largest_coefficient(&self) -> f64 {
        self.coefficient
    }
}
