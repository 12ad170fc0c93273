//! Coulomb's friction: the stress is a fixed share of the pressure.

use super::{FrictionLaw, FrictionStress, Sliding};
use crate::material::law::Example;

/// τ = μ p φ(s). A case writes it as a plain number, μ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    /// μ \[–\].
    pub coefficient: f64,
}

impl Example for Coulomb {
    fn example() -> Self {
        Self { coefficient: 0.12 }
    }
}

impl FrictionLaw for Coulomb {
    fn formula(&self) -> String {
        self.coefficient.to_string()
    }

    fn at(&self, at: &Sliding) -> FrictionStress {
        FrictionStress::regularised(self.coefficient * at.pressure, self.coefficient, at)
    }

    fn largest_coefficient(&self) -> f64 {
        self.coefficient
    }
}
