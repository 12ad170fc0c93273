//! Strain increments, stresses and matrices of a thickness point, and the yield conditions that join them.

/// Shear correction factor of the Mindlin shell \[–\].
pub const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Mean square of what goes evenly from −1 to 1 \[–\].
pub const MEAN_SQUARE: f64 = 1.0 / 3.0;

/// Strain increment or stress at a layer: meridional, hoop, transverse shear.
pub type Triple = [f64; 3];

/// Lower triangle of a symmetric 3 × 3 matrix: ss, sθ, θθ, sγ, θγ, γγ.
pub type Symmetric = [f64; 6];

#[inline(always)]
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

/// The same of a part of the thickness over which the strain increment varies evenly: with D² the mean over it, ½ D² has
/// this gradient by Δε and its spread k, and the second derivative
///
/// ```text
/// [K K_x; K_x ⅓K]        K = [ss sθ 0; sθ θθ 0; 0 0 γγ], without its last row in ⅓K
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// By Δε_s, Δε_θ, k_s, k_θ, Δγ.
    pub gradient: [f64; 5],
    /// K: ss, sθ, θθ, γγ.
    pub own: [f64; 4],
    /// K_x: ss, sθ, θθ; `None` for a quadratic condition, which has none.
    pub coupling: Option<Triple>,
    /// D².
    pub square: f64,
}

/// What an iteration keeps of a matrix: K and K_x of a [`Part`], or the first alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kept {
    pub own: [f64; 4],
    pub coupling: Option<Triple>,
}

/// Convex yield condition.
pub trait YieldCondition {
    /// Of the strain increment `e`.
    fn metric(&self, e: Triple) -> Metric;

    /// Of the strain increment `e`, with a matrix for an iteration that carries the stress `w`, of any size.
    #[inline(always)]
    fn metric_towards(&self, e: Triple, _w: [f64; 2]) -> Metric {
        self.metric(e)
    }

    /// What an iteration keeps of a matrix for the next one: nothing where it is as soon computed again.
    #[inline(always)]
    fn kept(&self, _: &Metric) -> Kept {
        Kept::default()
    }

    /// The last iteration's at its strain increment `e`.
    #[inline(always)]
    fn recalled(&self, _: &Kept, e: Triple) -> Metric {
        self.metric(e)
    }

    /// As [`Self::kept`].
    #[inline(always)]
    fn part_kept(&self, _: &Part) -> Kept {
        Kept::default()
    }

    /// As [`Self::recalled`].
    #[inline(always)]
    fn part_recalled(&self, _: &Kept, e: Triple, k: [f64; 2]) -> Part {
        self.part(e, k, None)
    }

    /// f A.
    #[inline(always)]
    fn scaled(&self, metric: &Metric, f: f64) -> Symmetric {
        metric.matrix.map(|a| f * a)
    }

    /// A e' of another increment.
    #[inline(always)]
    fn product(&self, metric: &Metric, e: Triple) -> Triple {
        let [ss, st, tt, sg, tg, gg] = metric.matrix;
        [ss * e[0] + st * e[1] + sg * e[2], st * e[0] + tt * e[1] + tg * e[2], sg * e[0] + tg * e[1] + gg * e[2]]
    }

    /// Of what goes evenly from `e` − `k` to `e` + `k`, by Gauss's two points; in an iteration that carries the stress and the
    /// moment `w` as [`Self::metric_towards`].
    #[inline(always)]
    fn part(&self, e: Triple, k: [f64; 2], w: Option<[f64; 5]>) -> Part {
        let root = MEAN_SQUARE.sqrt();
        let at = |root: f64| {
            let point = [e[0] + k[0] * root, e[1] + k[1] * root, e[2]];
            let Some([s, t, ks, kt, _]) = w else { return self.metric(point) };
            self.metric_towards(point, [s + ks * (1.0 / root), t + kt * (1.0 / root)])
        };
        let (above, below) = (at(root), at(-root));
        let mean = |i: usize| (above.gradient[i] + below.gradient[i]) * 0.5;
        let odd = 0.5 * root;
        let turning = |i: usize| (above.gradient[i] - below.gradient[i]) * odd;
        let own = |j: usize| (above.matrix[j] + below.matrix[j]) * 0.5;
        let coupling = |j: usize| (above.matrix[j] - below.matrix[j]) * odd;
        Part {
            gradient: [mean(0), mean(1), turning(0), turning(1), mean(2)],
            own: [own(0), own(1), own(2), own(5)],
            coupling: Some([coupling(0), coupling(1), coupling(2)]),
            square: (above.square + below.square) * 0.5,
        }
    }

    /// The part's matrix times another increment and spread.
    #[inline(always)]
    fn part_product(&self, part: &Part, e: Triple, k: [f64; 2]) -> [f64; 5] {
        let plane = |[ss, st, tt]: Triple, v: [f64; 2]| [ss * v[0] + st * v[1], st * v[0] + tt * v[1]];
        let [ss, st, tt, shear] = part.own;
        let (own, even) = ([ss, st, tt], [e[0], e[1]]);
        let (a, d) = (plane(own, even), plane(own, k));
        let mut product = [a[0], a[1], d[0] * MEAN_SQUARE, d[1] * MEAN_SQUARE, shear * e[2]];
        if let Some(coupling) = part.coupling {
            let (b, c) = (plane(coupling, k), plane(coupling, even));
            for i in 0..2 {
                product[i] = product[i] + b[i];
                product[i + 2] = c[i] + product[i + 2];
            }
        }
        product
    }

    /// wᵀ A⁻¹ w \[MPa²\] of a carried stress and moment, by the part's matrix.
    #[inline(always)]
    fn part_square(&self, part: &Part, w: [f64; 5]) -> f64 {
        // Of both points: A = K ± √3 K_x, w = stress ± √3 moment.
        let root = MEAN_SQUARE.sqrt().recip();
        let coupling = part.coupling.unwrap_or([0.0; 3]);
        let at = |sign: f64| {
            let [ss, st, tt] = [0, 1, 2].map(|j| part.own[j] + coupling[j] * (sign * root));
            let [s, t] = [0, 1].map(|i| w[i] + w[i + 2] * (sign * root));
            (tt * s * s - st * s * t * 2.0 + ss * t * t) / (ss * tt - st * st)
        };
        (at(1.0) + at(-1.0)) * 0.5 + w[4] * w[4] / part.own[3]
    }

    /// wᵀ A⁻¹ w \[MPa²\] of a carried stress.
    fn stress_square(&self, metric: &Metric, w: Triple) -> f64;

    /// Strain of the metal that bears the stress per D: more than 1 where there are voids.
    #[inline(always)]
    fn strain_share(&self) -> f64 {
        1.0
    }
}
