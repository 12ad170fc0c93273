//! The flow law of a rigid-plastic Huber-Mises sheet at one thickness point.
//!
//! ```text
//! A = [4/3 2/3 0; 2/3 4/3 0; 0 0 k/3],  k = 5/6       acting on Δε = (Δε_s, Δε_θ, Δγ); by r̄ in
//!                                                     [`Hill48`](super::Hill48), or the matrix of [`Hosford`]
//! Δε̄² = Δεᵀ A Δε        σ = (σ_y/Δε̄) A Δε = μ·3A ε̇,   μ = σ_y/(3 ε̄̇)
//! ```
//!
//! σ_y is taken at the end of the step Δε = Δt ε̇, and Δε̄ is cut off where the sheet hardly flows: Δε̄_reg² = Δε̄² + Δε₀².
//!
//! The stress goes with the strain rate at the end of the step. Where the sheet flows steadily that is the second-order
//! backward difference (BDF2), by which σ_y finds its strain too:
//!
//! ```text
//! Δt ε̇ = (1 + a) Δε − a p,   ε̄_end = ε̄ + (Δt ε̄̇ + a p̄)/(1 + a),   a = Δt/(Δt + Δt_before)
//! ```
//!
//! with what the rate of the step before would strain in this one, p and p̄. Elsewhere a = 0: backward Euler's method.
//!
//! # References
//! BDF2: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I (1993), section III.5 (not read).
//! Zienkiewicz, Jain, Oñate, Int. J. Solids Struct. 14 (1978) 15–38; Sosnowski (1994), equations 3 and 4.

use super::{FlowStress, Gtn, Hardening, PointLaw, Rate, Surroundings, ThermalLaw, YieldCriterion};
use crate::units::ZERO_CELSIUS;

pub use super::point_law::{PointSnapshot, Response, StressUpdate, Tangent};
pub use super::yield_condition::{
    Layer, LayerMetric, MEAN_SQUARE, Metric, SHEAR_FACTOR, Symmetric, Triple, YieldCondition,
};

/// State of a thickness point at the start of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// ε̄ at the start of the step \[–\].
    pub strain: f64,
    /// f that the step reckons with, 0 for a sheet without voids \[–\].
    pub porosity: f64,
    /// T \[K\].
    pub temperature: f64,
    /// Rate at the end of the step before.
    pub previous: PreviousRate,
    /// Resistance of its surroundings.
    pub surroundings: Surroundings,
}

/// Rate at the end of the step before, times its weight a in the rate of this one; zero in a first step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreviousRate {
    /// a \[–\].
    weight: f64,
    /// a p \[–\].
    strain: Triple,
    /// a times its spread over the point's part of the thickness \[–\].
    spread: [f64; 2],
    /// a p̄ \[–\].
    equivalent: f64,
}

impl PointState {
    /// A point of ordinary metal at room temperature, by itself.
    pub fn at(strain: f64) -> Self {
        let (porosity, previous, surroundings) = Default::default();
        Self { strain, porosity, temperature: ROOM_TEMPERATURE, previous, surroundings }
    }

    /// Point of a sheet that goes on flowing: the last rate would strain it by `p`, with this spread, in the step.
    #[must_use]
    pub fn following(self, p: Triple, spread: [f64; 2], a: f64, criterion: YieldCriterion, gtn: Option<&Gtn>) -> Self {
        let (equivalent, spread) = match gtn {
            None => (criterion.layer(p, spread, None).square.sqrt(), spread),
            Some(gtn) => (gtn.condition(criterion.quadratic(), self.porosity).equivalent_increment(p), [0.0; 2]),
        };
        let (strain, spread) = (p.map(|p| a * p), spread.map(|k| a * k));
        Self { previous: PreviousRate { weight: a, strain, spread, equivalent: a * equivalent }, ..self }
    }
}

/// 20 °C \[K\].
pub const ROOM_TEMPERATURE: f64 = 20.0 + ZERO_CELSIUS;

named! {
    // H of Sosnowski (1994), equation 9.
    /// Matrix of the corrector.
    #[derive(serde::Deserialize, schemars::JsonSchema)]
    #[serde(rename_all = "snake_case")]
    pub enum Iteration;
    /// Name in case files and tables.
    fn key;
    PrimalDual: "primal_dual", "Newton's matrix with an independently carried stress.";
    Newton: "newton", "Newton's consistent tangent.";
    Secant: "secant", "Secant (Picard): slow, hardly ever fails.";
}

/// Law of all thickness points in an iteration.
#[derive(Clone, Copy, Debug)]
pub struct FlowLaw<'a> {
    /// σ_y(ε̄), slow and cold.
    pub hardening: &'a Hardening,
    /// `None` for a rate-free metal, which does not feel the step's duration.
    pub rate: Option<&'a Rate>,
    /// `None` for a metal that does not feel its temperature.
    pub softening: Option<&'a ThermalLaw>,
    /// The yield condition of the metal without voids.
    pub criterion: YieldCriterion,
    /// `None` for a metal without voids.
    pub voids: Option<&'a Gtn>,
    /// The matrix to iterate with.
    pub matrix: Iteration,
    /// Δε₀ > 0 of the step \[–\].
    pub cutoff: f64,
    /// Δt of the step \[s\].
    pub duration: f64,
}

impl PointLaw for FlowLaw<'_> {
    type PointState = PointState;
    type Iterate = Iterate;

    fn respond(&self, point: &PointState, iterate: &mut Iterate, e: Triple, spread: [f64; 2]) -> Response {
        match (self.voids, &self.criterion) {
            (None, YieldCriterion::Hill48(hill)) => iterate.flow(self, hill, point, e, spread),
            (None, YieldCriterion::Hosford(hosford)) => iterate.flow(self, hosford, point, e, spread),
            (Some(voids), criterion) => {
                iterate.flow(self, &voids.condition(criterion.quadratic(), point.porosity), point, e, [0.0; 2])
            }
        }
    }

    fn snapshot(&self, point: &PointState, iterate: &Iterate, update: &StressUpdate) -> PointSnapshot {
        let snapshot = update.snapshot(iterate.strain, point.strain, &iterate.tangent(self, point));
        let viscosity = Some(iterate.fluidity * self.duration / 3.0);
        PointSnapshot { equivalent_increment: iterate.metric.square.sqrt(), viscosity, ..snapshot }
    }
}

/// Memory of a thickness point from one iteration to the next.
#[derive(Clone, Copy, Debug, Default)]
pub struct Iterate {
    /// Carried stress w of the primal-dual matrix \[MPa\].
    carried: Layer,
    /// Δε \[–\].
    pub strain: Triple,
    /// Δt ε̇ at the end of the step, and its metric.
    flow: Layer,
    metric: LayerMetric,
    /// f, h and 1/Δε̄_reg² of the last matrix.
    fluidity: f64,
    hardening: f64,
    inverse_square: f64,
}

impl Iterate {
    /// First iterate of a step, which carries the stress w of the step before.
    pub fn start([s, t, shear]: Triple) -> Self {
        Self { carried: [s, t, 0.0, 0.0, shear], ..Self::default() }
    }

    /// Carried stress \[MPa\].
    pub fn carried(&self) -> Triple {
        [self.carried[0], self.carried[1], self.carried[4]]
    }

    /// Evaluates the law at a strain increment and moves on to it.
    /// With a rate law and a thermal law σ_y = σ_s(ε̄) g(Δε̄_reg/Δt) h(T), times the factor of the point's
    /// [`Surroundings`]. With Δε for Δt ε̇, which is (1 + a) times as steep, the matrices are
    ///
    /// ```text
    /// secant       C = f A                                                   f = σ_y/Δε̄_reg
    /// Newton       C = f A + h (AΔε)(AΔε)ᵀ − f/Δε̄_reg² (AΔε)(AΔε)ᵀ           h = σ_y'/(Δε̄ Δε̄_reg)
    /// primal-dual  C = f A + h (AΔε)(AΔε)ᵀ − ½(w⊗AΔε + AΔε⊗w)/Δε̄_reg²
    /// w ← σ + C δ(Δε), scaled back to √(wᵀA⁻¹w) = σ_y when beyond it
    /// ```
    ///
    /// If bending reverses the flow within the point's part of the thickness, the stress of a single point would jump. With k
    /// the strain of bending over half the part, the root mean square of the strain over it
    ///
    /// ```text
    /// P² = Δεᵀ A Δε + ⅓ kᵀ A k + Δε₀²,   σ = σ_y ∂P/∂Δε = σ_y/P A Δε,   m = σ_y ∂P/∂k = σ_y/P ⅓ A k
    /// ```
    ///
    /// takes the place of Δε̄_reg: stress, moment and matrices are those of a point with five strains.
    ///
    /// # References
    /// The carried stress: Chan, Golub, Mulet, SIAM J. Sci. Comput. 20 (1999) 1964–1977, for a potential with the same kink.
    fn flow(
        &mut self, law: &FlowLaw, condition: &impl YieldCondition, point: &PointState, strain: Triple, spread: [f64; 2],
    ) -> Response {
        let PreviousRate { weight, strain: past, spread: past_spread, equivalent } = point.previous;
        let steep = 1.0 + weight;
        let e = [0, 1, 2].map(|i| steep * strain[i] - past[i]);
        let k = [0, 1].map(|i| steep * spread[i] - past_spread[i]);
        let flow = [e[0], e[1], k[0], k[1], e[2]];
        let carried = (law.matrix == Iteration::PrimalDual && self.fluidity > 0.0).then(|| self.carried_to(flow));
        let metric = condition.layer(e, k, carried);
        let (g, increment) = (metric.gradient, metric.square.sqrt());
        let inverse_square = 1.0 / (metric.square + law.cutoff * law.cutoff);
        let (inverse, share) = (inverse_square.sqrt(), condition.strain_share());
        let hardening = (share * increment + equivalent) / steep;
        let FlowStress { stress, slope } = law.hardening.at_temperature(point.strain + hardening, point.temperature);
        let yielding = FlowStress { stress, slope: slope / steep };
        let yielding = yielding.at_rate(law.rate, share / inverse / law.duration, increment * inverse / law.duration);
        let softening = law.softening.map_or(1.0, |softening| softening.at(point.temperature));
        let yielding = point.surroundings.held(yielding, share * increment).times(softening);
        let FlowStress { stress: yield_stress, slope } = yielding;
        let f = yield_stress * inverse;
        let h = if increment > 0.0 { share * slope * inverse / increment } else { 0.0 };
        if law.matrix == Iteration::PrimalDual {
            let w = carried.unwrap_or(self.carried);
            let square = condition.stress_square(&metric, w);
            let back = if square > yield_stress * yield_stress { yield_stress / square.sqrt() } else { 1.0 };
            self.carried = w.map(|w| back * w);
        }
        *self = Self { carried: self.carried, strain, flow, metric, fluidity: f, hardening: h, inverse_square };
        let (stress, moment) = ([f * g[0], f * g[1], f * g[4]], [f * g[2], f * g[3]]);
        let work_across = moment[0] * spread[0] + moment[1] * spread[1];
        (StressUpdate { stress, moment, increment: hardening, yield_stress, work_across }, self.tangent(law, point))
    }

    /// C = (1 + a) (f A + g⊗b + b⊗g) of the last evaluation.
    fn tangent(&self, law: &FlowLaw, point: &PointState) -> Tangent {
        let Self { metric, fluidity: f, hardening: h, inverse_square, .. } = self;
        let (g, steep) = (metric.gradient, 1.0 + point.previous.weight);
        let b: Layer = match law.matrix {
            Iteration::Secant => [0.0; 5],
            Iteration::Newton => g.map(|g| 0.5 * (h - f * inverse_square) * g),
            Iteration::PrimalDual => std::array::from_fn(|i| 0.5 * (h * g[i] - inverse_square * self.carried[i])),
        };
        let (own, coupling) = (metric.own.map(|a| steep * f * a), metric.coupling.map(|a| steep * f * a));
        let across = if law.voids.is_none() { MEAN_SQUARE } else { 0.0 };
        Tangent { own, coupling, across, outer: [g, b.map(|b| steep * b)] }
    }

    /// σ + C δ(Δε) with the matrix of the last iterate.
    fn carried_to(&self, flow: Layer) -> Layer {
        let (g, w) = (self.metric.gradient, self.carried);
        let delta: Layer = std::array::from_fn(|i| flow[i] - self.flow[i]);
        let along = |v: Layer| -> f64 { (0..5).map(|i| v[i] * delta[i]).sum() };
        let half = 0.5 * self.inverse_square;
        let on_g = self.fluidity + self.hardening * along(g) - half * along(w);
        let on_w = -half * along(g);
        let own = self.metric.product(delta);
        std::array::from_fn(|i| on_g * g[i] + on_w * w[i] + self.fluidity * own[i])
    }
}

#[cfg(test)]
pub(crate) mod tests;
