//! Kinematic hardening: back-stresses that shift the yield surface, for metal that is bent and bent back.
//!
//! ```text
//! dα = C ξ/σ_R dε̄ − γ α dε̄,  ξ = σ − α: the yield surface σ̄(ξ) = σ_R moves with its middle at α = Σ α_i
//! ```
//!
//! In plane stress: for Huber-Mises dα' = ⅔ C dε_p − γ α' dε̄ of the deviator, in tension σ_R + Σ C/γ (1 − exp(−γ ε̄)).
//!
//! # References
//! J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188; the form with one back-stress: P. J. Armstrong, C. O. Frederick,
//! CEGB report RD/B/N731 (1966) (both not read; the form is in common use).

use super::FlowStress;
use crate::material::law::prelude::*;

parameters! {
    /// A back-stress.
    #[derive(Default)]
    pub struct BackStress {
        /// C: its first slope over the plastic strain \[MPa\].
        pub modulus: "As::<Positive<Stress>>" = "2500 MPa",
        /// γ, its dynamic recovery: it comes to C/γ; 0 when not given, which is Prager's linear hardening.
        #[serde(rename = "recall")]
        #[serde(default)]
        pub dynamic_recovery: "As::<NonNegative<Number>>" = 30,
    }
}

impl BackStress {
    /// Its share of the stress of tension at a plastic strain, and its slope: C/γ (1 − exp(−γ ε̄)) and C exp(−γ ε̄) \[MPa\].
    pub fn in_tension(&self, strain: f64) -> FlowStress {
        let Self { modulus, dynamic_recovery } = *self;
        let come = -(-dynamic_recovery * strain).exp_m1();
        let length = if dynamic_recovery > 0.0 { come / dynamic_recovery } else { strain };
        FlowStress { stress: modulus * length, slope: modulus * (1.0 - come) }
    }
}

/// Up to two back-stresses; none where all moduli are 0.
pub type BackStresses = [BackStress; 2];

/// The back-stresses, where any modulus says that there are some.
pub fn shifting(kinematic: BackStresses) -> Option<BackStresses> {
    kinematic.iter().any(|law| law.modulus > 0.0).then_some(kinematic)
}
