//! The flow law where a thickness point stands for a part of the thickness that bending turns about.

use super::{Across, FlowLaw, Iterate, Iteration, MEAN_SQUARE, Past, PointState, StressUpdate, Triple, dot};
use crate::material::{FlowStress, Hill48};

impl Iterate {
    /// Where bending turns the flow about within the point's part of the thickness the stress jumps: a point by itself would
    /// stick to the jump, and bear any tension without stretching. With k the strain of bending over half the part, the root
    /// mean square of the strain over it
    ///
    /// ```text
    /// P² = Δεᵀ A Δε + ⅓ kᵀ A k + Δε₀²,   σ = σ_y ∂P/∂Δε = σ_y/P A Δε,   m = σ_y ∂P/∂k = σ_y/P ⅓ A k
    /// ```
    ///
    /// stands for the mean: a quadratic norm of both, so that stress, moment and matrices are those of a point with five
    /// strains. `None` for a sheet with voids.
    #[inline]
    pub(super) fn advance_across(
        &mut self,
        law: &FlowLaw,
        point: &PointState,
        strain: Triple,
        bending: [f64; 2],
    ) -> Option<Across> {
        if law.voids.is_some() {
            return None;
        }
        let Past { weight, strain: past, spread: past_spread, equivalent } = point.past;
        let steep = 1.0 + weight;
        let e = [steep * strain[0] - past[0], steep * strain[1] - past[1], steep * strain[2] - past[2]];
        let spread = [steep * bending[0] - past_spread[0], steep * bending[1] - past_spread[1]];
        let hill = &law.anisotropy;
        let a = hill.apply(e);
        let q = MEAN_SQUARE * hill.direct;
        let r = MEAN_SQUARE * hill.coupled;
        let b = [q * spread[0] + r * spread[1], r * spread[0] + q * spread[1]];
        let square = dot(e, a) + b[0] * spread[0] + b[1] * spread[1];
        let increment = square.sqrt();
        let inverse_square = 1.0 / (square + law.cutoff * law.cutoff);
        let inverse = inverse_square.sqrt();
        let hardening = (increment + equivalent) / steep;
        let FlowStress { stress: yield_stress, slope } =
            law.yielding(point, hardening, steep, increment, 1.0 / inverse, increment * inverse);
        let f = yield_stress * inverse;
        let h = if increment > 0.0 { slope * inverse / increment } else { 0.0 };
        let stress = a.map(|a| f * a);
        let moment = b.map(|b| f * b);
        let g = [a[0], a[1], a[2], b[0], b[1]];
        let half = 0.5 * steep;
        let other = match law.matrix {
            Iteration::Secant => [0.0; 5],
            Iteration::Newton => g.map(|g| half * (h - f * inverse_square) * g),
            Iteration::PrimalDual => {
                let w = self.carried_across(law, e, spread, yield_stress);
                self.carried = [w[0], w[1], w[2]];
                self.carried_moment = [w[3], w[4]];
                let by = |i: usize| half * (h * g[i] - inverse_square * w[i]);
                [by(0), by(1), by(2), by(3), by(4)]
            }
        };
        let work_across = moment[0] * bending[0] + moment[1] * bending[1];
        *self = Self { strain, flow: e, spread, fluidity: f, hardening: h, inverse_square, ..*self };
        let update = StressUpdate { stress, tangent: [0.0; 6], increment: hardening, yield_stress, work_across };
        let metric = [hill.direct, hill.coupled, hill.shear].map(|entry| steep * f * entry);
        Some(Across { update, moment, metric, outer: [g, other] })
    }

    /// The same of stress and moment.
    #[inline]
    fn carried_across(&self, law: &FlowLaw, e: Triple, spread: [f64; 2], yield_stress: f64) -> [f64; 5] {
        let hill = &law.anisotropy;
        let mut w = [self.carried[0], self.carried[1], self.carried[2], self.carried_moment[0], self.carried_moment[1]];
        if self.fluidity > 0.0 {
            let of = |e: Triple, k: [f64; 2]| {
                let (a, b) = (hill.apply(e), hill.apply([k[0], k[1], 0.0]));
                [a[0], a[1], a[2], MEAN_SQUARE * b[0], MEAN_SQUARE * b[1]]
            };
            let de = [e[0] - self.flow[0], e[1] - self.flow[1], e[2] - self.flow[2]];
            let dk = [spread[0] - self.spread[0], spread[1] - self.spread[1]];
            let (g, c) = (of(self.flow, self.spread), of(de, dk));
            let product = |v: &[f64; 5]| v[0] * de[0] + v[1] * de[1] + v[2] * de[2] + v[3] * dk[0] + v[4] * dk[1];
            let along = product(&g);
            let on_g = self.fluidity + self.hardening * along - 0.5 * self.inverse_square * product(&w);
            let on_w = -0.5 * self.inverse_square * along;
            for i in 0..5 {
                w[i] = on_g * g[i] + on_w * w[i] + self.fluidity * c[i];
            }
        }
        let square = Hill48::stress_square(hill, [w[0], w[1], w[2]])
            + Hill48::stress_square(hill, [w[3], w[4], 0.0]) / MEAN_SQUARE;
        if square > yield_stress * yield_stress {
            let back = yield_stress / square.sqrt();
            return w.map(|w| back * w);
        }
        w
    }
}
