//! Dependence on the temperature: a factor on the yield stress, h(T) with σ_y = σ_s(ε̄) g(ε̄̇) h(T). One law, one file, as
//! [`law`](crate::law) says.

mod arrhenius;
mod exponential;
mod johnson_cook;

use crate::law::{Law, family};
use crate::units::{ZERO_CELSIUS, rounded};

/// What a law of the temperature says beside its parameters.
trait TemperatureLaw: Law {
    /// h at a temperature \[K\].
    fn at(&self, temperature: f64) -> f64;
}

family! {
    /// A factor on the hardening law: exactly one. A table of curves by temperature is `[material.hardening.isotherms]`.
    pub enum ThermalLaw: TemperatureLaw;
    /// h at a temperature \[K\].
    fn at(temperature: f64) -> f64;
    johnson_cook: Melting,
    exponential: Exponential,
    arrhenius: Arrhenius,
}

impl Copy for ThermalLaw {}

/// A temperature \[K\] in °C, for captions.
fn celsius(kelvin: f64) -> f64 {
    rounded(kelvin - ZERO_CELSIUS)
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
