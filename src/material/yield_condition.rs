//! Strain increments, stresses and matrices of a thickness point, and the yield conditions that join them.

/// Shear correction factor of the Mindlin shell \[–\].
pub const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Strain increment or stress at a layer: meridional, hoop, transverse shear.
pub type Triple = [f64; 3];

/// Lower triangle of a symmetric 3 × 3 matrix: ss, sθ, θθ, sγ, θγ, γγ.
pub type Symmetric = [f64; 6];

#[inline]
pub(super) fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// What a yield condition makes of a strain increment: with D the plastic work per σ_y, ½ D² has the gradient A Δε and
/// the second derivative A. A quadratic condition has one A for all increments.
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    /// A Δε.
    pub gradient: Triple,
    /// A.
    pub matrix: Symmetric,
    /// D².
    pub square: f64,
}

/// A convex yield condition.
pub trait YieldCondition {
    /// Of the strain increment `e`.
    fn metric(&self, e: Triple) -> Metric;

    /// f A.
    #[inline]
    fn scaled(&self, metric: &Metric, f: f64) -> Symmetric {
        metric.matrix.map(|a| f * a)
    }

    /// A e' of another increment.
    #[inline]
    fn product(&self, metric: &Metric, e: Triple) -> Triple {
        let [ss, st, tt, sg, tg, gg] = metric.matrix;
        [ss * e[0] + st * e[1] + sg * e[2], st * e[0] + tt * e[1] + tg * e[2], sg * e[0] + tg * e[1] + gg * e[2]]
    }

    /// wᵀ A⁻¹ w \[MPa²\] of a carried stress.
    fn stress_square(&self, metric: &Metric, w: Triple) -> f64;

    /// Strain of the metal that bears the stress per D: more than 1 where there are voids.
    #[inline]
    fn strain_share(&self) -> f64 {
        1.0
    }
}
