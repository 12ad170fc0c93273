//! The flow law where a thickness point stands for a part of the thickness that bending turns about.

use super::{
    Across, FlowLaw, Iterate, Iteration, MEAN_SQUARE, Metric, Past, PointState, StressUpdate, Triple, YieldCondition,
};
use crate::material::{FlowStress, Hosford, YieldCriterion};

impl Iterate {
    /// Where bending turns the flow about within the point's part of the thickness the stress jumps: a point by itself would
    /// stick to the jump, and bear any tension without stretching. With k the strain of bending over half the part, the root
    /// mean square of the strain over it
    ///
    /// ```text
    /// P² = Δε̄²(Δε) + ⅓ Δε̄²(k) + Δε₀²,   σ = σ_y ∂P/∂Δε = σ_y/P A Δε,   m = σ_y ∂P/∂k = σ_y/P ⅓ A' k
    /// ```
    ///
    /// stands for the mean, so that stress, moment and matrices are those of a point with five strains; A is that of Δε, A'
    /// that of k. For Hill's condition, where they are one, P is the root mean square; for Hosford's it is as convex, and the
    /// root mean square where k is a multiple of Δε. `None` for a sheet with voids.
    #[inline]
    pub(super) fn advance_across(
        &mut self,
        law: &FlowLaw,
        point: &PointState,
        strain: Triple,
        bending: [f64; 2],
    ) -> Option<Across> {
        match (law.voids, &law.criterion) {
            (Some(_), _) => None,
            (None, YieldCriterion::Hill48(hill)) => Some(self.flow_across(law, hill, point, strain, bending)),
            (None, YieldCriterion::Hosford(hosford)) => {
                Some(self.flow_across_by_hosford(law, hosford, point, strain, bending))
            }
        }
    }

    /// Apart from Hill's, so that that one stays small where it is called.
    #[inline(never)]
    fn flow_across_by_hosford(
        &mut self,
        law: &FlowLaw,
        hosford: &Hosford,
        point: &PointState,
        strain: Triple,
        bending: [f64; 2],
    ) -> Across {
        self.flow_across(law, hosford, point, strain, bending)
    }

    #[inline(always)]
    fn flow_across(
        &mut self,
        law: &FlowLaw,
        condition: &impl YieldCondition,
        point: &PointState,
        strain: Triple,
        bending: [f64; 2],
    ) -> Across {
        let Past { weight, strain: past, spread: past_spread, equivalent } = point.past;
        let steep = 1.0 + weight;
        let e = [steep * strain[0] - past[0], steep * strain[1] - past[1], steep * strain[2] - past[2]];
        let spread = [steep * bending[0] - past_spread[0], steep * bending[1] - past_spread[1]];
        let metric = condition.metric(e);
        let turning = condition.metric([spread[0], spread[1], 0.0]);
        let a = metric.gradient;
        let b = [0, 1].map(|d| MEAN_SQUARE * turning.gradient[d]);
        let square = metric.square + b[0] * spread[0] + b[1] * spread[1];
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
                let w = self.carried_across(condition, (&metric, &turning), e, spread, yield_stress);
                self.carried = [w[0], w[1], w[2]];
                self.carried_moment = [w[3], w[4]];
                let by = |i: usize| half * (h * g[i] - inverse_square * w[i]);
                [by(0), by(1), by(2), by(3), by(4)]
            }
        };
        let work_across = moment[0] * bending[0] + moment[1] * bending[1];
        *self = Self { strain, flow: e, spread, fluidity: f, hardening: h, inverse_square, ..*self };
        let update = StressUpdate { stress, tangent: [0.0; 6], increment: hardening, yield_stress, work_across };
        let [ss, st, tt, .., shear] = metric.matrix;
        let own = [ss, st, tt, shear].map(|entry| steep * f * entry);
        let excess = [0, 1, 2].map(|j| steep * f * (turning.matrix[j] - metric.matrix[j]));
        Across { update, moment, metric: own, excess, outer: [g, other] }
    }

    /// The same of stress and moment.
    #[inline]
    fn carried_across(
        &self,
        condition: &impl YieldCondition,
        (now, turning): (&Metric, &Metric),
        e: Triple,
        spread: [f64; 2],
        yield_stress: f64,
    ) -> [f64; 5] {
        let mut w = [self.carried[0], self.carried[1], self.carried[2], self.carried_moment[0], self.carried_moment[1]];
        if self.fluidity > 0.0 {
            let both = |a: Triple, b: Triple| [a[0], a[1], a[2], MEAN_SQUARE * b[0], MEAN_SQUARE * b[1]];
            let de = [e[0] - self.flow[0], e[1] - self.flow[1], e[2] - self.flow[2]];
            let dk = [spread[0] - self.spread[0], spread[1] - self.spread[1]];
            let (last, turned) = (condition.metric(self.flow), condition.metric([self.spread[0], self.spread[1], 0.0]));
            let g = both(last.gradient, turned.gradient);
            let c = both(condition.product(&last, de), condition.product(&turned, [dk[0], dk[1], 0.0]));
            let product = |v: &[f64; 5]| v[0] * de[0] + v[1] * de[1] + v[2] * de[2] + v[3] * dk[0] + v[4] * dk[1];
            let along = product(&g);
            let on_g = self.fluidity + self.hardening * along - 0.5 * self.inverse_square * product(&w);
            let on_w = -0.5 * self.inverse_square * along;
            for i in 0..5 {
                w[i] = on_g * g[i] + on_w * w[i] + self.fluidity * c[i];
            }
        }
        let square = condition.stress_square(now, [w[0], w[1], w[2]])
            + condition.stress_square(turning, [w[3], w[4], 0.0]) / MEAN_SQUARE;
        if square > yield_stress * yield_stress {
            let back = yield_stress / square.sqrt();
            return w.map(|w| back * w);
        }
        w
    }
}
