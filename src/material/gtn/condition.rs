//! The yield condition of a voided sheet in plane stress and what goes with it, in viscous form.
//!
//! ```text
//! Φ = sᵀ P s + 2 q₁ f* cosh(q₂ m/2) − 1 − q₃ f*² = 0,   s = σ/σ_y,  m = s_s + s_θ,  P = A₀⁻¹ of the metal without voids
//! D(Δε) = max { sᵀΔε : Φ(s) ≤ 0 },   σ = σ_y ∂D/∂Δε,   (1 − f) Δε̄ = D
//! ```
//!
//! D plays the part of the equivalent strain increment: without voids it is √(Δεᵀ A₀ Δε). With the parts of Δε along and
//! across i = (1, 1, 0), M = iᵀA₀Δε and E² = ΔεᵀA₀Δε − M²/2c, where c = A₀ss + A₀sθ, the stress is
//! s = κ A_d Δε + (m/2) i with
//!
//! ```text
//! κ M = m + c g(m),   g = q₁ q₂ f* sinh(q₂ m/2),   κ² E² = 1 + q₃ f*² − 2 q₁ f* cosh(q₂ m/2) − m²/2c =: Y(m)
//! ```
//!
//! so that m is the root of M² Y − E² (m + c g)², which is concave and falls: Newton's method descends to it from the root
//! without voids.
//!
//! # References
//! A. L. Gurson, J. Eng. Mater. Technol. 99 (1977) 2–15; V. Tvergaard, Int. J. Fract. 17 (1981) 389–407; V. Tvergaard,
//! A. Needleman, Acta Metall. 32 (1984) 157–169; for the flow approach E. Oñate, C. Agelet de Saracibar, in: Modelling of
//! Metal Forming Processes, Kluwer (1988). None of them could be read; the condition is in common use.

use super::Gtn;
use crate::material::hill48::{Hill48, SHEAR};
use crate::material::yield_condition::{Metric, Triple, YieldCondition, dot};

/// Newton's method stops when m moves by less than this \[–\].
const ROOT: f64 = 1e-14;
const MOST_ROOTS: usize = 60;

/// The yield condition of one point.
#[derive(Clone, Copy, Debug)]
pub struct GtnCondition {
    anisotropy: Hill48,
    q2: f64,
    /// q₁ f*, 1 + q₃ f*², 1/(1 − f) and c.
    q1f: f64,
    top: f64,
    share: f64,
    c: f64,
}

/// Maximum of the dissipation: normalised stresses, D and the parts of the strain increment.
#[derive(Clone, Copy, Debug)]
struct Place {
    m: f64,
    kappa: f64,
    /// M, E² and c g.
    along: f64,
    across: f64,
    growth: f64,
    dissipation: f64,
}

impl Gtn {
    /// The yield condition at the porosity `f` \[–\].
    pub fn condition(&self, anisotropy: Hill48, f: f64) -> GtnCondition {
        let effective = self.effective(f);
        GtnCondition {
            anisotropy,
            q2: self.q2,
            q1f: self.q1 * effective,
            top: 1.0 + self.q3 * effective * effective,
            share: 1.0 / (1.0 - f),
            c: anisotropy.direct + anisotropy.coupled,
        }
    }
}

impl GtnCondition {
    fn place(&self, e: Triple) -> Place {
        let (c, q1f, q2) = (self.c, self.q1f, self.q2);
        let a = self.anisotropy.apply(e);
        let along = a[0] + a[1];
        let whole = dot(e, a);
        let across = (whole - along * along / (2.0 * c)).max(0.0);
        if whole == 0.0 {
            return Place { m: 0.0, kappa: 0.0, along, across, growth: 0.0, dissipation: 0.0 };
        }
        // Scaled, so that tiny increments do not underflow.
        let (m2, e2) = (along * along / whole, across / whole);
        let mut m = along.abs() / whole.sqrt();
        let (mut x, mut y) = (0.0, 0.0);
        for _ in 0..MOST_ROOTS {
            let (sinh, cosh) = ((0.5 * q2 * m).sinh(), (0.5 * q2 * m).cosh());
            x = m + c * q1f * q2 * sinh;
            y = self.top - 2.0 * q1f * cosh - m * m / (2.0 * c);
            let slope = -m2 * (q1f * q2 * sinh + m / c) - 2.0 * e2 * x * (1.0 + 0.5 * c * q1f * q2 * q2 * cosh);
            let step = if slope < 0.0 { (m2 * y - e2 * x * x) / slope } else { 0.0 };
            m -= step;
            if step.abs() <= ROOT * m.abs() {
                break;
            }
        }
        // From whichever equation is the better one.
        let kappa = if m2 > e2 { x / along.abs() } else { (y.max(0.0) / across).sqrt() };
        let m = m.copysign(along);
        let growth = c * q1f * q2 * (0.5 * q2 * m).sinh();
        Place { m, kappa, along, across, growth, dissipation: kappa * across + m * along / (2.0 * c) }
    }

    /// Δε̄ of the metal around the voids and the volume strain of an increment \[–\].
    pub(super) fn strains(&self, e: Triple) -> [f64; 2] {
        let place = self.place(e);
        // Normality: ε_kk = λ 3 g with λ = 1/2κ.
        let volume = if place.kappa > 0.0 { 1.5 * place.growth / (self.c * place.kappa) } else { 0.0 };
        [self.share * place.dissipation, volume]
    }
}

impl YieldCondition for GtnCondition {
    fn metric_towards(&self, e: Triple, _: Option<[f64; 2]>) -> Metric {
        let Place { m, kappa, along, across, dissipation: d, .. } = self.place(e);
        if d == 0.0 {
            return self.anisotropy.metric(e);
        }
        let c = self.c;
        let a = self.anisotropy.apply(e);
        let deviation = [a[0] - 0.5 * along, a[1] - 0.5 * along, a[2]]; // A_d Δε
        let s = [kappa * deviation[0] + 0.5 * m, kappa * deviation[1] + 0.5 * m, kappa * deviation[2]];
        // ∂²(½D²)/∂Δε², from the radius of curvature of Φ = 0 in the plane of the two parts.
        let bend = 2.0 * self.q1f * self.q2 * self.q2 * c * c * (0.5 * self.q2 * m).cosh() + 4.0 * c;
        let radius = d * kappa / (2.0 * along * along + bend * across);
        let q = m / (2.0 * c);
        let plain = d * kappa;
        let on_deviation = kappa * kappa - bend * radius;
        let mixed = c * (kappa * q - 2.0 * along * radius);
        let on_sum = c * c * (q * q + 2.0 * across * radius);
        let base = &self.anisotropy;
        let [x, y, z] = deviation;
        let matrix = [
            plain * (base.direct - 0.5 * c) + on_deviation * x * x + 2.0 * mixed * x + on_sum,
            plain * (base.coupled - 0.5 * c) + on_deviation * x * y + mixed * (x + y) + on_sum,
            plain * (base.direct - 0.5 * c) + on_deviation * y * y + 2.0 * mixed * y + on_sum,
            on_deviation * x * z + mixed * z,
            on_deviation * y * z + mixed * z,
            plain * SHEAR + on_deviation * z * z,
        ];
        Metric { gradient: s.map(|s| d * s), matrix, square: d * d }
    }

    fn strain_share(&self) -> f64 {
        self.share
    }
}
