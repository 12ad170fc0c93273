//! What every law of a thickness point answers.

use super::yield_condition::{Symmetric, Triple};

/// Constitutive law of a thickness point: the flow law or the elastoplastic law.
pub trait PointLaw {
    /// The point as the step finds it.
    type PointState;
    /// What it remembers from one iteration to the next.
    type Iterate;

    /// Stress, matrix and hardening increment at the strain increment `e`; moves the iterate on.
    fn respond(&self, point: &Self::PointState, iterate: &mut Self::Iterate, e: Triple) -> StressUpdate;

    /// The same where bending turns the flow about within the part of the thickness that the point stands for: the
    /// increment is `e` at the point and differs by ± `spread` at the ends of that part. `None` where the point by itself is
    /// right.
    #[inline]
    fn respond_across(
        &self,
        _point: &Self::PointState,
        _iterate: &mut Self::Iterate,
        _e: Triple,
        _spread: [f64; 2],
    ) -> Option<Across> {
        None
    }
}

/// Stress over a part of the thickness, its moment, and their derivatives by the strain and its spread: a matrix of five
/// rows and columns, of which only the parts are given,
///
/// ```text
/// C = [K K_x; K_x ⅓K] + g⊗h + h⊗g        K = [ss sθ 0; sθ θθ 0; 0 0 γγ], without its last row in ⅓K
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Across {
    /// Of the mean stress; its tangent is left empty.
    pub update: StressUpdate,
    /// What does work on the spread: the moment of the part over half its height, meridional and hoop \[MPa\].
    pub moment: [f64; 2],
    /// K: ss, sθ, θθ, γγ \[MPa\].
    pub metric: [f64; 4],
    /// K_x: ss, sθ, θθ \[MPa\]; `None` for a quadratic yield condition.
    pub coupling: Option<Triple>,
    /// g and h by ε_s, ε_θ, their spreads and γ \[–, MPa\].
    pub outer: [[f64; 5]; 2],
}

/// Stress, its derivative and the hardening increment that go with a strain increment.
#[derive(Clone, Copy, Debug, Default)]
pub struct StressUpdate {
    /// σ \[MPa\].
    pub stress: Triple,
    /// C = the block of the iteration matrix H, dσ/dΔε or its replacement \[MPa\]; empty where [`Across`] has it.
    pub tangent: Symmetric,
    /// Δε̄ \[–\].
    pub increment: f64,
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// Work in the step of what the stress varies by across the point's part of the thickness \[MPa\].
    pub work_across: f64,
}
