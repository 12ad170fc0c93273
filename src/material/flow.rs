//! The flow law of a rigid-plastic Huber-Mises sheet at one thickness point.
//!
//! ```text
//! A = [4/3 2/3 0; 2/3 4/3 0; 0 0 k/3],  k = 5/6       acting on Δε = (Δε_s, Δε_θ, Δγ); by r̄ in
//!                                                     [`Hill48`](super::Hill48), or the matrix of [`Hosford`]
//! Δε̄² = Δεᵀ A Δε        σ = (σ_y/Δε̄) A Δε = μ·3A ε̇,   μ = σ_y/(3 ε̄̇)
//! ```
//!
//! The law is written for the increment of a step, Δε = Δt ε̇: for a rate-free metal the step length drops out.
//! σ_y is taken at the END of the step, and Δε̄ is cut off where the sheet hardly flows: Δε̄_reg² = Δε̄² + Δε₀².
//!
//! The stress goes with the strain rate at the end of the step. Where the sheet flows steadily that is not the mean rate of
//! the step, Δε/Δt, but the second-order backward difference (BDF2), by which σ_y finds its strain too:
//!
//! ```text
//! Δt ε̇ = (1 + a) Δε − a p,   ε̄_end = ε̄ + (Δt ε̄̇ + a p̄)/(1 + a),   a = Δt/(Δt + Δt_before)
//! ```
//!
//! with what the rate of the step before would strain in this one, p and p̄. Elsewhere a = 0, which is backward Euler's
//! method: it keeps nothing of a past that is over.
//!
//! # References
//! BDF2: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I (1993), section III.5 (not read).
//! Zienkiewicz, Jain, Oñate, Int. J. Solids Struct. 14 (1978) 15–38; Sosnowski (1994), equations 3 and 4.

mod parts;
mod point;

pub use point::{Past, PointState, ROOM_TEMPERATURE};

use super::yield_condition::{Kept, dot};
use super::{FlowStress, Gtn, Hardening, Hosford, PointLaw, Rate, ThermalLaw, YieldCriterion};

pub use super::point_law::{Across, StressUpdate};
pub use super::yield_condition::{MEAN_SQUARE, Metric, SHEAR_FACTOR, Symmetric, Triple, YieldCondition};

/// Matrix of the corrector.
// H of Sosnowski (1994), equation 9.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[derive(schemars::JsonSchema)]
pub enum Iteration {
    /// Newton's matrix with an independently carried stress.
    PrimalDual,
    /// Newton's consistent tangent.
    Newton,
    /// Secant (Picard): slow, hardly ever fails.
    Secant,
}

/// What is the same for every thickness point in an iteration.
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

    #[inline(always)]
    fn respond(&self, point: &PointState, iterate: &mut Iterate, e: Triple) -> StressUpdate {
        iterate.advance(self, point, e)
    }

    #[inline(always)]
    fn respond_across(&self, point: &PointState, iterate: &mut Iterate, e: Triple, spread: [f64; 2]) -> Option<Across> {
        iterate.advance_across(self, point, e, spread)
    }
}

impl FlowLaw<'_> {
    /// σ_y at the end of a step that adds `hardening` to ε̄, and its derivative by the `increment` at the rate of the end, of
    /// which the hardening goes with one over `steep`; `flow` is that increment, regularised, and `ratio` its derivative.
    #[inline(always)]
    fn yielding(
        &self,
        point: &PointState,
        hardening: f64,
        steep: f64,
        increment: f64,
        flow: f64,
        ratio: f64,
    ) -> FlowStress {
        let FlowStress { stress, slope } = self.hardening.at_temperature(point.strain + hardening, point.temperature);
        let mut yielding = FlowStress { stress, slope: slope / steep };
        if let Some(rate) = self.rate {
            let factor = rate.at(flow / self.duration);
            yielding.slope = yielding.slope * factor.value + yielding.stress * factor.slope * ratio / self.duration;
            yielding.stress *= factor.value;
        }
        point.surroundings.hold(&mut yielding, increment);
        if let Some(softening) = self.softening {
            let factor = softening.at(point.temperature);
            yielding.slope *= factor;
            yielding.stress *= factor;
        }
        yielding
    }
}

/// What one thickness point remembers from one iteration to the next.
#[derive(Clone, Copy, Debug, Default)]
pub struct Iterate {
    /// The carried stress w of the primal-dual matrix \[MPa\].
    pub carried: Triple,
    /// That of the moment of the point's part of the thickness \[MPa\].
    carried_moment: [f64; 2],
    /// Δε, the Δt ε̇ that goes with it, and the spread of that.
    strain: Triple,
    flow: Triple,
    spread: [f64; 2],
    fluidity: f64,
    hardening: f64,
    inverse_square: f64,
    kept: Kept,
}

impl Iterate {
    /// The first iterate of a step: `carried` is the stress w kept from the step before.
    pub fn start(carried: Triple) -> Self {
        Self { carried, ..Self::default() }
    }

    /// Strain increment of the last evaluation \[–\].
    pub fn strain(&self) -> Triple {
        self.strain
    }

    /// Evaluates the law at the strain increment `e` and moves on to it.
    ///
    /// With a rate law and a thermal law σ_y = σ_s(ε̄) g(Δε̄_reg/Δt) h(T), times what the point's [`Surroundings`] hold. With Δε
    /// for Δt ε̇, which is (1 + a) times as steep, the matrices are
    ///
    /// ```text
    /// secant       C = f A                                                   f = σ_y/Δε̄_reg
    /// Newton       C = f A + h (AΔε)(AΔε)ᵀ − f/Δε̄_reg² (AΔε)(AΔε)ᵀ           h = σ_y'/(Δε̄ Δε̄_reg)
    /// primal-dual  C = f A + h (AΔε)(AΔε)ᵀ − ½(w⊗AΔε + AΔε⊗w)/Δε̄_reg²
    /// w ← σ + C δ(Δε), scaled back to √(wᵀA⁻¹w) = σ_y when beyond it
    /// ```
    ///
    /// # References
    /// The carried stress: Chan, Golub, Mulet, SIAM J. Sci. Comput. 20 (1999) 1964–1977, for a potential with the same kink.
    #[inline(always)]
    pub fn advance(&mut self, law: &FlowLaw, point: &PointState, e: Triple) -> StressUpdate {
        match (law.voids, &law.criterion) {
            (None, YieldCriterion::Hill48(hill)) => self.flow(law, hill, point, e),
            (None, YieldCriterion::Hosford(hosford)) => self.flow_by_hosford(law, hosford, point, e),
            (Some(voids), _) => self.flow_voided(law, voids, point, e),
        }
    }

    /// Apart from the plain law, so that this one stays small where it is called; so is the next one.
    #[inline(never)]
    fn flow_by_hosford(&mut self, law: &FlowLaw, hosford: &Hosford, point: &PointState, e: Triple) -> StressUpdate {
        self.flow(law, hosford, point, e)
    }

    #[inline(never)]
    fn flow_voided(&mut self, law: &FlowLaw, voids: &Gtn, point: &PointState, e: Triple) -> StressUpdate {
        self.flow(law, &voids.condition(law.criterion.quadratic(), point.porosity), point, e)
    }
}

impl Iterate {
    #[inline(always)]
    fn flow(
        &mut self,
        law: &FlowLaw,
        condition: &impl YieldCondition,
        point: &PointState,
        strain: Triple,
    ) -> StressUpdate {
        let Past { weight, strain: past, equivalent, .. } = point.past;
        let steep = weight + 1.0;
        let e = [steep * strain[0] - past[0], steep * strain[1] - past[1], steep * strain[2] - past[2]];
        let w = if self.goes_on(law) { Some(self.carried_at(condition, e)) } else { None };
        let metric = match w {
            Some([s, t, _]) => condition.metric_towards(e, [s, t]),
            None => condition.metric(e),
        };
        let a = metric.gradient;
        let square = metric.square;
        let increment = square.sqrt();
        let inverse_square = 1.0 / (square + law.cutoff * law.cutoff);
        let inverse = inverse_square.sqrt();
        let share = condition.strain_share();
        let hardening = (increment * share + equivalent) / steep;
        let mut yielding =
            law.yielding(point, hardening, steep, increment * share, 1.0 / inverse * share, increment * inverse);
        yielding.slope = yielding.slope * share;
        let f = yielding.stress * inverse;
        let h = slope_share(yielding.slope * inverse, increment);
        let stress = [f * a[0], f * a[1], f * a[2]];

        // C = (f A + ½ (a⊗b + b⊗a)) (1 + a)
        let b = match law.matrix {
            Iteration::Secant => [0.0; 3],
            Iteration::Newton => {
                let g = h - f * inverse_square;
                [g * a[0], g * a[1], g * a[2]]
            }
            Iteration::PrimalDual => {
                let w = w.unwrap_or(self.carried);
                let back = return_factor(condition.stress_square(&metric, w), yielding.stress);
                let w = [back * w[0], back * w[1], back * w[2]];
                self.carried = w;
                let i = inverse_square;
                [h * a[0] - i * w[0], h * a[1] - i * w[1], h * a[2] - i * w[2]]
            }
        };
        let fa = condition.scaled(&metric, f);
        let tangent = [
            steep * (fa[0] + a[0] * b[0]),
            steep * (fa[1] + (a[0] * b[1] + a[1] * b[0]) * 0.5),
            steep * (fa[2] + a[1] * b[1]),
            steep * (fa[3] + (a[0] * b[2] + a[2] * b[0]) * 0.5),
            steep * (fa[4] + (a[1] * b[2] + a[2] * b[1]) * 0.5),
            steep * (fa[5] + a[2] * b[2]),
        ];
        *self = Self {
            carried: self.carried,
            carried_moment: [0.0; 2],
            strain,
            flow: e,
            spread: [0.0; 2],
            fluidity: f,
            hardening: h,
            inverse_square,
            kept: condition.kept(&metric),
        };
        StressUpdate { stress, tangent, increment: hardening, yield_stress: yielding.stress, work_across: 0.0 }
    }

    /// True if the stress is carried on from a last iterate.
    #[inline]
    fn goes_on(&self, law: &FlowLaw) -> bool {
        law.matrix == Iteration::PrimalDual && self.fluidity > 0.0
    }

    /// σ + C δ(Δε) with the matrix of the last iterate.
    #[inline(always)]
    fn carried_at(&self, condition: &impl YieldCondition, e: Triple) -> Triple {
        let last = condition.recalled(&self.kept, self.flow);
        let (a, w) = (last.gradient, self.carried);
        let delta = [e[0] - self.flow[0], e[1] - self.flow[1], e[2] - self.flow[2]];
        let along = dot(a, delta);
        let half = self.inverse_square * 0.5;
        let on_a = self.fluidity + self.hardening * along - half * dot(w, delta);
        let on_w = -(half * along);
        let own = condition.product(&last, delta);
        [0, 1, 2].map(|i| on_a * a[i] + on_w * w[i] + self.fluidity * own[i])
    }
}

/// Slope over an increment; 0 for no increment.
#[inline]
fn slope_share(slope: f64, increment: f64) -> f64 {
    if increment > 0.0 { slope / increment } else { 0.0 }
}

/// Factor ≤ 1 that scales a carried stress beyond the yield surface back onto it.
#[inline]
fn return_factor(square: f64, yield_stress: f64) -> f64 {
    if square > yield_stress * yield_stress { yield_stress / square.sqrt() } else { 1.0 }
}

#[cfg(test)]
mod tests;
