//! The flow law of a rigid-plastic Huber-Mises sheet at one thickness point.
//!
//! ```text
//! A = [4/3 2/3 0; 2/3 4/3 0; 0 0 k/3],  k = 5/6       acting on Δε = (Δε_s, Δε_θ, Δγ); by r̄ in [`Hill48`]
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

use super::yield_condition::dot;
use super::{FlowStress, Gtn, Hardening, Hill48, PointLaw, Rate, Surroundings, ThermalLaw};
use crate::units::ZERO_CELSIUS;

pub use super::point_law::{Across, StressUpdate};
pub use super::yield_condition::{Metric, SHEAR_FACTOR, Symmetric, Triple, YieldCondition};

/// Mean square of what goes evenly from −1 to 1 \[–\].
const MEAN_SQUARE: f64 = 1.0 / 3.0;

/// Matrix of the corrector.
// H of Sosnowski (1994), equation 9.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "case", derive(serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
    /// Hill's yield condition.
    pub anisotropy: Hill48,
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

    #[inline]
    fn respond(&self, point: &PointState, iterate: &mut Iterate, e: Triple) -> StressUpdate {
        iterate.advance(self, point, e)
    }

    #[inline]
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
        let mut yielding = self.hardening.at_temperature(point.strain + hardening, point.temperature);
        yielding.slope /= steep;
        if let Some(rate) = self.rate {
            let factor = rate.at(flow / self.duration);
            yielding.slope *= factor.value;
            yielding.slope += yielding.stress * factor.slope * ratio / self.duration;
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

/// A thickness point as the step finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// ε̄ at the start of the step \[–\].
    pub strain: f64,
    /// f that the step reckons with, 0 for a sheet without voids \[–\].
    pub porosity: f64,
    /// T \[K\].
    pub temperature: f64,
    /// What the step before has to do with this one.
    pub past: Past,
    /// What flows around it.
    pub surroundings: Surroundings,
}

/// What the step before has to do with this one: nothing, until it is said.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Past {
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
        Self {
            strain,
            porosity: 0.0,
            temperature: ROOM_TEMPERATURE,
            past: Past::default(),
            surroundings: Surroundings::default(),
        }
    }

    /// The point of a sheet that goes on flowing: with what the last rate would strain in this step, p, its spread over the
    /// point's part of the thickness, and with its weight a in the rate at the end.
    #[must_use]
    pub fn following(self, p: Triple, spread: [f64; 2], a: f64, anisotropy: Hill48, voids: Option<&Gtn>) -> Self {
        let equivalent = match voids {
            None => {
                let across = anisotropy.equivalent_increment([spread[0], spread[1], 0.0]);
                anisotropy.equivalent_increment(p).hypot(MEAN_SQUARE.sqrt() * across)
            }
            Some(voids) => voids.condition(anisotropy, self.porosity).equivalent_increment(p),
        };
        let past =
            Past { weight: a, strain: p.map(|p| a * p), spread: spread.map(|k| a * k), equivalent: a * equivalent };
        Self { past, ..self }
    }
}

/// 20 °C \[K\].
pub const ROOM_TEMPERATURE: f64 = 20.0 + ZERO_CELSIUS;

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
    #[inline]
    pub fn advance(&mut self, law: &FlowLaw, point: &PointState, e: Triple) -> StressUpdate {
        match law.voids {
            None => self.flow(law, &law.anisotropy, point, e),
            Some(voids) => self.flow_voided(law, voids, point, e),
        }
    }

    /// Apart from the plain law, so that this one stays small where it is called.
    #[inline(never)]
    fn flow_voided(&mut self, law: &FlowLaw, voids: &Gtn, point: &PointState, e: Triple) -> StressUpdate {
        self.flow(law, &voids.condition(law.anisotropy, point.porosity), point, e)
    }

    #[inline(always)]
    fn flow(
        &mut self,
        law: &FlowLaw,
        condition: &impl YieldCondition,
        point: &PointState,
        strain: Triple,
    ) -> StressUpdate {
        let Past { weight, strain: past, equivalent, .. } = point.past;
        let steep = 1.0 + weight;
        let e = [steep * strain[0] - past[0], steep * strain[1] - past[1], steep * strain[2] - past[2]];
        let metric = condition.metric(e);
        let a = metric.gradient;
        let square = metric.square;
        let increment = square.sqrt();
        let inverse_square = 1.0 / (square + law.cutoff * law.cutoff);
        let inverse = inverse_square.sqrt();
        let share = condition.strain_share();
        let hardening = (share * increment + equivalent) / steep;
        let mut yielding =
            law.yielding(point, hardening, steep, share * increment, share / inverse, increment * inverse);
        yielding.slope *= share;
        let f = yielding.stress * inverse;
        let h = if increment > 0.0 { yielding.slope * inverse / increment } else { 0.0 };
        let stress = [f * a[0], f * a[1], f * a[2]];

        // C = (f A + ½ (a⊗b + b⊗a)) (1 + a)
        let b = match law.matrix {
            Iteration::Secant => [0.0; 3],
            Iteration::Newton => {
                let g = h - f * inverse_square;
                [g * a[0], g * a[1], g * a[2]]
            }
            Iteration::PrimalDual => {
                let w = self.carried_at(condition, &metric, e, yielding.stress);
                self.carried = w;
                let i = inverse_square;
                [h * a[0] - i * w[0], h * a[1] - i * w[1], h * a[2] - i * w[2]]
            }
        };
        let fa = condition.scaled(&metric, f);
        let tangent = [
            fa[0] + a[0] * b[0],
            fa[1] + 0.5 * (a[0] * b[1] + a[1] * b[0]),
            fa[2] + a[1] * b[1],
            fa[3] + 0.5 * (a[0] * b[2] + a[2] * b[0]),
            fa[4] + 0.5 * (a[1] * b[2] + a[2] * b[1]),
            fa[5] + a[2] * b[2],
        ];
        let tangent = tangent.map(|c| steep * c);
        *self = Self {
            carried: self.carried,
            carried_moment: [0.0; 2],
            strain,
            flow: e,
            spread: [0.0; 2],
            fluidity: f,
            hardening: h,
            inverse_square,
        };
        StressUpdate { stress, tangent, increment: hardening, yield_stress: yielding.stress, work_across: 0.0 }
    }

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
    fn advance_across(
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
        let metric = hill.metric(e);
        let a = metric.gradient;
        let q = MEAN_SQUARE * hill.direct;
        let r = MEAN_SQUARE * hill.coupled;
        let b = [q * spread[0] + r * spread[1], r * spread[0] + q * spread[1]];
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
        let half = match law.matrix {
            Iteration::Secant => [0.0; 5],
            Iteration::Newton => g.map(|g| 0.5 * (h - f * inverse_square) * g),
            Iteration::PrimalDual => {
                let w = self.carried_across(law, e, spread, yield_stress);
                self.carried = [w[0], w[1], w[2]];
                self.carried_moment = [w[3], w[4]];
                let by = |i: usize| 0.5 * (h * g[i] - inverse_square * w[i]);
                [by(0), by(1), by(2), by(3), by(4)]
            }
        };
        let outer = |i: usize, j: usize| g[i] * half[j] + half[i] * g[j];
        let fa = hill.scaled(&metric, f);
        let tangent = [
            steep * (fa[0] + outer(0, 0)),
            steep * (fa[1] + outer(0, 1)),
            steep * (fa[2] + outer(1, 1)),
            steep * (fa[3] + outer(0, 2)),
            steep * (fa[4] + outer(1, 2)),
            steep * (fa[5] + outer(2, 2)),
        ];
        let coupling = [0, 1, 2].map(|i| [steep * outer(i, 3), steep * outer(i, 4)]);
        let work_across = moment[0] * bending[0] + moment[1] * bending[1];
        let bending = [f * q + outer(3, 3), f * r + outer(3, 4), f * q + outer(4, 4)].map(|c| steep * c);
        *self = Self { strain, flow: e, spread, fluidity: f, hardening: h, inverse_square, ..*self };
        let update = StressUpdate { stress, tangent, increment: hardening, yield_stress, work_across };
        Some(Across { update, moment, coupling, bending })
    }

    /// w ← σ + C δ(Δε) with the matrix of the last iterate, scaled back onto the yield surface.
    #[inline]
    fn carried_at(&self, condition: &impl YieldCondition, now: &Metric, e: Triple, yield_stress: f64) -> Triple {
        let mut w = self.carried;
        if self.fluidity > 0.0 {
            let last = condition.metric(self.flow);
            let a = last.gradient;
            let delta = [e[0] - self.flow[0], e[1] - self.flow[1], e[2] - self.flow[2]];
            let along = dot(a, delta);
            let on_a = self.fluidity + self.hardening * along - 0.5 * self.inverse_square * dot(w, delta);
            let on_w = -0.5 * self.inverse_square * along;
            let c = condition.product(&last, delta);
            for i in 0..3 {
                w[i] = on_a * a[i] + on_w * w[i] + self.fluidity * c[i];
            }
        }
        let square = condition.stress_square(now, w);
        if square > yield_stress * yield_stress {
            let back = yield_stress / square.sqrt();
            w = w.map(|w| back * w);
        }
        w
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const CUTOFF: f64 = 1e-6;

    fn points() -> Vec<Triple> {
        vec![
            [1e-2, -5e-3, 0.0],
            [3e-3, 0.0, 1e-3],
            [2e-3, 2e-3, 0.0],
            [-4e-3, 1e-3, -2e-3],
            [2e-6, -1e-6, 1e-6],
            [-1e-4, -3e-4, 5e-4],
        ]
    }

    fn flow(hardening: &Hardening, matrix: Iteration) -> FlowLaw<'_> {
        let anisotropy = Hill48::default();
        let (softening, voids) = (None, None);
        FlowLaw { hardening, rate: None, softening, anisotropy, voids, matrix, cutoff: CUTOFF, duration: 0.1 }
    }

    fn at(law: &FlowLaw, e: Triple) -> StressUpdate {
        Iterate::start([0.0; 3]).advance(law, &PointState::at(0.05), e)
    }

    fn full(c: Symmetric) -> [[f64; 3]; 3] {
        [[c[0], c[1], c[3]], [c[1], c[2], c[4]], [c[3], c[4], c[5]]]
    }

    /// Trust: central differences with h = 1e-4 of the increment; truncation near 1e-8 of the entries.
    #[test]
    fn newton_matrix_is_the_derivative_of_the_stress_for_every_law() {
        let rates = Rate::examples();
        let rates = std::iter::once(("rate-free", None)).chain(rates.iter().map(|(name, rate)| (*name, Some(rate))));
        for (rate_name, rate) in rates {
            for ((name, hardening), r) in Hardening::examples().into_iter().zip([1.0, 0.5, 1.8].into_iter().cycle()) {
                let law = FlowLaw { rate, anisotropy: Hill48::new(r), ..flow(&hardening, Iteration::Newton) };
                let surroundings = Surroundings { exponent: 0.005, increment: 2e-3, floor: 1e-4 };
                let point = PointState { surroundings, ..PointState::at(0.05) };
                let at = |law: &FlowLaw, e: Triple| Iterate::start([0.0; 3]).advance(law, &point, e);
                for e in points() {
                    let c = full(at(&law, e).tangent);
                    let h = 1e-4 * law.anisotropy.equivalent_increment(e);
                    for j in 0..3 {
                        let shifted = |sign: f64| {
                            let mut e = e;
                            e[j] += sign * h;
                            at(&law, e).stress
                        };
                        let (plus, minus) = (shifted(1.0), shifted(-1.0));
                        for i in 0..3 {
                            let difference = (plus[i] - minus[i]) / (2.0 * h);
                            let wrong = (c[i][j] - difference).abs();
                            assert!(wrong < 1e-5 * c[0][0].abs(), "{name}, {rate_name}, r {r} {e:?} {i}{j}");
                        }
                    }
                }
            }
        }
    }

    fn following(p: Triple, law: &FlowLaw) -> PointState {
        PointState::at(0.05).following(p, [0.0; 2], 0.4, law.anisotropy, law.voids)
    }

    /// Trust: as above, with a past.
    #[test]
    fn newton_matrix_is_the_derivative_where_the_flow_goes_on() {
        let rate = &Rate::examples()[0].1;
        for (name, hardening) in Hardening::examples() {
            let law = FlowLaw { rate: Some(rate), ..flow(&hardening, Iteration::Newton) };
            for e in points() {
                let point = following([1.2 * e[0], 0.9 * e[1], 0.7 * e[2]], &law);
                let at = |e: Triple| Iterate::start([0.0; 3]).advance(&law, &point, e);
                let c = full(at(e).tangent);
                let h = 1e-4 * law.anisotropy.equivalent_increment(e);
                for j in 0..3 {
                    let shifted = |sign: f64| {
                        let mut e = e;
                        e[j] += sign * h;
                        at(e).stress
                    };
                    let (plus, minus) = (shifted(1.0), shifted(-1.0));
                    for i in 0..3 {
                        let wrong = (c[i][j] - (plus[i] - minus[i]) / (2.0 * h)).abs();
                        assert!(wrong < 1e-5 * c[0][0].abs(), "{name} {e:?} {i}{j}");
                    }
                }
            }
        }
    }

    /// Trust: a path that turns, ε = (0.3 t, 0.2 t²) with t up to 1, has its end's rate (0.3, 0.4), and its ε̄ by an
    /// integration with a hundred thousand chords, which miss 1e-10. The order of the error in stress is that of the rate:
    /// 2 where a step follows the last one, 1 where it does not.
    #[test]
    fn stress_is_second_order_in_the_step_where_the_flow_goes_on() {
        let hardening = &Hardening::examples()[0].1;
        let rate = &Rate::examples()[0].1;
        let path = |t: f64| [0.3 * t, 0.2 * t * t, 0.0];
        let chord = |from: f64, to: f64| [0, 1, 2].map(|i| path(to)[i] - path(from)[i]);
        let metal = Hill48::default();
        let fine = 100_000;
        let strain: f64 = (0..fine)
            .map(|k| {
                metal.equivalent_increment(chord(f64::from(k) / f64::from(fine), f64::from(k + 1) / f64::from(fine)))
            })
            .sum();
        let speed = [0.3, 0.4, 0.0];
        let yield_stress = hardening.at(strain).stress * rate.at(metal.equivalent_increment(speed)).value;
        let exact = metal.apply(speed).map(|a| a * yield_stress / metal.equivalent_increment(speed));
        let error = |steps: u32, weight: f64| {
            let dt = 1.0 / f64::from(steps);
            let law = FlowLaw { rate: Some(rate), duration: dt, ..flow(hardening, Iteration::Newton) };
            let (mut total, mut stress) = (0.0, [0.0; 3]);
            for k in 0..steps {
                let t = dt * f64::from(k);
                let mut point = PointState::at(total);
                if k > 0 {
                    point = point.following(chord(t - dt, t), weight, metal, None);
                }
                let update = Iterate::start([0.0; 3]).advance(&law, &point, chord(t, t + dt));
                (total, stress) = (total + update.increment, update.stress);
            }
            (stress[0] - exact[0]).hypot(stress[1] - exact[1]) / yield_stress
        };
        for (weight, order) in [(0.5, 2.0), (0.0, 1.0)] {
            let found = (error(40, weight) / error(80, weight)).log2();
            assert!((found - order).abs() < 0.1, "weight {weight}: order {found}");
        }
    }

    /// Trust: the definition. Stress is σ_s(ε̄) g(ε̄̇) in tension; the cut-off changes the rate by 5e-9 of itself.
    #[test]
    fn rate_multiplies_the_yield_stress() {
        for (_, hardening) in Hardening::examples() {
            for (name, rate) in Rate::examples() {
                let law = FlowLaw { rate: Some(&rate), ..flow(&hardening, Iteration::Newton) };
                let response = at(&law, [1e-2, -5e-3, 0.0]);
                let expected = hardening.at(0.05 + 1e-2).stress * rate.at(1e-2 / law.duration).value;
                assert_relative_eq!(response.stress[0], expected, max_relative = 1e-7);
                assert!(response.yield_stress > 0.0, "{name}");
            }
        }
    }

    /// Trust: with w = σ the primal-dual matrix is Newton's, to round-off.
    #[test]
    fn primal_dual_matrix_is_newtons_when_the_carried_stress_is_the_stress() {
        for (_, law) in Hardening::examples() {
            for e in points() {
                let newton = at(&flow(&law, Iteration::Newton), e);
                let dual =
                    Iterate::start(newton.stress).advance(&flow(&law, Iteration::PrimalDual), &PointState::at(0.05), e);
                for i in 0..6 {
                    assert_relative_eq!(newton.tangent[i], dual.tangent[i], epsilon = 1e-9 * newton.tangent[0].abs());
                }
            }
        }
    }

    /// Trust: closed form (uniaxial σ_y, plane strain 2/√3 σ_y, equi-biaxial σ_y); the cut-off changes 1e-7.
    #[test]
    fn stress_states_match_their_closed_forms() {
        for (_, law) in Hardening::examples() {
            for (e, expected) in [
                ([1e-2, -5e-3, 0.0], [1.0, 0.0]),
                ([1e-2, 0.0, 0.0], [2.0 / 3f64.sqrt(), 1.0 / 3f64.sqrt()]),
                ([1e-2, 1e-2, 0.0], [1.0, 1.0]),
            ] {
                let response = at(&flow(&law, Iteration::PrimalDual), e);
                let sy = law.at(0.05 + response.increment).stress;
                assert_relative_eq!(response.stress[0], expected[0] * sy, max_relative = 1e-7);
                assert_relative_eq!(response.stress[1], expected[1] * sy, max_relative = 1e-7, epsilon = 1e-6);
                assert_relative_eq!(Hill48::default().equivalent_stress(response.stress), sy, max_relative = 1e-7);
            }
        }
    }

    /// Why it is sturdy: with w inside the yield surface the matrix has no negative eigenvalue, from whatever
    /// iterate it comes. (Newton's own has none either; its flat directions are what makes it jump.)
    #[test]
    fn primal_dual_matrix_is_positive_semidefinite_along_any_path() {
        for (name, law) in Hardening::examples() {
            let mut iterate = Iterate::start([0.0; 3]);
            for e in points() {
                let c = full(iterate.advance(&flow(&law, Iteration::PrimalDual), &PointState::at(0.05), e).tangent);
                let m = nalgebra::Matrix3::from_fn(|i, j| c[i][j]);
                let smallest = m.symmetric_eigenvalues().min();
                assert!(smallest > -1e-9 * m.norm(), "{name} {smallest}");
            }
        }
    }

    /// Trust: central differences with h = 1e-4 of the increment, for strain and spread; truncation near 1e-8 of the entries.
    #[test]
    fn newton_matrix_of_a_part_is_the_derivative_of_its_stress_and_moment() {
        for (name, hardening) in Hardening::examples() {
            for (r, rate) in [(1.0, None), (1.8, Some(Rate::examples()[0].1))] {
                let law =
                    FlowLaw { rate: rate.as_ref(), anisotropy: Hill48::new(r), ..flow(&hardening, Iteration::Newton) };
                for ([s, t, shear], [ks, kt]) in
                    points().into_iter().zip([[4e-3, 1e-3], [-2e-3, 0.0]].into_iter().cycle())
                {
                    let u = [s, t, shear, ks, kt];
                    let at = |u: [f64; 5]| {
                        let across = Iterate::default().advance_across(
                            &law,
                            &PointState::at(0.05),
                            [u[0], u[1], u[2]],
                            [u[3], u[4]],
                        );
                        across.expect("without voids")
                    };
                    let Across { update, coupling, bending, .. } = at(u);
                    let c = full(update.tangent);
                    let matrix = |i: usize, j: usize| match (i < 3, j < 3) {
                        (true, true) => c[i][j],
                        (true, false) => coupling[i][j - 3],
                        (false, true) => coupling[j][i - 3],
                        (false, false) => bending[i + j - 6],
                    };
                    let h = 1e-4 * u.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
                    for j in 0..5 {
                        let shifted = |sign: f64| {
                            let mut u = u;
                            u[j] += sign * h;
                            let Across { update, moment, .. } = at(u);
                            [update.stress[0], update.stress[1], update.stress[2], moment[0], moment[1]]
                        };
                        let (plus, minus) = (shifted(1.0), shifted(-1.0));
                        for i in 0..5 {
                            let difference = (plus[i] - minus[i]) / (2.0 * h);
                            let wrong = (matrix(i, j) - difference).abs();
                            assert!(wrong < 1e-5 * c[0][0].abs(), "{name}, r {r} {u:?} {i}{j}");
                        }
                    }
                }
            }
        }
    }

    /// Trust: with w the stress and the moment the primal-dual matrix is Newton's, and without a spread a part is a point, to
    /// round-off.
    #[test]
    fn a_part_with_its_own_stress_carried_has_newtons_matrix_and_one_without_spread_is_a_point() {
        let hardening = &Hardening::examples()[0].1;
        let (newton, dual) = (flow(hardening, Iteration::Newton), flow(hardening, Iteration::PrimalDual));
        let (point, spread) = (PointState::at(0.05), [3e-3, -1e-3]);
        for e in points() {
            let across = |law: &FlowLaw, start: &mut Iterate, spread: [f64; 2]| {
                start.advance_across(law, &point, e, spread).expect("without voids")
            };
            let by_newton = across(&newton, &mut Iterate::default(), spread);
            let mut own = Iterate { carried_moment: by_newton.moment, ..Iterate::start(by_newton.update.stress) };
            let by_dual = across(&dual, &mut own, spread);
            let scale = by_newton.update.tangent[0];
            for i in 0..6 {
                assert_relative_eq!(by_newton.update.tangent[i], by_dual.update.tangent[i], epsilon = 1e-9 * scale);
            }
            for i in 0..3 {
                assert_relative_eq!(by_newton.bending[i], by_dual.bending[i], epsilon = 1e-9 * scale);
            }
            let flat = across(&newton, &mut Iterate::default(), [0.0; 2]);
            let alone = at(&newton, e);
            for i in 0..3 {
                assert_relative_eq!(flat.update.stress[i], alone.stress[i], max_relative = 1e-14, epsilon = 1e-12);
            }
        }
    }
}
