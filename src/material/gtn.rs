//! Voids in the sheet: the model of Gurson, Tvergaard and Needleman.
//!
//! ```text
//! ḟ = (1 − f) ε̇_kk + A ε̄̇,   A = f_N/(s_N √(2π)) exp(−½ ((ε̄ − ε_N)/s_N)²)          growth and nucleation
//! f* = f up to f_c, then f_c + (f_U − f_c)/(f_F − f_c) (f − f_c),  f_U = (q₁ + √(q₁² − q₃))/q₃    coalescence
//! ```
//!
//! The volume grows by ε_kk alone: a nucleated void takes the place of a particle.
//!
//! The yield condition in plane stress and what goes with it, in viscous form:
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
//! so that m is the root of M² Y − E² (m + c g)², concave and falling: Newton descends from the root without voids.
//!
//! # References
//! A. L. Gurson, J. Eng. Mater. Technol. 99 (1977) 2–15; V. Tvergaard, Int. J. Fract. 17 (1981) 389–407; V. Tvergaard,
//! A. Needleman, Acta Metall. 32 (1984) 157–169; for the flow approach E. Oñate, C. Agelet de Saracibar, in: Modelling of
//! Metal Forming Processes, Kluwer (1988). None of them could be read; the condition is in common use.
//! C. C. Chu, A. Needleman, J. Eng. Mater. Technol. 102 (1980) 249–256, for nucleation.

use super::hill48::{Hill48, SHEAR};
use super::yield_condition::{Metric, Triple, YieldCondition, dot};
use crate::material::law::prelude::*;
use std::{f64::consts::TAU, fmt};

/// Largest strain step of the integration of f \[–\]: its fourth-order error is near 1e-10.
const STRAIN_STEP: f64 = 0.005;
/// Largest initial porosity \[–\].
const POROUS: f64 = 0.3;
/// Share of the porosity of fracture up to which stress is computed \[–\].
const LARGEST: f64 = 0.99;
/// Newton's method stops when m moves by less than this \[–\].
const ROOT: f64 = 1e-14;
const MOST_ROOTS: usize = 60;

/// σ̄²/σ_y² + 2 q1 f* cosh(3 q2 p/2σ_y) = 1 + q3 f*² with the mean stress p: Gurson's yield condition.
///
/// Valid for small, spread-out voids under tension; without shear it says little about compression.
/// Source: in common use; A. L. Gurson (1977), V. Tvergaard, A. Needleman (1984), C. C. Chu (1980) (not read).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gtn {
    /// Initial porosity f₀, below 0.3.
    #[serde(with = "As::<Fraction>")]
    pub initial: f64,
    /// 1.5 when not given (Tvergaard).
    #[serde(default = "tvergaard", with = "As::<Positive<Number>>")]
    pub q1: f64,
    /// 1 when not given.
    #[serde(default = "one", with = "As::<Positive<Number>>")]
    pub q2: f64,
    /// q1² when not given, which 0 stands for until [`Gtn::prepare`].
    #[serde(default, with = "As::<Positive<Number>>")]
    #[schemars(!default, with = "Option<Positive<Number>>")]
    pub q3: f64,
    /// Voids that open at particles as the sheet strains; none when not given.
    pub nucleation: Option<Nucleation>,
    /// Voids that join; they keep apart when not given.
    pub coalescence: Option<Coalescence>,
}

parameters! {
    /// Strain-controlled nucleation, spread normally.
    pub struct Nucleation {
        /// Porosity f_N that all particles make.
        pub fraction: "As::<Fraction>" = 0.04,
        /// Mean strain ε_N.
        pub strain: "As::<Positive<Number>>" = 0.3,
        /// Standard deviation s_N.
        pub deviation: "As::<Positive<Number>>" = 0.1,
    }
}

parameters! {
    /// Faster loss of strength from a critical porosity on.
    pub struct Coalescence {
        /// f_c.
        pub critical: "As::<Fraction>" = 0.15,
        /// f_F, at which the sheet bears nothing any more: the run ends there.
        pub fracture: "As::<Fraction>" = 0.25,
    }
}

fn tvergaard() -> f64 {
    1.5
}

/// Voids and strains after an increment \[–\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evolution {
    /// f.
    pub porosity: f64,
    /// ε̄ of the metal.
    pub strain: f64,
    /// ε_kk of the volume since the start of the step.
    pub volume: f64,
}

impl Gtn {
    /// Growth, nucleation and coalescence with numbers in common use: for tests.
    pub fn example() -> Self {
        let (nucleation, coalescence) = (Some(Nucleation::example()), Some(Coalescence::example()));
        Self { q1: 1.5, q2: 1.0, q3: 2.25, initial: 0.01, nucleation, coalescence }
    }

    /// Checks the parameters against each other; q₃ that was not given becomes q₁². Fails when they do not go together.
    pub fn prepare(&mut self) -> Result<(), LawError> {
        let square = self.q1 * self.q1;
        if self.q3 == 0.0 {
            self.q3 = square;
        }
        let Self { initial, q1, q2, q3, .. } = *self;
        for (key, value, least, most) in [("q1", q1, 0.5, 5.0), ("q2", q2, 0.1, 5.0), ("q3", q3, 0.1, 25.0)] {
            require_range([key; 2], value, [least, most], "1.5, 1 and 2.25 are usual")?;
        }
        require_or("q3", q3 <= square * (1.0 + 1e-9), "leave it out: it is q1² then", || {
            format!("`q3` must not exceed q1² = {square}, found {q3}")
        })?;
        if let Some(Coalescence { critical, fracture }) = self.coalescence {
            let key = "coalescence.fracture";
            require_or(key, critical < fracture, "fracture must lie above critical: 0.15 and 0.25 are usual", || {
                format!("voids join from {critical} on and the sheet is gone at {fracture}")
            })?;
            require_or(key, fracture <= 1.0 / q1, "there the sheet bears nothing without coalescence either", || {
                format!("`fracture` must not exceed 1/q1 = {:.3}, found {fracture}", 1.0 / q1)
            })?;
        }
        let most = self.coalescence.map_or(POROUS, |c| c.critical.min(POROUS));
        require_or("initial", initial <= most, "sheet metal has 0 to 0.02", || {
            format!("an initial porosity of {initial} is more than {most}")
        })?;
        let Some(Nucleation { strain, deviation, .. }) = self.nucleation else { return Ok(()) };
        require_or("nucleation.deviation", deviation <= strain, "strain = 0.3 and deviation = 0.1 are usual", || {
            format!("a deviation of {deviation} is wider than the mean strain of {strain}")
        })
    }

    /// f_U, the effective porosity at which the metal bears nothing \[–\].
    fn ultimate(&self) -> f64 {
        (self.q1 + (self.q1 * self.q1 - self.q3).max(0.0).sqrt()) / self.q3
    }

    /// Porosity at which the metal bears nothing \[–\].
    pub fn fracture(&self) -> f64 {
        self.coalescence.map_or(self.ultimate(), |c| c.fracture).min(1.0)
    }

    /// f* \[–\], at most short of fracture.
    pub fn effective(&self, f: f64) -> f64 {
        let ultimate = self.ultimate();
        let effective = match self.coalescence {
            Some(Coalescence { critical, fracture }) if f > critical => {
                critical + (ultimate - critical) / (fracture - critical) * (f - critical)
            }
            _ => f,
        };
        effective.min(LARGEST * ultimate)
    }

    /// The yield condition at the porosity `f` \[–\].
    pub fn condition(&self, anisotropy: Hill48, f: f64) -> GtnCondition {
        let effective = self.effective(f);
        let (q1f, top) = (self.q1 * effective, 1.0 + self.q3 * effective * effective);
        let (share, c) = (1.0 / (1.0 - f), anisotropy.direct + anisotropy.coupled);
        GtnCondition { anisotropy, q2: self.q2, q1f, top, share, c }
    }

    /// Porosity of a step, extrapolated from the last one and kept where the model holds \[–\].
    pub fn foreseen(&self, f: f64) -> f64 {
        f.clamp(0.0, LARGEST * self.fracture())
    }

    /// Porosity and strains after the increment `e` on a straight path, by Runge and Kutta's fourth-order rule.
    pub fn evolve(&self, anisotropy: Hill48, porosity: f64, strain: f64, e: Triple) -> Evolution {
        let nucleation = |strain: f64| {
            self.nucleation.map_or(0.0, |n| {
                let x = (strain - n.strain) / n.deviation;
                n.fraction / (n.deviation * TAU.sqrt()) * (-0.5 * x * x).exp()
            })
        };
        let rate = |f: f64, strain: f64| {
            let f = self.foreseen(f);
            let [metal, volume] = self.condition(anisotropy, f).strains(e);
            [(1.0 - f) * volume + nucleation(strain) * metal, metal, volume]
        };
        let steps = (anisotropy.equivalent_increment(e) / STRAIN_STEP).ceil().max(1.0);
        let h = 1.0 / steps;
        let mut y = [porosity, strain, 0.0];
        for _ in 0..steps as usize {
            let at = |k: [f64; 3], h: f64| rate(y[0] + h * k[0], y[1] + h * k[1]);
            let k1 = at([0.0; 3], 0.0);
            let k2 = at(k1, 0.5 * h);
            let k3 = at(k2, 0.5 * h);
            let k4 = at(k3, h);
            y = [0, 1, 2].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        }
        Evolution { porosity: y[0].max(0.0), strain: y[1], volume: y[2] }
    }
}

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
    fn strains(&self, e: Triple) -> [f64; 2] {
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

impl fmt::Display for Gtn {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { q1, q2, q3, initial, nucleation, coalescence } = self;
        write!(f, "voids by Gurson, q = {q1}, {q2}, {q3}, f0 = {initial}")?;
        if let Some(Nucleation { fraction, strain, deviation }) = nucleation {
            write!(f, ", nucleation f_N = {fraction} at strains of {strain} ± {deviation}")?;
        }
        if let Some(Coalescence { critical, fracture }) = coalescence {
            write!(f, ", coalescence from f = {critical}, fracture at {fracture}")?;
        }
        Ok(())
    }
}
