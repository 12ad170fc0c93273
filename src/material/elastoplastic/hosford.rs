//! The way back onto Hosford's yield surface.
//!
//! ```text
//! m n + Δp D N = η,   n = ξ/σ_R,   N = ∂σ̄/∂σ at n,   m = σ_R + Δp C̄,   η = σ₀ + D Δε − Σ θ_i α_i0
//! n_γ = η_γ/(m + Δp D_γ 3/k),   (m ν + Δp D ∂φ/∂σ(ν)) ρ = η in the plane,   ρ² = φ²(n) = 1 − (3/k) n_γ²
//! ```
//!
//! For each Δp the ratio x of ν = (1, x)/φ(1, x) is the one at which the left side goes with η: with x it turns one way only,
//! from pure shear, x = −1, to equi-biaxial tension, x = 1. Δp is then the root of the yield condition, as Hill's is. The
//! tangent is
//!
//! ```text
//! S = (m D⁻¹ + Δp P)⁻¹,   P = ∂²½σ̄²/∂σ² at n,   b = m' n + D N − β
//! dσ = m S dε − (m S D⁻¹ b − m' n + β) dp,   dp = N·S dε/(N·S D⁻¹ b)
//! ```
//!
//! which are Hill's formulas where N = P n.

use super::{Carried, ElastoplasticLaw, MOST, Operators, Shifted, Trial, answer, each, moved, turned};
use crate::material::hosford::{Hosford, Place, ordered};
use crate::material::point_law::{StressUpdate, Tangent};
use crate::material::yield_condition::{SHEAR_FACTOR, Triple, dot};

/// The shear's entry of P.
const SHEAR: f64 = 3.0 / SHEAR_FACTOR;
/// Step over Δp, and of x, after which the next one is round-off: both methods are of second order \[–\].
const CLOSE: f64 = 1e-8;

/// A stress or a strain of the plane, the larger one first.
type Pair = [f64; 2];

/// How a point that yields stands once Δp is known.
struct Return {
    increment: f64,
    /// n = ξ/σ_R.
    direction: Triple,
    /// N.
    normal: Triple,
    /// P: ss, sθ, θθ.
    curvature: Triple,
    /// m, and its derivative by Δp.
    measure: f64,
    measure_slope: f64,
    /// β.
    recovered: Triple,
    radius: f64,
}

/// The elastic constants of the plane: on the diagonal and off it.
fn plane(operators: &Operators) -> Pair {
    let [sum, difference, _] = operators.elastic;
    [0.5 * (sum + difference), 0.5 * (sum - difference)]
}

/// D of a pair.
#[inline]
fn stiff([own, other]: Pair, v: Pair) -> Pair {
    [own * v[0] + other * v[1], other * v[0] + own * v[1]]
}

/// A place of the curve, and the left side there, times φ(1, x).
struct Side {
    place: Place,
    left: Pair,
    /// D ∂φ/∂σ times φ.
    flow: Pair,
    /// Derivative of the left side by x.
    slope: Pair,
}

impl Side {
    #[inline]
    fn at(hosford: &Hosford, d: Pair, x: f64, m: f64, increment: f64) -> Self {
        let place = hosford.at(x);
        let Place { size, normal, bend, .. } = place;
        let pull = stiff(d, normal);
        let turn = stiff(d, [-x, 1.0]);
        let flow = pull.map(|p| size * p);
        let left = [m + increment * flow[0], m * x + increment * flow[1]];
        let by = |i: usize| increment * (normal[1] * pull[i] + bend * turn[i]);
        Self { place, left, flow, slope: [by(0), m + by(1)] }
    }

    /// The ratio at which the left side goes with 1 and `h`, near `x`: Newton's method between bounds that close in.
    fn along(hosford: &Hosford, d: Pair, mut x: f64, m: f64, increment: f64, h: f64) -> Self {
        let (mut low, mut high) = (-1.0, 1.0);
        for round in 0.. {
            let side = Self::at(hosford, d, x, m, increment);
            let value = side.left[1] - h * side.left[0];
            let step = value / (side.slope[1] - h * side.slope[0]);
            if value > 0.0 {
                high = x
            } else {
                low = x
            }
            let next = x - step;
            if step.abs() <= CLOSE || round == MOST {
                return Self::at(hosford, d, next.clamp(-1.0, 1.0), m, increment);
            }
            x = if next >= low && next <= high { next } else { 0.5 * (low + high) };
        }
        unreachable!("the loop returns after its last round")
    }
}

impl ElastoplasticLaw<'_> {
    /// Apart from Hill's, so that that one stays small where it is called.
    #[inline(never)]
    pub(super) fn respond_by_hosford(
        &self,
        hosford: &Hosford,
        point: &Carried,
        trial: &mut Trial,
        e: Triple,
    ) -> (StressUpdate, Tangent) {
        let d = plane(&self.operators);
        let shear = self.operators.elastic[2];
        let [s, t] = stiff(d, [e[0], e[1]]);
        let tried = [point.stress[0] + s, point.stress[1] + t, point.stress[2] + shear * e[2]];
        let back = if self.kinematic.is_some() { point.back } else { [[0.0; 3]; 2] };
        let Some(at) = self.solve_by_hosford(hosford, point, tried, &back, trial.guess(turned(e))) else {
            *trial = Trial { strain: e, back: point.back, ..Trial::default() };
            return self.operators.unyielding(tried, point);
        };
        let (x, n, m, normal) = (at.increment, at.direction, at.measure, at.normal);
        let pull = stiff(d, [normal[0], normal[1]]);
        let flow = [pull[0], pull[1], shear * normal[2]];
        let stress = each(|j| tried[j] - x * flow[j]);

        // S and D⁻¹ b.
        let determinant = d[0] * d[0] - d[1] * d[1];
        let compliance = [d[0] / determinant, -d[1] / determinant];
        let [ss, st, tt] = at.curvature.map(|p| x * p);
        let (a, b, c) = (m * compliance[0] + ss, m * compliance[1] + st, m * compliance[0] + tt);
        let inverse = 1.0 / (a * c - b * b);
        let soft = [inverse * c, -inverse * b, inverse * a, 1.0 / (m / shear + x * SHEAR)];
        let softened = |v: Triple| [soft[0] * v[0] + soft[1] * v[1], soft[1] * v[0] + soft[2] * v[1], soft[3] * v[2]];
        let by: Triple = each(|j| at.measure_slope * n[j] - at.recovered[j]);
        let strained = stiff(compliance, [by[0], by[1]]);
        let moving = [strained[0] + normal[0], strained[1] + normal[1], by[2] / shear + normal[2]];
        let follows = softened(normal);
        let total = dot(follows, moving);
        let dp = follows.map(|f| f / total);
        let carried = softened(moving);
        let against: Triple = each(|j| if self.secant { 0.0 } else { m * carried[j] - by[j] });
        let entry = |i: usize, j: usize| -0.5 * (against[i] * dp[j] + against[j] * dp[i]);
        let tangent = [
            m * soft[0] + entry(0, 0),
            m * soft[1] + entry(0, 1),
            m * soft[2] + entry(1, 1),
            entry(0, 2),
            entry(1, 2),
            m * soft[3] + entry(2, 2),
        ];
        let back =
            self.kinematic.map_or(point.back, |kinematic| std::array::from_fn(|i| moved(&kinematic[i], back[i], x, n)));
        *trial = Trial { strain: e, increment: x, follows: turned(dp), back };
        answer(stress, tangent, x, at.radius)
    }

    /// Δp by Newton's method on 1 − 1/σ̄(n), between bounds that close in; `None` where the point does not yield.
    fn solve_by_hosford(
        &self,
        hosford: &Hosford,
        point: &Carried,
        tried: Triple,
        back: &[Triple; 2],
        guess: f64,
    ) -> Option<Return> {
        let hardening = self.hardening?;
        let volume = 1.0 + point.dilation;
        let size = hosford.equivalent_stress(each(|j| tried[j] - volume * (back[0][j] + back[1][j])));
        if size <= point.yield_stress {
            return None;
        }
        let (d, shear) = (plane(&self.operators), self.operators.elastic[2]);
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut x = if guess > 0.0 { guess } else { (size - point.yield_stress) / self.operators.both[1] };
        let mut ratio = f64::NAN;
        let mut settled = false;
        for round in 0.. {
            let radius = self.radius(hardening, point, x);
            let Shifted { modulus, modulus_slope, eta, recovered } = self.shifted(x, tried, back, volume);
            let (m, m_slope) = (radius.stress + x * modulus, radius.slope + modulus + x * modulus_slope);
            let (major, minor, swapped) = ordered(eta);
            let r = if swapped { [recovered[1], recovered[0]] } else { [recovered[0], recovered[1]] };
            let h = if major == 0.0 { 0.0 } else { minor / major };
            let h_slope = if major == 0.0 { 0.0 } else { (r[1] - h * r[0]) / major };
            let side = Side::along(hosford, d, if ratio.is_nan() { h } else { ratio }, m, x, h);
            let Side { place, left, flow, slope } = &side;
            ratio = place.ratio;
            // The shares of the plane and of the shear in n, and their derivatives by Δp.
            let by_increment = [m_slope + flow[0], m_slope * ratio + flow[1]];
            let ratio_slope = (left[0] * h_slope - by_increment[1] + h * by_increment[0]) / (slope[1] - h * slope[0]);
            let share = major * place.size / left[0];
            let left_slope = by_increment[0] + slope[0] * ratio_slope;
            let size_slope = place.normal[1] * ratio_slope;
            let share_slope = (r[0] * place.size + major * size_slope - share * left_slope) / left[0];
            let across = m + x * shear * SHEAR;
            let sheared = eta[2] / across;
            let sheared_slope = (recovered[2] - sheared * (m_slope + shear * SHEAR)) / across;
            let square = share * share + SHEAR * sheared * sheared;
            let slope = share * share_slope + SHEAR * sheared * sheared_slope;
            if square > 1.0 {
                low = x
            } else {
                high = x
            }
            if settled || round == MOST {
                let unit = share / place.size;
                let [along, other] = place.normal;
                let bend = place.bend;
                let entries =
                    [along * along + bend * ratio * ratio, along * other - bend * ratio, other * other + bend];
                let whole = |v: Pair| if swapped { [v[1], v[0], sheared] } else { [v[0], v[1], sheared] };
                let direction = whole([unit, unit * ratio]);
                let [s, t, _] = whole(place.normal.map(|n| share * n));
                let curvature = if swapped { [entries[2], entries[1], entries[0]] } else { entries };
                return Some(Return {
                    increment: x,
                    direction,
                    normal: [s, t, SHEAR * sheared],
                    curvature,
                    measure: m,
                    measure_slope: m_slope,
                    recovered,
                    radius: radius.stress,
                });
            }
            let mut next = x - (square.sqrt() - 1.0) * square / slope;
            settled = (next - x).abs() <= CLOSE * x;
            if !(settled || next >= low && next <= high) {
                next = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * x };
            }
            x = next;
        }
        unreachable!("the loop returns after its last round")
    }
}
