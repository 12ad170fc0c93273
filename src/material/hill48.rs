//! Normal anisotropy: Hill's quadratic yield condition for a sheet that is isotropic in its plane.
//!
//! ```text
//! σ̄² = σ_s² − 2 q σ_s σ_θ + σ_θ² + (3/k) σ_γ²,  q = r̄/(1 + r̄)          r̄ = 1 is Huber-Mises
//! Δε̄² = Δεᵀ A Δε,  A = P⁻¹ = [1 q 0; q 1 0; 0 0 k (1−q²)/3]/(1 − q²)   for P = [1 −q 0; −q 1 0; 0 0 3/k]
//! ```
//!
//! The transverse shear, in which sheet metal is hardly ever tested, keeps the value of Huber-Mises.
//!
//! # References
//! R. Hill, A theory of the yielding and plastic flow of anisotropic metals, Proc. R. Soc. London A 193 (1948) 281–297.

use super::yield_condition::{
    Layer, LayerMetric, MEAN_SQUARE, Metric, SHEAR_FACTOR, Symmetric, Triple, YieldCondition, dot,
};
use crate::material::law::{LawError, require_range};

/// Normal anisotropy of sheet metals, with room \[–\].
const RATIO: [f64; 2] = [0.1, 10.0];

/// Entries of A and P for the shear.
pub(super) const SHEAR: f64 = SHEAR_FACTOR / 3.0;
pub(super) const SHEAR_INVERSE: f64 = 3.0 / SHEAR_FACTOR;

/// The metric of the yield condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hill48 {
    /// r̄: width strain over thickness strain in tension \[–\].
    pub(crate) ratio: f64,
    /// q = r̄/(1 + r̄), off the diagonal of P \[–\].
    pub(super) coupling: f64,
    /// Entries of A in the plane: diagonal, off it.
    pub(super) direct: f64,
    pub(super) coupled: f64,
}

impl Default for Hill48 {
    fn default() -> Self {
        Self::new(1.0)
    }
}

impl Hill48 {
    /// For r̄ > 0.
    pub fn new(r: f64) -> Self {
        let coupling = r / (1.0 + r);
        let direct = (1.0 + r) * (1.0 + r) / (1.0 + 2.0 * r);
        Self { ratio: r, coupling, direct, coupled: coupling * direct }
    }

    /// For r̄ of sheet metals, with room: 0.1 to 10. Fails when it lies beyond.
    pub fn checked(r: f64) -> Result<Self, LawError> {
        require_range(["", "anisotropy"], r, RATIO, "0.6 to 0.8 for aluminium, 1 to 2 for steel").map(|()| Self::new(r))
    }

    /// A Δε.
    pub fn apply(&self, e: Triple) -> Triple {
        [self.direct * e[0] + self.coupled * e[1], self.coupled * e[0] + self.direct * e[1], SHEAR * e[2]]
    }

    fn matrix(&self) -> Symmetric {
        [self.direct, self.coupled, self.direct, 0.0, 0.0, SHEAR]
    }

    /// Equivalent stress √(σᵀ A⁻¹ σ) \[MPa\].
    pub fn equivalent_stress(&self, s: Triple) -> f64 {
        self.square(s).sqrt()
    }

    fn square(&self, s: Triple) -> f64 {
        s[0] * s[0] - 2.0 * self.coupling * s[0] * s[1] + s[1] * s[1] + SHEAR_INVERSE * s[2] * s[2]
    }
}

impl YieldCondition for Hill48 {
    fn metric_towards(&self, e: Triple, _: Option<[f64; 2]>) -> Metric {
        let gradient = self.apply(e);
        Metric { gradient, matrix: self.matrix(), square: dot(e, gradient) }
    }

    fn layer(&self, e: Triple, k: [f64; 2], _: Option<Layer>) -> LayerMetric {
        let (a, [ks, kt, _]) = (self.apply(e), self.apply([k[0], k[1], 0.0]).map(|b| MEAN_SQUARE * b));
        let (gradient, square) = ([a[0], a[1], ks, kt, a[2]], dot(e, a) + ks * k[0] + kt * k[1]);
        LayerMetric { gradient, own: self.matrix(), coupling: [0.0; 3], square }
    }

    fn stress_square(&self, _: &LayerMetric, [s, t, ms, mt, shear]: Layer) -> f64 {
        self.square([s, t, shear]) + self.square([ms, mt, 0.0]) / MEAN_SQUARE
    }
}
