//! Kinematic hardening: back-stresses that shift the yield surface, for metal that is bent and bent back.
//!
//! ```text
//! dα = C ξ/σ_R dε̄ − γ α dε̄,  ξ = σ − α: the yield surface σ̄(ξ) = σ_R moves with its middle at α = Σ α_i
//! ```
//!
//! This is the plane-stress form: for Huber-Mises it is dα' = ⅔ C dε_p − γ α' dε̄ of the deviator. In tension the stress
//! comes to σ_R + Σ C/γ (1 − exp(−γ ε̄)).
//!
//! # References
//! J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188; the form with one back-stress: P. J. Armstrong, C. O. Frederick,
//! CEGB report RD/B/N731 (1966) (both not read; the form is in common use).

/// One back-stress.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BackStress {
    /// C ≥ 0 \[MPa\].
    pub modulus: f64,
    /// γ ≥ 0, the recall \[–\]; 0 is Prager's linear hardening.
    pub dynamic_recovery: f64,
}

/// Up to two back-stresses; none where all moduli are 0.
pub type BackStresses = [BackStress; 2];

/// The back-stresses, where any modulus says that there are some.
pub fn shifting(kinematic: BackStresses) -> Option<BackStresses> {
    kinematic.iter().any(|law| law.modulus > 0.0).then_some(kinematic)
}
