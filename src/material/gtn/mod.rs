//! Voids in the sheet: the model of Gurson, Tvergaard and Needleman.
//!
//! ```text
//! ḟ = (1 − f) ε̇_kk + A ε̄̇,   A = f_N/(s_N √(2π)) exp(−½ ((ε̄ − ε_N)/s_N)²)          growth and nucleation
//! f* = f up to f_c, then f_c + (f_U − f_c)/(f_F − f_c) (f − f_c),  f_U = (q₁ + √(q₁² − q₃))/q₃    coalescence
//! ```
//!
//! The volume grows by ε_kk alone: a nucleated void takes the place of a particle.
//!
//! # References
//! As in [`condition`], and C. C. Chu, A. Needleman, J. Eng. Mater. Technol. 102 (1980) 249–256, for nucleation.

pub mod condition;

pub use condition::GtnCondition;

use super::Hill48;
use super::flow::Triple;
use std::f64::consts::TAU;
use std::fmt;

/// Strain increment that one stage of the integration of f takes \[–\]: fourth order, so its error is near 1e-10.
const STRAIN_STEP: f64 = 0.005;
/// Share of the porosity of fracture up to which stress is reckoned: there the metal is as good as gone \[–\].
const LARGEST: f64 = 0.99;

/// Voids that open where particles break: strain-controlled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nucleation {
    /// f_N: porosity that all particles make \[–\].
    pub fraction: f64,
    /// ε_N: mean strain at which they break \[–\].
    pub strain: f64,
    /// s_N: its standard deviation \[–\].
    pub deviation: f64,
}

/// Voids that grow together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coalescence {
    /// f_c: porosity from which on \[–\].
    pub critical: f64,
    /// f_F: porosity at which the metal bears nothing any more \[–\].
    pub fracture: f64,
}

/// The model's parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gtn {
    /// Tvergaard's factors \[–\].
    pub q1: f64,
    pub q2: f64,
    pub q3: f64,
    /// f₀ \[–\].
    pub initial: f64,
    pub nucleation: Option<Nucleation>,
    pub coalescence: Option<Coalescence>,
}

/// Porosity, strain of the metal and the strain of the volume since the start of a step \[–\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evolution {
    pub porosity: f64,
    pub strain: f64,
    pub volume: f64,
}

impl Gtn {
    /// Gurson's own model: no interaction of voids, none that open, none that join.
    pub fn gurson(initial: f64) -> Self {
        Self { q1: 1.0, q2: 1.0, q3: 1.0, initial, nucleation: None, coalescence: None }
    }

    /// Growth, nucleation and coalescence with numbers in common use: for tests.
    pub fn example() -> Self {
        Self {
            q1: 1.5,
            q2: 1.0,
            q3: 2.25,
            initial: 0.01,
            nucleation: Some(Nucleation { fraction: 0.04, strain: 0.3, deviation: 0.1 }),
            coalescence: Some(Coalescence { critical: 0.15, fracture: 0.25 }),
        }
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
            Some(c) if f > c.critical => {
                c.critical + (ultimate - c.critical) / (c.fracture - c.critical) * (f - c.critical)
            }
            _ => f,
        };
        effective.min(LARGEST * ultimate)
    }

    /// Porosity a step reckons with, foreseen from the rate of the last step: kept where the model holds \[–\].
    pub fn foreseen(&self, f: f64) -> f64 {
        f.clamp(0.0, LARGEST * self.fracture())
    }

    /// A of the nucleation \[–\].
    fn nucleating(&self, strain: f64) -> f64 {
        self.nucleation.map_or(0.0, |n| {
            let x = (strain - n.strain) / n.deviation;
            n.fraction / (n.deviation * TAU.sqrt()) * (-0.5 * x * x).exp()
        })
    }

    /// Porosity and strains after the increment `e` on a straight path, by Runge and Kutta's fourth-order rule.
    pub fn evolve(&self, anisotropy: Hill48, porosity: f64, strain: f64, e: Triple) -> Evolution {
        let rate = |f: f64, strain: f64| {
            let f = self.foreseen(f);
            let [metal, volume] = GtnCondition::new(self, anisotropy, f).strains(e);
            [(1.0 - f) * volume + self.nucleating(strain) * metal, metal, volume]
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
            for i in 0..3 {
                y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
        Evolution { porosity: y[0].max(0.0), strain: y[1], volume: y[2] }
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

#[cfg(test)]
mod tests;
