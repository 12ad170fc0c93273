//! Laws that can be fitted: parameters, ranges and starting points of hardening and rate laws.

use super::flow_curve::straight_line;
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

/// Name, unit (`MPa`, `/s` or none), least and largest value.
pub(super) type ParameterRange = (&'static str, &'static str, f64, f64);

const fn stress(key: &'static str) -> ParameterRange {
    (key, "MPa", 1.0, 1e5)
}

impl HardeningKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Swift, Self::Voce, Self::HockettSherby, Self::Ludwik];

    /// Name on the command line.
    pub fn name(self) -> String {
        self.label().to_lowercase()
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

    pub(super) fn parameters(self) -> &'static [ParameterRange] {
        const RATE: ParameterRange = ("rate", "", 0.0, 1e3);
        match self {
            Self::Swift => &const { [stress("k"), ("n", "", 0.0, 1.0), ("offset", "", 1e-6, 1.0)] },
            Self::Voce => &const { [stress("initial"), stress("saturation"), RATE] },
            Self::HockettSherby => {
                &const { [stress("initial"), stress("saturation"), RATE, ("exponent", "", 0.05, 1.0)] }
            }
            Self::Ludwik => &const { [stress("initial"), stress("k"), ("n", "", 0.01, 1.0)] },
        }
    }

    /// The solver's law of some parameters; `None` if they make none.
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
        let line = |x: &dyn Fn(f64) -> f64| {
            let [intercept, slope, _] = straight_line(points.iter().map(|p| (x(p.0.max(0.0)), p.1)).collect());
            (intercept, slope)
        };
        let swift = |offset: f64| {
            let logarithms = points.iter().map(|p| ((offset + p.0.max(0.0)).ln(), p.1.max(1.0).ln()));
            let [k, n, _] = straight_line(logarithms.collect());
            vec![k.exp(), n, offset]
        };
        let saturating = |rate: f64, exponent: f64| {
            let (end, span) = line(&|e| (-rate * e.powf(exponent)).exp());
            vec![end + span, end, rate, exponent]
        };
        let ludwik = |n: f64| {
            let (initial, k) = line(&|e| e.powf(n));
            vec![initial, k, n]
        };
        let rates = [1.0, 3.0, 8.0, 20.0, 60.0];
        match self {
            Self::Swift => [1e-4, 1e-3, 5e-3, 2e-2, 0.1].map(swift).to_vec(),
            Self::Voce => rates.map(|rate| saturating(rate, 1.0)[..3].to_vec()).to_vec(),
            Self::HockettSherby => rates.map(|rate| [0.5, 0.75, 0.95].map(|n| saturating(rate, n))).concat(),
            Self::Ludwik => [0.2, 0.4, 0.6, 0.8].map(ludwik).to_vec(),
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
    pub(super) fn parameters(self) -> &'static [(ParameterRange, f64)] {
        match self {
            Self::Power => &[(("rate.exponent", "", 0.0, 1.0), 0.02)],
            Self::JohnsonCook => &[(("rate.coefficient", "", 1e-9, 1.0), 0.02)],
            Self::CowperSymonds => &[(("rate.rate", "/s", 1e-6, 1e12), 1e4), (("rate.exponent", "", 0.5, 50.0), 5.0)],
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
