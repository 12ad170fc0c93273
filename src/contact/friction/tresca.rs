//! Friction limited by the sheet's shear strength.

use super::{Drag, Sliding, direction};

/// τ = m k tanh(μ p/(m k)) φ(s): Coulomb's law under light pressure, never more than the share m of the sheet's shear
/// yield stress k = σ_y/√3.
///
/// k is that of the start of the step.
///
/// # References
/// The combined law of Coulomb and constant shear friction, as I. Bobrovskij et al., Metals 12 (2022) 239, describes it; not
/// read: E. Orowan, Proc. Inst. Mech. Engrs. 150 (1943) 140–167, for min(μ p, k). The smooth passage between is ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tresca {
    /// m, 0 to 1 \[–\].
    pub factor: f64,
    /// μ under light pressure \[–\].
    pub coefficient: f64,
}

impl Tresca {
    /// 1/√3: the coefficient at which the friction stress reaches k when the pressure reaches σ_y.
    pub const BOUND: f64 = 0.577_350_269_189_625_8;

    /// The friction stress and its derivatives.
    #[inline]
    pub fn at(&self, at: &Sliding) -> Drag {
        let phi = direction(at.slip, at.scale);
        let limit = self.factor * at.shear_yield;
        if limit <= 0.0 {
            return Drag::default();
        }
        let share = (self.coefficient * at.pressure / limit).tanh();
        Drag {
            value: limit * share * phi.value,
            by_pressure: self.coefficient * (1.0 - share * share) * phi.value,
            by_slip: limit * share * phi.slope,
        }
    }

    /// The law in words and numbers.
    pub fn describe(&self) -> String {
        format!("{:.3} under light pressure, at most {} k", self.coefficient, self.factor)
    }
}
