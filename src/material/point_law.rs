//! What every law of a thickness point answers.

use super::yield_condition::{Symmetric, Triple};

/// What a thickness point answers to a strain increment: the flow law or the elastoplastic law.
pub trait PointLaw {
    /// The point as the step finds it.
    type PointState;
    /// What it remembers from one iteration to the next.
    type Iterate;

    /// Stress, matrix and hardening increment at the strain increment `e`; moves the iterate on.
    fn respond(&self, point: &Self::PointState, iterate: &mut Self::Iterate, e: Triple) -> StressUpdate;
}

/// Stress, its derivative and the hardening increment that go with a strain increment.
#[derive(Clone, Copy, Debug)]
pub struct StressUpdate {
    /// σ \[MPa\].
    pub stress: Triple,
    /// C = the block of the iteration matrix H, dσ/dΔε or its replacement \[MPa\].
    pub tangent: Symmetric,
    /// Δε̄ \[–\].
    pub increment: f64,
    /// σ_y \[MPa\].
    pub yield_stress: f64,
}
