//! Thermal softening: a factor on the yield stress, h(T) with σ_y = σ_s(ε̄) g(ε̄̇) h(T). One law, one file.

mod arrhenius;
mod exponential;
mod johnson_cook;

pub use arrhenius::Arrhenius;
pub use exponential::Exponential;
pub use johnson_cook::Melting;

use crate::units::{ZERO_CELSIUS, rounded};
use std::fmt;

/// A softening law; temperatures in K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ThermalLaw {
    JohnsonCook(Melting),
    Exponential(Exponential),
    Arrhenius(Arrhenius),
}

impl ThermalLaw {
    /// h at a temperature \[K\].
    #[inline]
    pub fn at(&self, temperature: f64) -> f64 {
        match self {
            Self::JohnsonCook(law) => law.at(temperature),
            Self::Exponential(law) => law.at(temperature),
            Self::Arrhenius(law) => law.at(temperature),
        }
    }

    /// One example of every law, named: for tests and lists.
    pub fn examples() -> Vec<(&'static str, Self)> {
        vec![
            ("johnson_cook", Self::JohnsonCook(Melting { reference: 293.15, melting: 893.15, exponent: 1.03 })),
            ("exponential", Self::Exponential(Exponential { coefficient: 0.003, reference: 293.15 })),
            ("arrhenius", Self::Arrhenius(Arrhenius { over_gas_constant: 18_000.0, exponent: 0.1, reference: 693.15 })),
        ]
    }
}

impl fmt::Display for ThermalLaw {
    /// The factor as a formula with numbers, in °C.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let celsius = |kelvin: f64| rounded(kelvin - ZERO_CELSIUS);
        match self {
            Self::JohnsonCook(l) => {
                let (from, span) = (celsius(l.reference), rounded(l.melting - l.reference));
                write!(f, "[1 − ((T − {from} °C)/{span} K)^{}]", l.exponent)
            }
            Self::Exponential(l) => write!(f, "exp(−{} /K (T − {} °C))", l.coefficient, celsius(l.reference)),
            Self::Arrhenius(l) => {
                write!(f, "exp({} × {:.0} K (1/T − 1/{} K))", l.exponent, l.over_gas_constant, l.reference)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: the published forms by hand.
    #[test]
    fn factors_are_one_at_the_reference_and_the_published_ones_elsewhere() {
        let laws: Vec<ThermalLaw> = ThermalLaw::examples().into_iter().map(|(_, law)| law).collect();
        for (law, reference) in laws.iter().zip([293.15, 293.15, 693.15]) {
            assert_relative_eq!(law.at(reference), 1.0, max_relative = 1e-15);
        }
        assert_relative_eq!(laws[0].at(593.15), 1.0 - 0.5f64.powf(1.03), max_relative = 1e-12);
        assert_relative_eq!(laws[1].at(493.15), (-0.6f64).exp(), max_relative = 1e-12);
        let hotter = (0.1 * 18_000.0 * (1.0 / 793.15 - 1.0 / 693.15_f64)).exp();
        assert_relative_eq!(laws[2].at(793.15), hotter, max_relative = 1e-12);
    }

    /// Hotter is never stronger, and the stress stays positive up to melting and beyond.
    #[test]
    fn every_law_softens() {
        for (name, law) in ThermalLaw::examples() {
            let factors: Vec<f64> = (250..1200).map(|t| law.at(f64::from(t))).collect();
            assert!(factors.windows(2).all(|w| w[1] <= w[0] && w[1] > 0.0), "{name}");
        }
    }
}
