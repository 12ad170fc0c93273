//! Coulomb's friction, regularised on the slip of the step.

use crate::contact::penalty::Smooth;

/// T = −μ N s/√(s² + s₀²), with s the slip of the step relative to the tool.
///
/// s₀ is a sliding speed times the step's duration, so that the law does not depend on the step. A node that should
/// stick creeps instead, slower than that speed.
///
/// # References
/// The plasticity analogy and its tangent: Perić, Owen, Computational model for 3D contact problems with friction
/// based on the penalty method (1991).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    /// μ \[–\].
    pub coefficient: f64,
    /// s₀ \[mm\].
    pub slip: f64,
}

impl Coulomb {
    /// −T/N and its derivative by the slip \[1/mm\] at the slip `s` \[mm\].
    #[inline]
    pub fn at(&self, s: f64) -> Smooth {
        let root = (s * s + self.slip * self.slip).sqrt();
        let value = self.coefficient * s / root;
        Smooth { value, slope: self.coefficient * self.slip * self.slip / (root * root * root) }
    }
}
