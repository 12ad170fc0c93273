//! Hosford's yield condition for a sheet isotropic in its plane: with sharper corners than Hill's, by the crystals.
//!
//! ```text
//! φ^a = (|σ_s|^a + |σ_θ|^a + r̄ |σ_s − σ_θ|^a)/(1 + r̄)         a = 6 for bcc, 8 for fcc; a = 2 is Hill 1948
//! σ̄² = φ² + (3/k) σ_γ²                                          the transverse shear is added as Hill's condition has it
//! Δε̄² = ψ² + (k/3) Δγ²,   ψ(Δε) = max of σ·Δε over φ(σ) = 1      the dual potential
//! ```
//!
//! The stress of a strain increment is the point of the curve φ = 1 whose normal it is. With β = Δε_θ/Δε_s, |β| ≤ 1 and
//! Δε_s > 0, the ratio x = σ_θ/σ_s is the root of
//!
//! ```text
//! x|x|^(a−2) − r̄ (1 + β)(1 − x)^(a−1) − β = 0,   −1 ≤ x ≤ 1
//! ```
//!
//! whose left side rises. Gradient and second derivative of ½Δε̄² follow in closed form:
//!
//! ```text
//! σ = (1, x)/φ(1, x),   ∂½ψ²/∂Δε = ψ σ,   ∂²½ψ²/∂Δε² = σ⊗σ + x'(β)/φ² (−β, 1)⊗(−β, 1)
//! x'(β) = (∂φ/∂σ_s)²/κ,   φ ∂²φ/∂σ² = κ (−x, 1)⊗(−x, 1)
//! ```
//!
//! # References
//! W. F. Hosford, A generalized isotropic yield criterion, J. Appl. Mech. 39 (1972) 607–609 (not read); R. W. Logan,
//! W. F. Hosford, Upper-bound anisotropic yield loci, Int. J. Mech. Sci. 22 (1980) 419–430 (not read).

use super::hill48::{Hill48, SHEAR, SHEAR_INVERSE};
use super::yield_condition::{Metric, Triple, YieldCondition};
use crate::material::law::{LawError, require_range};
use crate::numerics::Power;

/// Exponents: from Hill's to beyond that of fcc; sharper corners than these find no equilibrium in whole runs \[–\].
const EXPONENT: [f64; 2] = [2.0, 10.0];
/// Step over its distances to 0 and to 1 after which x is right to round-off \[–\]: Halley's method is of third order.
const LAST: f64 = 1e-5;
/// Width of a bracket that is round-off \[–\].
const ROUND_OFF: f64 = 2e-16;
/// Ratios of strain increments that are one \[–\]: between them a chord is round-off.
const SAME: f64 = 1e-7;
/// Most iterations of the inner root: halving alone needs fifty.
const MOST: usize = 60;

/// The yield condition of r̄ and a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hosford {
    pub(super) quadratic: Hill48,
    power: Power,
    /// σ_θ/σ_s where Δε_θ = 0 \[–\].
    plane_strain: f64,
    /// 1/(1 + r̄) \[–\].
    inverse_weight: f64,
}

impl Hosford {
    /// For r̄ > 0 and a ≥ 2.
    pub fn new(r: f64, exponent: f64) -> Self {
        let root = r.powf(1.0 / (exponent - 1.0));
        let (plane_strain, inverse_weight) = (root / (1.0 + root), 1.0 / (1.0 + r));
        Self { quadratic: Hill48::new(r), power: Power::new(exponent), plane_strain, inverse_weight }
    }

    /// For r̄ of sheet metals, as [`Hill48::checked`], and an exponent of 2 to 10. Fails when one lies beyond.
    pub fn checked(r: f64, exponent: f64) -> Result<Self, LawError> {
        Hill48::checked(r)?;
        require_range(["exponent"; 2], exponent, EXPONENT, "6 for steel (bcc), 8 for aluminium (fcc)")?;
        Ok(Self::new(r, exponent))
    }

    /// a \[–\].
    pub fn exponent(&self) -> f64 {
        self.power.exponent
    }

    /// Equivalent stress σ̄ \[MPa\].
    pub fn equivalent_stress(&self, s: Triple) -> f64 {
        let (major, minor, _) = ordered(s);
        let size = if major == 0.0 { 0.0 } else { major.abs() * self.size(minor / major) };
        (size * size + SHEAR_INVERSE * s[2] * s[2]).sqrt()
    }

    /// φ(1, x).
    fn size(&self, x: f64) -> f64 {
        let (y, r) = (1.0 - x, self.quadratic.ratio);
        let sum = 1.0 + x * x * self.power.less_two(x.abs()) + r * y * y * self.power.less_two(y);
        self.power.root(sum / (1.0 + r))
    }

    /// Second derivative of ½φ² at the stress (1, x) and all along its ray: ss, sθ, θθ.
    pub(super) fn curvature(&self, x: f64) -> Triple {
        let (y, r) = (1.0 - x, self.quadratic.ratio);
        let (own, between) = (self.power.less_two(x.abs()), r * self.power.less_two(y));
        // (1 + r̄) φ^(a−1) ∂φ/∂σ, and its product with (1, x), which is (1 + r̄) φ^a
        let (along, across) = (1.0 + between * y, x * own - between * y);
        let sum = 1.0 + x * x * own + between * y * y;
        let unit = self.power.root(sum / (1.0 + r)) / sum;
        let square = unit * unit;
        let bend = (self.exponent() - 1.0) * (own * along + between * (1.0 + x * own));
        [along * along + bend * x * x, along * across - bend * x, across * across + bend].map(|entry| square * entry)
    }

    /// Ratio x whose normal goes with 1 and β, x'(β) or the chord from the ratio `w`, and 1/φ²; `sum` is 1 + β.
    fn root(&self, beta: f64, sum: f64, w: Option<f64>) -> [f64; 3] {
        let weight = self.quadratic.ratio * sum;
        let start = w.unwrap_or_else(|| self.guess(beta, sum));
        let [first, first_between, mut step] = self.halley(beta, weight, start);
        let (mut low, mut high) = (-1.0, 1.0);
        let (mut x, mut value) = (start, first);
        for _ in 0..MOST {
            (low, high) = if value > 0.0 { (low, x) } else { (x, high) };
            let next = x - step;
            let settled = step.abs() <= ROUND_OFF.max(LAST * (x * (1.0 - x)).abs());
            x = if settled || next >= low && next <= high { next } else { 0.5 * (low + high) };
            if settled || high - low <= ROUND_OFF {
                break;
            }
            [value, _, step] = self.halley(beta, weight, x);
        }
        let (y, r) = (1.0 - x, self.quadratic.ratio);
        let (own, between) = (self.power.less_two(x.abs()), r * self.power.less_two(y));
        let across = y * between;
        let turn = if w.is_some() { -first * sum / (sum + first_between) } else { 0.0 };
        let slope = || (1.0 + across) / ((self.exponent() - 1.0) * (own + sum * between));
        let rate = if turn.abs() > SAME { (x - start) / turn } else { slope() };
        [x, rate, self.power.inverse_square((1.0 + x * x * own + y * across) * self.inverse_weight)]
    }

    /// Residual, its part that goes with 1 + β, and a step of Halley's method towards the root; Newton's at the ends.
    fn halley(&self, beta: f64, weight: f64, x: f64) -> [f64; 3] {
        let (y, more) = (1.0 - x, self.exponent() - 2.0);
        let (own, between) = (self.power.less_two(x.abs()), weight * self.power.less_two(y));
        let (along, across) = (x * own, y * between);
        let value = along - across - beta;
        // With the bend (a − 2)(own/x − between/y) over own + between.
        let both = own + between;
        let space = x * y * both;
        let newton = value / ((1.0 + more) * both);
        let bend = 0.5 * more * newton * (y * own - x * between);
        [value, across, if space == 0.0 { newton } else { newton * space / (space - bend) }]
    }

    /// Linear between the known ratios of pure shear, tension, plane strain and equi-biaxial stretching: exact for Hill's.
    fn guess(&self, beta: f64, sum: f64) -> f64 {
        let (tension, plane) = (self.quadratic.coupling, self.plane_strain);
        if beta >= 0.0 {
            plane + (1.0 - plane) * beta
        } else if beta >= -tension {
            plane * (1.0 + beta / tension)
        } else {
            sum / (1.0 - tension) - 1.0
        }
    }
}

/// The larger one of the first two entries, the smaller one, and whether they are swapped.
pub(super) fn ordered(v: Triple) -> (f64, f64, bool) {
    if v[1].abs() > v[0].abs() { (v[1], v[0], true) } else { (v[0], v[1], false) }
}

impl YieldCondition for Hosford {
    /// Newton's method overshoots where the curve is flat; the chord to the strain of the carried stress does not.
    fn metric_towards(&self, e: Triple, w: Option<[f64; 2]>) -> Metric {
        let (major, minor, swapped) = ordered(e);
        if major == 0.0 {
            // No direction on the curve: Hill's matrix is as good as any.
            return self.quadratic.metric(e);
        }
        let inverse = 1.0 / major;
        let (beta, sum) = (minor * inverse, (major + minor) * inverse);
        let w = w.and_then(|[s, t]| {
            let [s, t] = if swapped { [t * inverse, s * inverse] } else { [s * inverse, t * inverse] };
            (s > 0.0).then(|| (t / s).clamp(-1.0, 1.0))
        });
        let [ratio, rate, inverse_square] = self.root(beta, sum, w);
        // ψ σ, of which ψ = |Δε_s| (1 + β x)/φ.
        let along = (major + minor * ratio) * inverse_square;
        let across = along * ratio;
        let bend = rate * inverse_square;
        let bent = bend * beta;
        let (own, mixed) = (inverse_square + bent * beta, ratio * inverse_square - bent);
        let other = ratio * ratio * inverse_square + bend;
        let shear = SHEAR * e[2];
        let square = along * major + across * minor + shear * e[2];
        let (gradient, [ss, tt]) =
            if swapped { ([across, along, shear], [other, own]) } else { ([along, across, shear], [own, other]) };
        Metric { gradient, matrix: [ss, mixed, tt, 0.0, 0.0, SHEAR], square }
    }
}

#[cfg(test)]
pub(super) mod tests;
