//! Large-strain elasto-(visco)plastic metal at one thickness point.
//!
//! ```text
//! σ = σ₀ + D (Δε − Δε_p),   D = E/(1−ν²) [1 ν 0; ν 1 0; 0 0 k(1−ν)/2],  k = 5/6
//! Δε_p = Δp P ξ/σ_R,   ξ = σ − Σ α_i,   σ̄²(ξ) = ξᵀ P ξ = σ_R²,   σ_R = σ_y(ε̄ + Δp) g(Δp/Δt) h(T)
//! α_i = θ_i (α_i0 + Δp C_i ξ/σ_R),  θ_i = 1/(1 + γ_i Δp)
//! ```
//!
//! all at the END of the step (backward Euler). In the sum and the difference of the two stresses D and P are both
//! diagonal, so that the stress follows from Δp in closed form and Δp from one scalar equation. Strains are logarithmic and
//! stresses stand in the element's own frame, which turns with the sheet: no objective rate is needed. The stress σ here is per
//! initial volume (Kirchhoff's, Cauchy's times J), for that does work on logarithmic strains in a volume that stays. The metal
//! yields by Cauchy's: σ_R, α_i and C_i above count J times, J as the step begins. The elastic change of volume,
//! ln J = (1 − 2ν)(σ_s + σ_θ)/E, is 0.4 to 0.6 % in stretched aluminium, and changes by next to nothing in a step that flows:
//! what the lag does is first order in the step, 2e-5 of a force with the usual one.
//!
//! A rate law with [`Rate::CowperSymonds`] is Perzyna's: ε̄̇ = C (σ̄/σ_s − 1)^p. Without one the metal is rate-free.
//!
//! # References
//! J. C. Simo, R. L. Taylor, Int. J. Num. Meth. Engng. 22 (1986) 649–670 (plane-stress return mapping and its tangent);
//! P. Perzyna, Adv. Appl. Mech. 9 (1966) 243–377 (not read).

mod hosford;

use super::chaboche::{BackStress, BackStresses};
use super::point_law::{StressUpdate, Tangent};
use super::yield_condition::{SHEAR_FACTOR, Symmetric, Triple};
use super::{Elastic, FlowStress, Hardening, Hosford, PointLaw, Rate, Surroundings, ThermalLaw, YieldCriterion};
use std::f64::consts::FRAC_1_SQRT_2;

/// What is the same for every thickness point in an iteration.
#[derive(Clone, Copy, Debug)]
pub struct ElastoplasticLaw<'a> {
    /// `None` for metal that does not yield: the unloading of a sheet that the flow law has formed.
    pub hardening: Option<&'a Hardening>,
    /// D and P of the sheet.
    pub operators: Operators,
    /// By [`chaboche::shifting`](super::chaboche::shifting).
    pub kinematic: Option<BackStresses>,
    /// `None` for a rate-free metal.
    pub rate: Option<&'a Rate>,
    /// `None` for a metal that does not feel its temperature.
    pub softening: Option<&'a ThermalLaw>,
    /// Leaves the tangent's last term out, which follows the flow: sturdier far from the answer.
    pub secant: bool,
    /// Δt of the step \[s\].
    pub duration: f64,
}

/// D and P in the sum and the difference of the meridional and the hoop stress, and in the transverse shear.
#[derive(Clone, Copy, Debug)]
pub struct Operators {
    elastic: Triple,
    yielding: Triple,
    /// D P.
    both: Triple,
    /// The yield condition where it is not quadratic; P is then Hill's of the same r̄.
    hosford: Option<Hosford>,
}

impl Operators {
    /// Of a sheet's elastic constants and yield condition.
    pub fn new(elastic: Elastic, criterion: YieldCriterion) -> Self {
        let (elastic, q) = (elastic.moduli(), criterion.quadratic().coupling());
        let yielding = [1.0 - q, 1.0 + q, 3.0 / SHEAR_FACTOR];
        let hosford = match criterion {
            YieldCriterion::Hill48(_) => None,
            YieldCriterion::Hosford(hosford) => Some(hosford),
        };
        Self { elastic, yielding, both: each(|j| elastic[j] * yielding[j]), hosford }
    }

    /// The answer of a point that stays elastic.
    #[inline]
    fn unyielding(&self, stress: Triple, point: &Carried) -> (StressUpdate, Tangent) {
        let d = self.elastic;
        let sum = 0.5 * (d[0] + d[1]);
        let tangent = [sum, d[0] - sum, sum, 0.0, 0.0, d[2]];
        answer(stress, tangent, 0.0, point.yield_stress)
    }
}

/// A thickness point as the step finds it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Carried {
    /// ε̄, equivalent plastic strain \[–\].
    pub strain: f64,
    /// T \[K\].
    pub temperature: f64,
    /// Size of the yield surface of σ, by [`ElastoplasticLaw::yield_stress`] \[MPa\].
    pub yield_stress: f64,
    /// σ₀ \[MPa\].
    pub stress: Triple,
    /// J − 1 by σ₀ \[–\].
    pub dilation: f64,
    /// α_i \[MPa\].
    pub back: [Triple; 2],
    /// What flows around it.
    pub surroundings: Surroundings,
}

/// What one thickness point keeps of its last evaluation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trial {
    /// Δε \[–\].
    pub strain: Triple,
    /// Δp \[–\].
    pub increment: f64,
    /// ∂Δp/∂Δε, in the sum, the difference and the shear: what the next iteration's Δp will be \[–\].
    follows: Triple,
    /// α_i at the end of the step \[MPa\].
    pub back: [Triple; 2],
}

impl Trial {
    /// Δp that goes with another strain increment, in the sum, the difference and the shear, if Δp follows it \[–\].
    #[inline]
    fn guess(&self, strain: Triple) -> f64 {
        let (last, f) = (turned(self.strain), self.follows);
        let moved = f[0] * (strain[0] - last[0]) + f[1] * (strain[1] - last[1]) + f[2] * (strain[2] - last[2]);
        if self.increment + moved > 0.0 { self.increment + moved } else { self.increment }
    }
}

/// Most iterations for Δp: bisection alone needs fifty.
const MOST: usize = 80;
/// Share of Δp that the last iteration may still add \[–\]: what it adds to stress and tangent is taken along, and its
/// square is below what any answer is asked for.
const LAST: f64 = 1e-5;

/// Three entries, one after another.
#[inline(always)]
fn each(of: impl Fn(usize) -> f64) -> Triple {
    [of(0), of(1), of(2)]
}

/// To the sum and difference of the first two entries over √2, which is its own inverse.
#[inline]
fn turned(v: Triple) -> Triple {
    [FRAC_1_SQRT_2 * (v[0] + v[1]), FRAC_1_SQRT_2 * (v[0] - v[1]), v[2]]
}

#[inline]
fn answer(stress: Triple, own: Symmetric, increment: f64, yield_stress: f64) -> (StressUpdate, Tangent) {
    let update = StressUpdate { stress, increment, yield_stress, ..StressUpdate::default() };
    (update, Tangent { own, ..Tangent::default() })
}

/// A back-stress once Δp has been added along n.
#[inline]
fn moved(law: &BackStress, back: Triple, x: f64, n: Triple) -> Triple {
    let theta = 1.0 / (1.0 + law.dynamic_recovery * x);
    each(|j| theta * (back[j] + x * law.modulus * n[j]))
}

/// What back-stresses do to the return: C̄ and its derivative by Δp, η = σ₀ + D Δε − Σ θ_i α_i0, and β, its derivative.
struct Shifted {
    modulus: f64,
    modulus_slope: f64,
    eta: Triple,
    recovered: Triple,
}

/// How a point that yields stands once Δp is known.
struct Return {
    increment: f64,
    /// n = ξ/σ_R.
    direction: Triple,
    /// m = σ_R + Δp (C̄ + D P), and its derivative by Δp.
    measure: Triple,
    measure_slope: Triple,
    /// β = Σ γ_i θ_i² α_i0.
    recovered: Triple,
    radius: f64,
}

impl PointLaw for ElastoplasticLaw<'_> {
    type PointState = Carried;
    type Iterate = Trial;

    /// Stress, tangent and Δp that go with the strain increment `e`; the tangent is symmetric but for the dynamic recovery of
    /// back-stresses, of which its symmetric part is given.
    #[inline]
    fn respond(&self, point: &Carried, trial: &mut Trial, e: Triple, _: [f64; 2]) -> (StressUpdate, Tangent) {
        if let Some(hosford) = &self.operators.hosford {
            return self.respond_by_hosford(hosford, point, trial, e);
        }
        let Operators { elastic: d, both, .. } = self.operators;
        let (strain, start) = (turned(e), turned(point.stress));
        let tried: Triple = each(|j| start[j] + d[j] * strain[j]);
        let back = if self.kinematic.is_some() { point.back.map(turned) } else { [[0.0; 3]; 2] };
        let guess = trial.guess(strain);
        let found = self.hardening.and_then(|hardening| self.solve(hardening, point, tried, &back, guess));
        let Some(at) = found else {
            *trial = Trial { strain: e, back: point.back, ..Trial::default() };
            return self.operators.unyielding(turned(tried), point);
        };
        let (x, n, m) = (at.increment, at.direction, at.measure);
        let stress = turned(each(|j| tried[j] - x * both[j] * n[j]));
        let back = self
            .kinematic
            .map_or(point.back, |kinematic| std::array::from_fn(|i| turned(moved(&kinematic[i], back[i], x, n))));

        // dσ = (I − Δp D P/m) D dε − D P (n − Δp (n m' − β)/m) dp,  dp = Σ P n/m D dε / N
        let inverse = each(|j| 1.0 / m[j]);
        let by: Triple = each(|j| n[j] * at.measure_slope[j] - at.recovered[j]);
        let p = self.operators.yielding;
        let along: Triple = each(|j| p[j] * n[j] * inverse[j]);
        let normal = along[0] * by[0] + along[1] * by[1] + along[2] * by[2];
        let follow = if self.secant { 0.0 } else { 1.0 / normal };
        let own: Triple = each(|j| (1.0 - x * both[j] * inverse[j]) * d[j]);
        let against: Triple = each(|j| follow * both[j] * (n[j] - x * by[j] * inverse[j]));
        let dp: Triple = each(|j| along[j] * d[j]);
        *trial = Trial { strain: e, increment: x, follows: each(|j| dp[j] / normal), back };
        let entry = |i: usize, j: usize| -0.5 * (against[i] * dp[j] + against[j] * dp[i]);
        let (aa, bb, ab) = (own[0] + entry(0, 0), own[1] + entry(1, 1), entry(0, 1));
        let (ac, bc) = (FRAC_1_SQRT_2 * entry(0, 2), FRAC_1_SQRT_2 * entry(1, 2));
        let (mean, half) = (0.5 * (aa + bb), 0.5 * (aa - bb));
        let tangent = [mean + ab, half, mean - ab, ac + bc, ac - bc, own[2] + entry(2, 2)];
        answer(stress, tangent, x, at.radius)
    }
}

impl ElastoplasticLaw<'_> {
    /// Size of the yield surface where the step finds it \[MPa\]; infinite where nothing yields.
    pub fn yield_stress(&self, point: &Carried) -> f64 {
        self.hardening.map_or(f64::INFINITY, |hardening| self.radius(hardening, point, 0.0).stress)
    }

    /// Size of the yield surface once Δp has been added, and its slope.
    #[inline]
    fn radius(&self, hardening: &Hardening, point: &Carried, increment: f64) -> FlowStress {
        let mut yielding = hardening.at_temperature(point.strain + increment, point.temperature);
        if let Some(rate) = self.rate {
            // A rate of zero has no logarithm and no power: what is slower than this bears the same.
            let factor = rate.at((increment / self.duration).max(SLOWEST));
            yielding.slope *= factor.value;
            if increment > SLOWEST * self.duration {
                yielding.slope += yielding.stress * factor.slope / self.duration;
            }
            yielding.stress *= factor.value;
        }
        if let Some(softening) = self.softening {
            let factor = softening.at(point.temperature);
            yielding.slope *= factor;
            yielding.stress *= factor;
        }
        let volume = 1.0 + point.dilation;
        yielding.slope *= volume;
        yielding.stress *= volume;
        point.surroundings.hold(&mut yielding, increment);
        yielding
    }

    /// What the back-stresses do once Δp has been added.
    #[inline]
    fn shifted(&self, increment: f64, tried: Triple, back: &[Triple; 2], volume: f64) -> Shifted {
        let mut shifted = Shifted { modulus: 0.0, modulus_slope: 0.0, eta: tried, recovered: [0.0; 3] };
        for (law, back) in self.kinematic.iter().flatten().zip(back) {
            let theta = 1.0 / (1.0 + law.dynamic_recovery * increment);
            let (left, by_increment) = (volume * theta, volume * law.dynamic_recovery * theta * theta);
            shifted.modulus += law.modulus * left;
            shifted.modulus_slope -= law.modulus * by_increment;
            for j in 0..3 {
                shifted.eta[j] -= left * back[j];
                shifted.recovered[j] += by_increment * back[j];
            }
        }
        shifted
    }

    /// Δp from the yield condition Σ P (η/m)² = 1, by Newton's method on 1 − 1/√Σ, which is all but straight, between
    /// bounds that close in; `None` where the point does not yield. `guess` is a Δp that may come close, or 0.
    #[inline]
    fn solve(
        &self,
        hardening: &Hardening,
        point: &Carried,
        tried: Triple,
        back: &[Triple; 2],
        guess: f64,
    ) -> Option<Return> {
        let Operators { yielding: p, both, .. } = self.operators;
        let volume = 1.0 + point.dilation;
        let shifted: Triple = each(|j| tried[j] - volume * (back[0][j] + back[1][j]));
        let size =
            (p[0] * shifted[0] * shifted[0] + p[1] * shifted[1] * shifted[1] + p[2] * shifted[2] * shifted[2]).sqrt();
        if size <= point.yield_stress {
            return None;
        }
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut x = if guess > 0.0 { guess } else { (size - point.yield_stress) / both[1] };
        for round in 0.. {
            let radius = self.radius(hardening, point, x);
            let Shifted { modulus, modulus_slope, eta, recovered } = self.shifted(x, tried, back, volume);
            let mut m: Triple = each(|j| radius.stress + x * (modulus + both[j]));
            let m_slope: Triple = each(|j| radius.slope + modulus + both[j] + x * modulus_slope);
            let inverse = each(|j| 1.0 / m[j]);
            let mut n: Triple = each(|j| eta[j] * inverse[j]);
            let n_slope: Triple = each(|j| (recovered[j] - n[j] * m_slope[j]) * inverse[j]);
            let square = p[0] * n[0] * n[0] + p[1] * n[1] * n[1] + p[2] * n[2] * n[2];
            let slope = p[0] * n[0] * n_slope[0] + p[1] * n[1] * n_slope[1] + p[2] * n[2] * n_slope[2];
            if square > 1.0 {
                low = x
            } else {
                high = x
            }
            let mut next = x - (square.sqrt() - 1.0) * square / slope;
            if !(next >= low && next <= high) {
                next = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * x };
            }
            let step = next - x;
            if step.abs() <= LAST * x || round == MOST {
                for j in 0..3 {
                    m[j] += step * m_slope[j];
                    n[j] += step * n_slope[j];
                }
                let radius = radius.stress + step * radius.slope;
                return Some(Return {
                    increment: next,
                    direction: n,
                    measure: m,
                    measure_slope: m_slope,
                    recovered,
                    radius,
                });
            }
            x = next;
        }
        unreachable!("the loop returns after its last round")
    }
}

/// Plastic strain rate below which a rate law is not asked \[1/s\].
const SLOWEST: f64 = 1e-12;

#[cfg(test)]
mod tests;
