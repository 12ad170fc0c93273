//! Hardening laws that can be fitted: parameters, ranges and starting points.

use crate::material::hardening::{Hardening, HockettSherby, Ludwik, Swift, Voce};
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

/// Name, unit (`MPa` or none), least and largest value.
pub(super) type ParameterRange = (&'static str, &'static str, f64, f64);

impl HardeningKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Swift, Self::Voce, Self::HockettSherby, Self::Ludwik];

    /// Name on the command line.
    pub fn name(self) -> String {
        self.label().to_lowercase()
    }

    /// Name as people write it.
    pub fn label(self) -> &'static str {
        ["Swift", "Voce", "Hockett-Sherby", "Ludwik"][self as usize]
    }

    pub(super) fn parameters(self) -> Vec<ParameterRange> {
        let (stress, rate) = (|key| (key, "MPa", 1.0, 1e5), ("rate", "", 0.0, 1e3));
        match self {
            Self::Swift => vec![stress("k"), ("n", "", 0.0, 1.0), ("offset", "", 1e-6, 1.0)],
            Self::Voce => vec![stress("initial"), stress("saturation"), rate],
            Self::HockettSherby => vec![stress("initial"), stress("saturation"), rate, ("exponent", "", 0.05, 1.0)],
            Self::Ludwik => vec![stress("initial"), stress("k"), ("n", "", 0.01, 1.0)],
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
        let line = |x: &dyn Fn(f64) -> f64, y: fn(f64) -> f64| {
            straight_line(points.iter().map(|p| (x(p.0.max(0.0)), y(p.1))).collect())
        };
        let swift = |offset: f64| {
            let [k, n, _] = line(&|e| (offset + e).ln(), |stress| stress.max(1.0).ln());
            vec![k.exp(), n, offset]
        };
        let saturating = |rate: f64, exponent: f64| {
            let [end, span, _] = line(&|e| (-rate * e.powf(exponent)).exp(), |stress| stress);
            vec![end + span, end, rate, exponent]
        };
        let ludwik = |n: f64| {
            let [initial, k, _] = line(&|e| e.powf(n), |stress| stress);
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

/// Intercept, slope and standard error of the slope of the regression through points.
pub(super) fn straight_line(points: Vec<(f64, f64)>) -> [f64; 3] {
    let n = points.len() as f64;
    let [x, y] = [points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n];
    let xx: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let xy: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    let rest: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
    [y - slope * x, slope, (rest / (n - 2.0).max(1.0) / xx).sqrt()]
}
