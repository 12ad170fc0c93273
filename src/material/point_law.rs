//! Interface of the constitutive laws of a thickness point.

use super::yield_condition::{Layer, Symmetric, Triple};

/// Stress of a thickness point, and its derivatives.
pub type Response = (StressUpdate, Tangent);

/// Constitutive law of a thickness point: the flow law or the elastoplastic law.
pub trait PointLaw {
    /// State of the point at the start of the step.
    type PointState;
    /// Memory of the point from one iteration to the next.
    type Iterate;

    /// Stress and tangent at the strain increment `e`; moves the iterate on.
    /// The increment differs by ± `spread` over the point's part; elastoplastic and voided metal ignore it.
    fn respond(&self, point: &Self::PointState, iterate: &mut Self::Iterate, e: Triple, spread: [f64; 2]) -> Response;

    /// Snapshot of the last evaluation, which gave `update`.
    fn snapshot(&self, point: &Self::PointState, iterate: &Self::Iterate, update: &StressUpdate) -> PointSnapshot;
}

/// Thickness point in one evaluation of the corrector.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PointSnapshot {
    /// Δε_s, Δε_θ, Δγ \[–\].
    pub strain_increment: Triple,
    /// Δt ε̄̇ at the end of the step by the flow law, Δp by the elastoplastic law \[–\].
    pub equivalent_increment: f64,
    /// ε̄ at the end of the step \[–\].
    pub equivalent_strain: f64,
    /// σ_y at the end of the step \[MPa\].
    pub yield_stress: f64,
    /// σ \[MPa\].
    pub stress: Triple,
    /// μ = σ_y/(3 ε̄̇_reg) \[MPa s\]; `None` by the elastoplastic law.
    pub viscosity: Option<f64>,
    /// σ₀ + D Δε \[MPa\]; `None` by the flow law.
    pub trial_stress: Option<Triple>,
    /// C of the strains in the plane and the shear, by rows \[MPa\].
    pub tangent: [Triple; 3],
}

/// Stress of a thickness point and its hardening in the step.
#[derive(Clone, Copy, Debug, Default)]
pub struct StressUpdate {
    /// σ \[MPa\].
    pub stress: Triple,
    /// Moment over the point's part of the thickness, per half its height: meridional, hoop \[MPa\].
    pub moment: [f64; 2],
    /// Δε̄ \[–\].
    pub increment: f64,
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// Work of the moment in the step \[MPa\].
    pub work_across: f64,
}

impl StressUpdate {
    /// Snapshot of a point that began the step with the strain ε̄ = `start` \[–\].
    pub fn snapshot(&self, strain_increment: Triple, start: f64, tangent: &Tangent) -> PointSnapshot {
        PointSnapshot {
            strain_increment,
            equivalent_increment: self.increment,
            equivalent_strain: start + self.increment,
            yield_stress: self.yield_stress,
            stress: self.stress,
            viscosity: None,
            trial_stress: None,
            tangent: tangent.rows(),
        }
    }
}

/// Derivatives of stress and moment by the strain increment and its spread, or their replacement in the matrix:
///
/// ```text
/// C = [K K_x; K_x aK] + g⊗h + h⊗g        as in `LayerMetric`
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Tangent {
    /// K \[MPa\].
    pub own: Symmetric,
    /// K_x \[MPa\].
    pub coupling: Triple,
    /// a: mean square over the part of the thickness \[–\], or 0 where the law ignores the spread.
    pub across: f64,
    /// g and h \[–, MPa\].
    pub outer: [Layer; 2],
}

impl Tangent {
    /// C of the strains in the plane and the shear, by rows \[MPa\].
    pub fn rows(&self) -> [Triple; 3] {
        let Self { own: [ss, st, tt, sg, tg, gg], outer: [g, h], .. } = *self;
        let own = [[ss, st, sg], [st, tt, tg], [sg, tg, gg]];
        let at = [0, 1, 4];
        std::array::from_fn(|i| std::array::from_fn(|j| own[i][j] + g[at[i]] * h[at[j]] + h[at[i]] * g[at[j]]))
    }
}
