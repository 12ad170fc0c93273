//! Interface of the constitutive laws of a thickness point.

use super::yield_condition::{Layer, Symmetric, Triple};

/// Constitutive law of a thickness point: the flow law or the elastoplastic law.
pub trait PointLaw {
    /// State of the point at the start of the step.
    type PointState;
    /// Memory of the point from one iteration to the next.
    type Iterate;

    /// Stress and tangent at the strain increment `e`; moves the iterate on.
    ///
    /// The increment differs by ± `spread` at the ends of the part of the thickness that the point stands for; the
    /// elastoplastic law and voided metal ignore it.
    fn respond(
        &self,
        point: &Self::PointState,
        iterate: &mut Self::Iterate,
        e: Triple,
        spread: [f64; 2],
    ) -> (StressUpdate, Tangent);
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
