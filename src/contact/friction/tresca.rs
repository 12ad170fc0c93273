//! Friction limited by the sheet's shear strength: τ = m k tanh(μ p/(m k)) φ(s), k = σ_y/√3 at the start of the step.

use super::{FrictionLaw, FrictionStress, Sliding};
use crate::material::law::prelude::*;

parameters! {
    /// Friction stress of at most a share of the sheet's shear yield stress k.
    ///
    /// Source: the combined law of Coulomb and constant shear friction, as I. Bobrovskij et al., Metals 12 (2022) 239, describes
    /// it; E. Orowan, Proc. Inst. Mech. Engrs. 150 (1943) 140–167 (not read), for min(μ p, k). The smooth passage is ours.
    pub struct Tresca {
        /// Share m of k, 0 to 1.
        pub factor: "As::<Fraction>" = 0.2,
        /// Coulomb's coefficient under light pressure; 1/√3, the largest that makes sense, when not given.
        #[serde(default = "bound")]
        pub coefficient: "As::<Fraction>" = 0.1,
    }
}

fn bound() -> f64 {
    Tresca::BOUND
}

impl Tresca {
    /// 1/√3: the coefficient at which the friction stress reaches k when the pressure reaches σ_y.
    pub const BOUND: f64 = 0.577_350_269_189_625_8;
}

impl FrictionLaw for Tresca {
    fn formula(&self) -> String {
        format!("{:.3} under light pressure, at most {} k", self.coefficient, self.factor)
    }

    fn at(&self, at: &Sliding) -> FrictionStress {
        let limit = self.factor * at.shear_yield;
        if limit <= 0.0 {
            return FrictionStress::default();
        }
        let share = (self.coefficient * at.pressure / limit).tanh();
        FrictionStress::regularised(limit * share, self.coefficient * (1.0 - share * share), at)
    }

    fn largest_coefficient(&self) -> f64 {
        self.coefficient
    }
}
