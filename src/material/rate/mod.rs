//! Rate dependence: a factor on the yield stress, g(ε̄̇) with σ_y = σ_s(ε̄) g(ε̄̇). One law, one file, as
//! [`law`](crate::law) says.

mod cowper_symonds;
mod johnson_cook;
mod power;

use crate::law::{Law, family};

/// A factor and its derivative by the rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    /// g \[–\].
    pub value: f64,
    /// dg/dε̄̇ \[s\].
    pub slope: f64,
}

/// What a rate law says beside its parameters.
trait RateLaw: Law {
    /// g and dg/dε̄̇ at the equivalent strain rate `rate` > 0 \[1/s\].
    fn at(&self, rate: f64) -> Factor;

    /// Whether the sheet resists necking by its rate alone.
    fn is_superplastic(&self) -> bool {
        false
    }
}

family! {
    /// A factor on the hardening law: exactly one.
    pub enum Rate: RateLaw;
    /// g and dg/dε̄̇ at the equivalent strain rate `rate` > 0 \[1/s\].
    fn at(rate: f64) -> Factor;
    power: PowerRate,
    cowper_symonds: CowperSymonds,
    johnson_cook: JohnsonCook,
}

impl Copy for Rate {}

impl Rate {
    /// Whether the sheet resists necking by its rate alone: a power of 0.3 or more, as superplastic alloys have.
    pub fn is_superplastic(&self) -> bool {
        self.law().is_superplastic()
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
