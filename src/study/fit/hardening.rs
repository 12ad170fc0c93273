//! Hardening and rate laws that can be fitted: parameters, ranges and starting points.

use crate::material::hardening::{Hardening, HockettSherby, Ludwik, Swift, Voce};
use crate::material::rate::{CowperSymonds, JohnsonCook, PowerRate, Rate};
use std::str::FromStr;

/// A hardening law of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HardeningKind {
    /// k (offset + ε)^n.
    Swift,
    /// saturation − (saturation − initial) exp(−rate ε).
    Voce,
    /// Voce's law with a power of ε.
    HockettSherby,
    /// initial + k ε^n.
    Ludwik,
}

/// Range of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ParameterRange {
    pub key: &'static str,
    /// `MPa`, or none.
    pub unit: &'static str,
    pub low: f64,
    pub high: f64,
}

const STRESS: [f64; 2] = [1.0, 1e5];

impl HardeningKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Swift, Self::Voce, Self::HockettSherby, Self::Ludwik];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Swift => "swift",
            Self::Voce => "voce",
            Self::HockettSherby => "hockett-sherby",
            Self::Ludwik => "ludwik",
        }
    }

    /// Name as people write it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Swift => "Swift",
            Self::Voce => "Voce",
            Self::HockettSherby => "Hockett-Sherby",
            Self::Ludwik => "Ludwik",
        }
    }

    pub(super) fn parameters(self) -> Vec<ParameterRange> {
        let stress = |key| ParameterRange { key, unit: "MPa", low: STRESS[0], high: STRESS[1] };
        let plain = |key, low, high| ParameterRange { key, unit: "", low, high };
        match self {
            Self::Swift => vec![stress("k"), plain("n", 0.0, 1.0), plain("offset", 1e-6, 1.0)],
            Self::Voce => vec![stress("initial"), stress("saturation"), plain("rate", 0.0, 1e3)],
            Self::HockettSherby => {
                vec![stress("initial"), stress("saturation"), plain("rate", 0.0, 1e3), plain("exponent", 0.05, 1.0)]
            }
            Self::Ludwik => vec![stress("initial"), stress("k"), plain("n", 0.01, 1.0)],
        }
    }

    /// The solver's law of some parameters; `None` where they make none.
    pub fn law(self, p: &[f64]) -> Option<Hardening> {
        match self {
            Self::Swift => Swift::new(p[0], p[1], p[2]).ok().map(Hardening::Swift),
            Self::Voce => Voce::new(p[0], p[1], p[2], 1.0).ok().map(Hardening::Voce),
            Self::HockettSherby => HockettSherby::new(p[0], p[1], p[2], p[3]).ok().map(Hardening::HockettSherby),
            Self::Ludwik => Ludwik::new(p[0], p[1], p[2]).ok().map(Hardening::Ludwik),
        }
    }

    /// Starting points: linear parameters by regression, for several values of the others.
    pub(super) fn starts(self, points: &[(f64, f64)]) -> Vec<Vec<f64>> {
        let line = |x: &dyn Fn(f64) -> f64, y: &dyn Fn(f64) -> f64| {
            let n = points.len() as f64;
            let (sx, sy) = points.iter().fold((0.0, 0.0), |s, p| (s.0 + x(p.0) / n, s.1 + y(p.1) / n));
            let (xy, xx) = points.iter().fold((0.0, 0.0), |s, p| {
                let d = x(p.0) - sx;
                (s.0 + d * (y(p.1) - sy), s.1 + d * d)
            });
            let slope = if xx > 0.0 { xy / xx } else { 0.0 };
            (sy - slope * sx, slope)
        };
        let saturating = |rate: f64, exponent: f64| {
            let (end, span) = line(&|e: f64| (-rate * e.max(0.0).powf(exponent)).exp(), &|s| s);
            vec![end + span, end, rate, exponent]
        };
        let rates = [1.0, 3.0, 8.0, 20.0, 60.0];
        match self {
            Self::Swift => [1e-4, 1e-3, 5e-3, 2e-2, 0.1]
                .map(|offset| {
                    let (k, n) = line(&|e: f64| (offset + e.max(0.0)).ln(), &|s: f64| s.max(1.0).ln());
                    vec![k.exp(), n, offset]
                })
                .to_vec(),
            Self::Voce => rates.map(|rate| saturating(rate, 1.0)[..3].to_vec()).to_vec(),
            Self::HockettSherby => {
                rates.iter().flat_map(|rate| [0.5, 0.75, 0.95].map(|exponent| saturating(*rate, exponent))).collect()
            }
            Self::Ludwik => [0.2, 0.4, 0.6, 0.8]
                .map(|n| {
                    let (initial, k) = line(&|e: f64| e.max(0.0).powf(n), &|s| s);
                    vec![initial, k, n]
                })
                .to_vec(),
        }
    }
}

impl FromStr for HardeningKind {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let names = || Self::ALL.map(Self::name).join(", ");
        Self::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| format!("the laws are {}", names()))
    }
}

/// A rate law of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateKind {
    /// (rate/reference)^m.
    Power,
    /// 1 + C ln(rate/reference).
    JohnsonCook,
    /// 1 + (rate/C)^(1/p).
    CowperSymonds,
}

impl RateKind {
    /// Parameters, each with its start.
    pub(super) fn parameters(self) -> Vec<(ParameterRange, f64)> {
        let range = |key, unit, low, high| ParameterRange { key, unit, low, high };
        match self {
            Self::Power => vec![(range("rate.exponent", "", 0.0, 1.0), 0.02)],
            Self::JohnsonCook => vec![(range("rate.coefficient", "", 1e-9, 1.0), 0.02)],
            Self::CowperSymonds => {
                vec![(range("rate.rate", "/s", 1e-6, 1e12), 1e4), (range("rate.exponent", "", 0.5, 50.0), 5.0)]
            }
        }
    }

    /// The law; `reference` is the rate of the slowest test \[1/s\].
    pub(super) fn law(self, p: &[f64], reference: f64) -> Rate {
        match self {
            Self::Power => Rate::PowerRate(PowerRate { exponent: p[0], reference }),
            Self::JohnsonCook => Rate::JohnsonCook(JohnsonCook { coefficient: p[0], reference }),
            Self::CowperSymonds => Rate::CowperSymonds(CowperSymonds { rate: p[0], exponent: p[1] }),
        }
    }
}

impl FromStr for RateKind {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "power" => Ok(Self::Power),
            "johnson-cook" => Ok(Self::JohnsonCook),
            "cowper-symonds" => Ok(Self::CowperSymonds),
            _ => Err("the laws are power, johnson-cook and cowper-symonds".to_owned()),
        }
    }
}
