//! Rate dependence: a factor on the yield stress, g(ε̄̇) with σ_y = σ_s(ε̄) g(ε̄̇). One law, one file.

mod cowper_symonds;
mod johnson_cook;
mod power;

pub use cowper_symonds::CowperSymonds;
pub use johnson_cook::JohnsonCook;
pub use power::PowerRate;

use std::fmt;

/// The factor g \[–\] and its derivative by the rate \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    pub value: f64,
    pub slope: f64,
}

/// A rate law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rate {
    Power(PowerRate),
    CowperSymonds(CowperSymonds),
    JohnsonCook(JohnsonCook),
}

impl Rate {
    /// g and dg/dε̄̇ at the equivalent strain rate `rate` > 0 \[1/s\].
    #[inline]
    pub fn at(&self, rate: f64) -> Factor {
        match self {
            Self::Power(law) => law.at(rate),
            Self::CowperSymonds(law) => law.at(rate),
            Self::JohnsonCook(law) => law.at(rate),
        }
    }

    /// Whether the sheet resists necking by its rate alone: a power of 0.3 or more, as superplastic alloys have.
    pub fn is_superplastic(&self) -> bool {
        matches!(self, Self::Power(law) if law.exponent >= 0.3)
    }

    /// One example of every law, named: for tests and lists.
    pub fn examples() -> Vec<(&'static str, Self)> {
        vec![
            ("power", Self::Power(PowerRate { exponent: 0.02, reference: 1e-3 })),
            ("power, superplastic", Self::Power(PowerRate { exponent: 0.5, reference: 1.0 })),
            ("cowper_symonds", Self::CowperSymonds(CowperSymonds { rate: 40.0, exponent: 5.0 })),
            ("johnson_cook", Self::JohnsonCook(JohnsonCook { coefficient: 0.015, reference: 1e-3 })),
        ]
    }
}

impl fmt::Display for Rate {
    /// The factor as a formula with numbers and units.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Power(l) => write!(f, "(ε̄̇/{} 1/s)^{}", l.reference, l.exponent),
            Self::CowperSymonds(l) => write!(f, "[1 + (ε̄̇/{} 1/s)^(1/{})]", l.rate, l.exponent),
            Self::JohnsonCook(l) => write!(f, "[1 + {} ln(ε̄̇/{} 1/s)]", l.coefficient, l.reference),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: central differences over ten decades of rate, h = 1e-5 of the rate: truncation near 1e-10.
    #[test]
    fn slopes_are_the_derivatives_of_the_factors() {
        for (name, law) in Rate::examples() {
            for decade in -8..=2 {
                let rate = 3.0 * 10f64.powi(decade);
                let h = 1e-5 * rate;
                let difference = (law.at(rate + h).value - law.at(rate - h).value) / (2.0 * h);
                let factor = law.at(rate);
                assert!((difference - factor.slope).abs() < 1e-6 * factor.value / rate, "{name} at {rate}");
                assert!(factor.value >= 0.0 && factor.slope >= 0.0, "{name} at {rate}");
            }
        }
    }

    /// Trust: the published forms by hand.
    #[test]
    fn factors_are_the_published_ones() {
        let laws: Vec<Rate> = Rate::examples().into_iter().map(|(_, law)| law).collect();
        assert_relative_eq!(laws[0].at(1.0).value, 1000f64.powf(0.02), max_relative = 1e-12);
        assert_relative_eq!(laws[2].at(40.0).value, 2.0, max_relative = 1e-12);
        // Its smooth foot is felt by (ε̇₀/ε̄̇)²/2 of a logarithm's unit.
        assert_relative_eq!(laws[3].at(1.0).value, 1.0 + 0.015 * 1000f64.ln(), max_relative = 1e-7);
    }
}
