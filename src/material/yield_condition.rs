//! Strain increments, stresses and matrices of a thickness point, and the yield conditions that relate them.

/// Shear correction factor of the Mindlin shell \[–\].
pub const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Mean square of a linear function from −1 to 1 \[–\].
pub const MEAN_SQUARE: f64 = 1.0 / 3.0;

/// Strain increment or stress at a layer: meridional, hoop, transverse shear.
pub type Triple = [f64; 3];

/// Strain increment or stress of a part of the thickness: meridional, hoop, their spreads over the part, transverse shear.
pub type Layer = [f64; 5];

/// Lower triangle of a symmetric 3 × 3 matrix: ss, sθ, θθ, sγ, θγ, γγ.
pub type Symmetric = [f64; 6];

pub(super) fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Gradient A Δε and second derivative A of ½D², with D the plastic work per σ_y of a strain increment.
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    /// A Δε.
    pub gradient: Triple,
    /// A.
    pub matrix: Symmetric,
    /// D².
    pub square: f64,
}

/// Gradient and second derivative of ½D², D² the mean over strain increments from e − k to e + k:
///
/// ```text
/// [K K_x; K_x ⅓K] by (e, k)        ⅓K without the shear, which has no spread
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct LayerMetric {
    /// By Δε_s, Δε_θ, k_s, k_θ, Δγ.
    pub gradient: Layer,
    /// K.
    pub own: Symmetric,
    /// K_x: ss, sθ, θθ; zero for a quadratic condition.
    pub coupling: Triple,
    /// D².
    pub square: f64,
}

impl LayerMetric {
    /// The matrix times another increment.
    pub fn product(&self, [s, t, ks, kt, g]: Layer) -> Layer {
        let ([ss, st, tt, sg, tg, gg], [xx, xy, yy]) = (self.own, self.coupling);
        [
            ss * s + st * t + sg * g + xx * ks + xy * kt,
            st * s + tt * t + tg * g + xy * ks + yy * kt,
            MEAN_SQUARE * (ss * ks + st * kt) + xx * s + xy * t,
            MEAN_SQUARE * (st * ks + tt * kt) + xy * s + yy * t,
            sg * s + tg * t + gg * g,
        ]
    }
}

/// Convex yield condition.
pub trait YieldCondition {
    /// Metric of the strain increment `e`, with a matrix for an iteration that may carry a stress `w`, of any size.
    fn metric_towards(&self, e: Triple, w: Option<[f64; 2]>) -> Metric;

    /// Metric of the strain increment `e`.
    fn metric(&self, e: Triple) -> Metric {
        self.metric_towards(e, None)
    }

    /// Metric of a part from `e` − `k` to `e` + `k` by Gauss's points; `w` as in [`Self::metric_towards`].
    fn layer(&self, e: Triple, k: [f64; 2], w: Option<Layer>) -> LayerMetric {
        let root = MEAN_SQUARE.sqrt();
        let at = |root: f64, inverse: f64| {
            let point = [e[0] + root * k[0], e[1] + root * k[1], e[2]];
            self.metric_towards(point, w.map(|[s, t, ks, kt, _]| [s + inverse * ks, t + inverse * kt]))
        };
        if k == [0.0; 2] {
            let Metric { gradient: [s, t, shear], matrix, square } = at(0.0, 0.0);
            return LayerMetric { gradient: [s, t, 0.0, 0.0, shear], own: matrix, coupling: [0.0; 3], square };
        }
        let (above, below) = (at(root, 1.0 / root), at(-root, -1.0 / root));
        let mean = |i: usize| 0.5 * (above.gradient[i] + below.gradient[i]);
        let turning = |i: usize| 0.5 * root * (above.gradient[i] - below.gradient[i]);
        let gradient = [mean(0), mean(1), turning(0), turning(1), mean(2)];
        let own = std::array::from_fn(|j| 0.5 * (above.matrix[j] + below.matrix[j]));
        let coupling = [0, 1, 2].map(|j| 0.5 * root * (above.matrix[j] - below.matrix[j]));
        LayerMetric { gradient, own, coupling, square: 0.5 * (above.square + below.square) }
    }

    /// wᵀ A⁻¹ w \[MPa²\] of a carried stress, by the metric's matrix at Gauss's two points.
    fn stress_square(&self, metric: &LayerMetric, [s, t, ms, mt, shear]: Layer) -> f64 {
        let at = |root: f64| {
            let [ss, st, tt] = [0, 1, 2].map(|j| metric.own[j] + root * metric.coupling[j]);
            let [.., sg, tg, gg] = metric.own;
            inverse_square([ss, st, tt, sg, tg, gg], [s + root * ms, t + root * mt, shear])
        };
        let root = MEAN_SQUARE.sqrt().recip();
        if [ms, mt] == [0.0; 2] && metric.coupling == [0.0; 3] { at(0.0) } else { 0.5 * (at(root) + at(-root)) }
    }

    /// Strain of the metal that bears the stress, per D: more than 1 with voids.
    fn strain_share(&self) -> f64 {
        1.0
    }

    /// Equivalent strain increment Δε̄ of the metal \[–\].
    fn equivalent_increment(&self, e: Triple) -> f64 {
        self.strain_share() * self.metric(e).square.sqrt()
    }

    /// ∂D/∂Δε: the stress of a strain increment over the yield stress \[–\]; zero for no increment.
    fn stress(&self, e: Triple) -> Triple {
        let Metric { gradient, square, .. } = self.metric(e);
        if square == 0.0 { [0.0; 3] } else { gradient.map(|s| s / square.sqrt()) }
    }
}

/// wᵀ A⁻¹ w of a positive definite A.
fn inverse_square([ss, st, tt, sg, tg, gg]: Symmetric, [s, t, g]: Triple) -> f64 {
    // What is left of A and w once γ is eliminated.
    let (by_s, by_t) = (sg / gg, tg / gg);
    let (ss, st, tt) = (ss - sg * by_s, st - sg * by_t, tt - tg * by_t);
    let (s, t, determinant) = (s - by_s * g, t - by_t * g, ss * tt - st * st);
    let square = (tt * s * s - 2.0 * st * s * t + ss * t * t) / determinant + g * g / gg;
    if gg > 0.0 && ss > 0.0 && determinant > 0.0 { square } else { f64::INFINITY }
}

/// Central differences ∂f_i/∂x_j with the step `h`.
#[cfg(test)]
pub(super) fn differences<const N: usize>(x: [f64; N], h: f64, f: impl Fn([f64; N]) -> [f64; N]) -> [[f64; N]; N] {
    let shifted = |j: usize, h: f64| f(std::array::from_fn(|i| if i == j { x[i] + h } else { x[i] }));
    let columns: [_; N] = std::array::from_fn(|j| (shifted(j, h), shifted(j, -h)));
    std::array::from_fn(|i| columns.map(|(plus, minus)| (plus[i] - minus[i]) / (2.0 * h)))
}

#[cfg(test)]
pub(super) fn rows([ss, st, tt, sg, tg, gg]: Symmetric) -> [Triple; 3] {
    [[ss, st, sg], [st, tt, tg], [sg, tg, gg]]
}
