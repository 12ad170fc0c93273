//! Large-strain elasto-(visco)plastic metal at one thickness point.
//!
//! ```text
//! σ = σ₀ + D (Δε − Δε_p),   D = E/(1−ν²) [1 ν 0; ν 1 0; 0 0 k(1−ν)/2],  k = 5/6
//! Δε_p = Δp ∂σ̄/∂σ(ξ),   ξ = σ − Σ α_i,   σ̄(ξ) = σ_R = σ_y(ε̄ + Δp) g(Δp/Δt) h(T)
//! α_i = θ_i (α_i0 + Δp C_i ξ/σ_R),  θ_i = 1/(1 + γ_i Δp)
//! ```
//!
//! all at the end of the step (backward Euler). Strains are logarithmic and stresses stand in the element's own frame, which
//! turns with the sheet: no objective rate is needed. The stress σ is per initial volume (Kirchhoff's, Cauchy's times J),
//! which does work on logarithmic strains in a volume that stays. The metal yields by Cauchy's: σ_R, α_i and C_i above count
//! J times, J as the step begins. The elastic change of volume, ln J = (1 − 2ν)(σ_s + σ_θ)/E, is 0.4 to 0.6 % in stretched
//! aluminium and hardly changes in a step that flows: the lag costs 2e-5 of a force with the usual step.
//!
//! With n = ξ/σ_R, P = ∂²½σ̄²/∂σ² and g = P n = ∂½σ̄²/∂σ at n, m = σ_R + Δp C̄ and C̄ = Σ θ_i C_i, the return is
//!
//! ```text
//! S = (m D⁻¹ + Δp P)⁻¹,   n = S D⁻¹ η,   η = σ₀ + D Δε − Σ θ_i α_i0,   n·g = 1
//! b = D⁻¹ (m' n − β) + g,   dn/dp = −S b,   β = Σ γ_i θ_i² α_i0
//! dσ = m S dε − (m S b − m' n + β) dp,   dp = g·S dε/(g·S b)
//! ```
//!
//! A rate law with [`Rate::CowperSymonds`] is Perzyna's: ε̄̇ = C (σ̄/σ_s − 1)^p. Without one the metal is rate-free.
//!
//! # References
//! J. C. Simo, R. L. Taylor, Int. J. Num. Meth. Engng. 22 (1986) 649; P. Perzyna, Adv. Appl. Mech. 9 (1966) (not read).

use super::point_law::{PointSnapshot, Response, StressUpdate, Tangent};
use super::yield_condition::{Symmetric, Triple, dot};
use super::{Elastic, FlowStress, Hardening, Hosford, PointLaw, Rate, Surroundings, ThermalLaw, YieldCriterion};
use super::{chaboche::BackStresses, hill48::SHEAR_INVERSE, hosford::ordered};

/// Most iterations: bisection alone needs fifty.
const MOST: usize = 80;
/// Step after which the next one is round-off \[–\]: Newton's method is of second order.
const CLOSE: f64 = 1e-8;

/// Symmetric matrix of the plane and the transverse shear: ss, sθ, θθ, γγ.
type Orthotropic = [f64; 4];

fn times([ss, st, tt, gg]: Orthotropic, [s, t, g]: Triple) -> Triple {
    [ss * s + st * t, st * s + tt * t, gg * g]
}

fn inverse([ss, st, tt, gg]: Orthotropic) -> Orthotropic {
    let determinant = ss * tt - st * st;
    [tt / determinant, -st / determinant, ss / determinant, 1.0 / gg]
}

/// Law of all thickness points in an iteration.
#[derive(Clone, Copy, Debug)]
pub struct ElastoplasticLaw<'a> {
    /// `None` for metal that does not yield: the unloading of a sheet that the flow law has formed.
    pub hardening: Option<&'a Hardening>,
    /// Elasticity and yield condition of the sheet.
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

/// State of a thickness point at the start of the step.
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
    /// Resistance of its surroundings.
    pub surroundings: Surroundings,
}

/// Last evaluation of a thickness point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trial {
    /// Δε \[–\].
    pub strain: Triple,
    /// Δp \[–\].
    pub increment: f64,
    /// ∂Δp/∂Δε \[–\].
    slope: Triple,
    /// α_i at the end of the step \[MPa\].
    pub back: [Triple; 2],
}

impl Trial {
    /// Δp at another strain increment, extrapolated \[–\].
    fn guess(&self, e: Triple) -> f64 {
        let increment = self.increment + dot(self.slope, each(|j| e[j] - self.strain[j]));
        if increment > 0.0 { increment } else { self.increment }
    }
}

/// Share of Δp that the last iteration may still add \[–\]: stress and tangent follow it to first order.
const LAST: f64 = 1e-5;
/// Plastic strain rate at and below which a rate law is constant \[1/s\]: zero has no logarithm.
const SLOWEST: f64 = 1e-12;

#[inline(always)]
fn each(entry: impl Fn(usize) -> f64) -> Triple {
    [entry(0), entry(1), entry(2)]
}

fn response(stress: Triple, own: Symmetric, increment: f64, yield_stress: f64) -> Response {
    (StressUpdate { stress, increment, yield_stress, ..StressUpdate::default() }, Tangent { own, ..Tangent::default() })
}

struct Return {
    increment: f64,
    /// n.
    direction: Triple,
    /// P.
    curvature: Orthotropic,
    /// m and its derivative by Δp.
    measure: f64,
    measure_slope: f64,
    /// β.
    recovered: Triple,
    radius: f64,
}

impl PointLaw for ElastoplasticLaw<'_> {
    type PointState = Carried;
    type Iterate = Trial;

    /// Stress and tangent; with the dynamic recovery of back-stresses the tangent's symmetric part.
    fn respond(&self, point: &Carried, trial: &mut Trial, e: Triple, _: [f64; 2]) -> Response {
        let Operators { stiffness, compliance, .. } = self.operators;
        let elastic = times(stiffness, e);
        let tried = each(|j| point.stress[j] + elastic[j]);
        let guess = trial.guess(e);
        let Some(at) = self.hardening.and_then(|hardening| self.return_mapping(hardening, point, tried, guess)) else {
            *trial = Trial { strain: e, back: point.back, ..Trial::default() };
            let [ss, st, tt, gg] = stiffness;
            return response(tried, [ss, st, tt, 0.0, 0.0, gg], 0.0, point.yield_stress);
        };
        let Return { increment: x, direction: n, measure: m, curvature, .. } = at;
        let normal = times(curvature, n);
        let plastic = times(stiffness, normal);
        let stress = each(|j| tried[j] - x * plastic[j]);

        let soft = inverse(self.operators.flexibility(m, x, curvature));
        let shift = each(|j| at.measure_slope * n[j] - at.recovered[j]);
        let [b, along] = [times(compliance, shift), times(soft, normal)];
        let b = each(|j| b[j] + normal[j]);
        let slope = along.map(|s| s / dot(along, b));
        let turn = times(soft, b);
        let against = each(|j| if self.secant { 0.0 } else { m * turn[j] - shift[j] });
        let entry = |i: usize, j: usize| -0.5 * (against[i] * slope[j] + against[j] * slope[i]);
        let [ss, st, tt, gg] = soft.map(|s| m * s);
        let own = [ss + entry(0, 0), st + entry(0, 1), tt + entry(1, 1), entry(0, 2), entry(1, 2), gg + entry(2, 2)];
        let mut back = point.back;
        for (law, back) in self.kinematic.iter().flatten().zip(&mut back) {
            let theta = 1.0 / (1.0 + law.dynamic_recovery * x);
            *back = each(|j| theta * (back[j] + x * law.modulus * n[j]));
        }
        *trial = Trial { strain: e, increment: x, slope, back };
        response(stress, own, x, at.radius)
    }

    fn snapshot(&self, point: &Carried, trial: &Trial, update: &StressUpdate) -> PointSnapshot {
        let elastic = times(self.operators.stiffness, trial.strain);
        let tangent = self.respond(point, &mut trial.clone(), trial.strain, [0.0; 2]).1;
        let trial_stress = Some(each(|j| point.stress[j] + elastic[j]));
        PointSnapshot { trial_stress, ..update.snapshot(trial.strain, point.strain, &tangent) }
    }
}

impl ElastoplasticLaw<'_> {
    /// Size of the yield surface at the start of the step \[MPa\]; infinite for elastic metal.
    pub fn yield_stress(&self, point: &Carried) -> f64 {
        self.hardening.map_or(f64::INFINITY, |hardening| self.radius(hardening, point, 0.0).stress)
    }

    fn radius(&self, hardening: &Hardening, point: &Carried, increment: f64) -> FlowStress {
        let yielding = hardening.at_temperature(point.strain + increment, point.temperature);
        let rate = increment / self.duration;
        let by_increment = if rate > SLOWEST { 1.0 / self.duration } else { 0.0 };
        let yielding = yielding.at_rate(self.rate, rate.max(SLOWEST), by_increment);
        let softening = self.softening.map_or(1.0, |law| law.at(point.temperature));
        point.surroundings.held(yielding.times(softening * (1.0 + point.dilation)), increment)
    }

    /// C̄ and its derivative by Δp, η and β, its derivative, after Δp.
    fn shifted(&self, increment: f64, tried: Triple, point: &Carried) -> ([f64; 2], Triple, Triple) {
        let ([mut modulus, mut modulus_slope], mut eta, mut recovered) = ([0.0; 2], tried, [0.0; 3]);
        let volume = 1.0 + point.dilation;
        for (law, back) in self.kinematic.iter().flatten().zip(&point.back) {
            let theta = 1.0 / (1.0 + law.dynamic_recovery * increment);
            let (left, slope) = (volume * theta, volume * law.dynamic_recovery * theta * theta);
            modulus += law.modulus * left;
            modulus_slope -= law.modulus * slope;
            for j in 0..3 {
                eta[j] -= left * back[j];
                recovered[j] += slope * back[j];
            }
        }
        ([modulus, modulus_slope], eta, recovered)
    }

    /// Δp from n·g = 1 by Newton's method on 1 − 1/√(n·g), which is all but straight, between bounds that close in.
    /// `None` if the point does not yield; `guess` is a Δp that may come close, or 0.
    fn return_mapping(&self, hardening: &Hardening, point: &Carried, tried: Triple, guess: f64) -> Option<Return> {
        let Operators { stiffness, compliance, quadratic, hosford } = &self.operators;
        let start = self.shifted(0.0, tried, point).1;
        let size =
            hosford.map_or_else(|| dot(start, times(*quadratic, start)).sqrt(), |law| law.equivalent_stress(start));
        if size <= point.yield_stress {
            return None;
        }
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let first = (size - point.yield_stress) / ((stiffness[0] - stiffness[1]) * (quadratic[0] - quadratic[1]));
        let mut x = if guess > 0.0 { guess } else { first };
        let (mut ratio, last) = (None, if hosford.is_some() { CLOSE } else { LAST });
        for round in 0.. {
            let radius = self.radius(hardening, point, x);
            let ([modulus, modulus_slope], eta, recovered) = self.shifted(x, tried, point);
            let (m, measure_slope) = (radius.stress + x * modulus, radius.slope + modulus + x * modulus_slope);
            let curvature = match hosford {
                Some(hosford) => self.operators.curvature(hosford, eta, m, x, &mut ratio),
                None => *quadratic,
            };
            let soft = inverse(self.operators.flexibility(m, x, curvature));
            let n = times(soft, times(*compliance, eta));
            let normal = times(curvature, n);
            let shift = times(*compliance, each(|j| measure_slope * n[j] - recovered[j]));
            let turn = times(soft, each(|j| -shift[j] - normal[j]));
            let square = dot(n, normal);
            (low, high) = if square > 1.0 { (x, high) } else { (low, x) };
            let mut next = x - (square.sqrt() - 1.0) * square / dot(normal, turn);
            if !(next >= low && next <= high) {
                next = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * x };
            }
            let step = next - x;
            if step.abs() <= last * x || round == MOST {
                let (increment, direction) = (next, each(|j| n[j] + step * turn[j]));
                let (measure, radius) = (m + step * measure_slope, radius.stress + step * radius.slope);
                return Some(Return { increment, direction, curvature, measure, measure_slope, recovered, radius });
            }
            x = next;
        }
        unreachable!("the loop returns after its last round")
    }
}

/// Elastic matrix and yield condition of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Operators {
    /// D \[MPa\].
    stiffness: Orthotropic,
    /// D⁻¹ \[1/MPa\].
    compliance: Orthotropic,
    /// P of Hill's condition of the same r̄ \[–\].
    quadratic: Orthotropic,
    /// `None` for Hill's condition.
    hosford: Option<Hosford>,
}

impl Operators {
    /// Operators of a sheet with these elastic constants and yield condition.
    pub fn new(elastic: Elastic, criterion: YieldCriterion) -> Self {
        let [sum, difference, shear] = elastic.moduli();
        let stiffness = [0.5 * (sum + difference), 0.5 * (sum - difference), 0.5 * (sum + difference), shear];
        let hosford = if let YieldCriterion::Hosford(hosford) = criterion { Some(hosford) } else { None };
        let quadratic = [1.0, -criterion.quadratic().coupling, 1.0, SHEAR_INVERSE];
        Self { stiffness, compliance: inverse(stiffness), quadratic, hosford }
    }

    /// m D⁻¹ + Δp P.
    fn flexibility(&self, m: f64, increment: f64, p: Orthotropic) -> Orthotropic {
        std::array::from_fn(|j| m * self.compliance[j] + increment * p[j])
    }

    /// P at n = S D⁻¹ η by Newton's method for the ratio x of n, which rises with that of η from −1 to 1.
    /// `near` is a ratio close to the root, and becomes the root.
    fn curvature(&self, hosford: &Hosford, eta: Triple, m: f64, increment: f64, near: &mut Option<f64>) -> Orthotropic {
        let (major, minor, swapped) = ordered(eta);
        let ratio = if major == 0.0 { 0.0 } else { minor / major };
        let pull = times(self.compliance, [1.0, ratio, 0.0]);
        let p = |x: f64| {
            let [ss, st, tt] = hosford.curvature(x);
            [ss, st, tt, SHEAR_INVERSE]
        };
        let (mut low, mut high) = (-1.0, 1.0);
        let mut x = near.unwrap_or(ratio);
        for _ in 0..MOST {
            let flexibility = self.flexibility(m, increment, p(x));
            let [s, t, _] = times(self.stiffness, times(flexibility, [1.0, x, 0.0]));
            (low, high) = if t > ratio * s { (low, x) } else { (x, high) };
            let [s, t, _] = times(inverse(flexibility), pull);
            let (next, last) = (t / s, x);
            x = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            if (x - last).abs() <= CLOSE {
                break;
            }
        }
        *near = Some(x);
        let [ss, st, tt, gg] = p(x);
        if swapped { [tt, st, ss, gg] } else { [ss, st, tt, gg] }
    }
}

#[cfg(test)]
mod tests;
