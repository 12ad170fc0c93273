//! The flow law where a thickness point stands for a part of the thickness that bending turns about.

use super::{
    Across, FlowLaw, Iterate, Iteration, Past, PointState, StressUpdate, Triple, YieldCondition, return_factor,
    slope_share,
};
use crate::material::{FlowStress, Hosford, YieldCriterion};

impl Iterate {
    /// Where bending turns the flow about within the point's part of the thickness the stress jumps: a point by itself would
    /// stick to the jump, and bear any tension without stretching. With k the strain of bending over half the part, the root
    /// mean square of the strain over it
    ///
    /// ```text
    /// P² = Δεᵀ A Δε + ⅓ kᵀ A k + Δε₀²,   σ = σ_y ∂P/∂Δε = σ_y/P A Δε,   m = σ_y ∂P/∂k = σ_y/P ⅓ A k
    /// ```
    ///
    /// stands for the mean: a norm of both, so that stress, moment and matrices are those of a point with five strains. Where A
    /// is not the same for all strains P² is the mean of Gauss's two points, which for a quadratic condition is the same.
    /// `None` for a sheet with voids.
    #[inline(always)]
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
}

impl Iterate {
    #[inline(always)]
    pub(super) fn flow_across(
        &mut self,
        law: &FlowLaw,
        condition: &impl YieldCondition,
        point: &PointState,
        strain: Triple,
        bending: [f64; 2],
    ) -> Across {
        let Past { weight, strain: past, spread: past_spread, equivalent } = point.past;
        let steep = weight + 1.0;
        let e = [steep * strain[0] - past[0], steep * strain[1] - past[1], steep * strain[2] - past[2]];
        let spread = [steep * bending[0] - past_spread[0], steep * bending[1] - past_spread[1]];
        let w = if self.goes_on(law) { Some(self.carried_across(condition, e, spread)) } else { None };
        let part = condition.part(e, spread, w);
        let (g, square) = (part.gradient, part.square);
        let increment = square.sqrt();
        let inverse_square = 1.0 / (square + law.cutoff * law.cutoff);
        let inverse = inverse_square.sqrt();
        let hardening = (increment + equivalent) / steep;
        let FlowStress { stress: yield_stress, slope } =
            law.yielding(point, hardening, steep, increment, 1.0 / inverse, increment * inverse);
        let f = yield_stress * inverse;
        let h = slope_share(slope * inverse, increment);
        let stress = [f * g[0], f * g[1], f * g[4]];
        let moment = [f * g[2], f * g[3]];
        let half = steep * 0.5;
        let other = match law.matrix {
            Iteration::Secant => [0.0; 5],
            Iteration::Newton => g.map(|g| half * (h - f * inverse_square) * g),
            Iteration::PrimalDual => {
                let w = w.unwrap_or(self.carried_together());
                let back = return_factor(condition.part_square(&part, w), yield_stress);
                let w = w.map(|w| back * w);
                self.carried = [w[0], w[1], w[4]];
                self.carried_moment = [w[2], w[3]];
                let (on_g, on_w) = (half * h, half * inverse_square);
                std::array::from_fn(|i| on_g * g[i] - on_w * w[i])
            }
        };
        let work_across = moment[0] * bending[0] + moment[1] * bending[1];
        *self = Self {
            strain,
            flow: e,
            spread,
            fluidity: f,
            hardening: h,
            inverse_square,
            kept: condition.part_kept(&part),
            ..*self
        };
        let tangent = [0.0; 6];
        let update = StressUpdate { stress, tangent, increment: hardening, yield_stress, work_across };
        let scale = steep * f;
        let metric = part.own.map(|entry| scale * entry);
        let coupling = part.coupling.map(|coupling| coupling.map(|entry| scale * entry));
        Across { update, moment, metric, coupling, outer: [g, other] }
    }

    /// The carried stress and moment, by ε_s, ε_θ, their spreads and γ.
    #[inline(always)]
    fn carried_together(&self) -> [f64; 5] {
        let ([s, t, shear], [ms, mt]) = (self.carried, self.carried_moment);
        [s, t, ms, mt, shear]
    }

    /// σ + C δ(Δε) of stress and moment.
    #[inline(always)]
    fn carried_across(&self, condition: &impl YieldCondition, e: Triple, spread: [f64; 2]) -> [f64; 5] {
        let last = condition.part_recalled(&self.kept, self.flow, self.spread);
        let (g, w) = (last.gradient, self.carried_together());
        let de = [e[0] - self.flow[0], e[1] - self.flow[1], e[2] - self.flow[2]];
        let dk = [spread[0] - self.spread[0], spread[1] - self.spread[1]];
        let delta = [de[0], de[1], dk[0], dk[1], de[2]];
        let along = product(&g, &delta);
        let half = self.inverse_square * 0.5;
        let on_g = self.fluidity + self.hardening * along - half * product(&w, &delta);
        let on_w = -(half * along);
        let own = condition.part_product(&last, de, dk);
        std::array::from_fn(|i| on_g * g[i] + on_w * w[i] + self.fluidity * own[i])
    }
}

#[inline(always)]
fn product(v: &[f64; 5], w: &[f64; 5]) -> f64 {
    v[0] * w[0] + v[1] * w[1] + v[4] * w[4] + v[2] * w[2] + v[3] * w[3]
}
