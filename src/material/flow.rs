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
//! # References
//! Zienkiewicz, Jain, Oñate, Int. J. Solids Struct. 14 (1978) 15–38; Sosnowski (1994), equations 3 and 4.

use super::yield_condition::dot;
use super::{Gtn, Hardening, Hill48, PointLaw, Rate, ThermalLaw};
use crate::units::ZERO_CELSIUS;

pub use super::point_law::StressUpdate;
pub use super::yield_condition::{Metric, SHEAR_FACTOR, Symmetric, Triple, YieldCondition};

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
}

impl PointState {
    /// A point of ordinary metal at room temperature.
    pub fn at(strain: f64) -> Self {
        Self { strain, porosity: 0.0, temperature: ROOM_TEMPERATURE }
    }
}

/// 20 °C \[K\].
pub const ROOM_TEMPERATURE: f64 = 20.0 + ZERO_CELSIUS;

/// What one thickness point remembers from one iteration to the next.
#[derive(Clone, Copy, Debug, Default)]
pub struct Iterate {
    /// The carried stress w of the primal-dual matrix \[MPa\].
    pub carried: Triple,
    strain: Triple,
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
    /// With a rate law and a thermal law σ_y = σ_s(ε̄) g(Δε̄_reg/Δt) h(T). The matrices are
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
    fn flow(&mut self, law: &FlowLaw, condition: &impl YieldCondition, point: &PointState, e: Triple) -> StressUpdate {
        let metric = condition.metric(e);
        let a = metric.gradient;
        let square = metric.square;
        let increment = square.sqrt();
        let inverse_square = 1.0 / (square + law.cutoff * law.cutoff);
        let inverse = inverse_square.sqrt();
        let share = condition.strain_share();
        let mut yielding = law.hardening.at_temperature(point.strain + share * increment, point.temperature);
        if let Some(rate) = law.rate {
            let factor = rate.at(share / (inverse * law.duration));
            yielding.slope *= factor.value;
            yielding.slope += yielding.stress * factor.slope * increment * inverse / law.duration;
            yielding.stress *= factor.value;
        }
        yielding.slope *= share;
        if let Some(softening) = law.softening {
            let factor = softening.at(point.temperature);
            yielding.slope *= factor;
            yielding.stress *= factor;
        }
        let f = yielding.stress * inverse;
        let h = if increment > 0.0 { yielding.slope * inverse / increment } else { 0.0 };
        let stress = [f * a[0], f * a[1], f * a[2]];

        // C = f A + ½ (a⊗b + b⊗a)
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
        (self.strain, self.fluidity, self.hardening, self.inverse_square) = (e, f, h, inverse_square);
        StressUpdate { stress, tangent, increment: share * increment, yield_stress: yielding.stress }
    }

    /// w ← σ + C δ(Δε) with the matrix of the last iterate, scaled back onto the yield surface.
    #[inline]
    fn carried_at(&self, condition: &impl YieldCondition, now: &Metric, e: Triple, yield_stress: f64) -> Triple {
        let mut w = self.carried;
        if self.fluidity > 0.0 {
            let last = condition.metric(self.strain);
            let a = last.gradient;
            let delta = [e[0] - self.strain[0], e[1] - self.strain[1], e[2] - self.strain[2]];
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
}
