//! Rate dependence: a factor on the yield stress, g(ε̄̇) with σ_y = σ_s(ε̄) g(ε̄̇). One law, one file, as
//! [`law`](crate::material::law) says.

mod cowper_symonds;
mod johnson_cook;
mod power;

use crate::material::law::{Law, family};

/// A factor and its derivative by the rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    /// g \[–\].
    pub value: f64,
    /// dg/dε̄̇ \[s\].
    pub slope: f64,
}

/// Interface of a rate law.
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
    pub enum Rate: RateLaw, named in RateTable as "Rate";
    /// g and dg/dε̄̇ at the equivalent strain rate `rate` > 0 \[1/s\].
    fn at(rate: f64) -> Factor;
    power: PowerRate,
    cowper_symonds: CowperSymonds,
    johnson_cook: JohnsonCook,
}

impl Copy for Rate {}
impl Copy for RateTable {}

impl Rate {
    /// Whether the sheet resists necking by its rate alone: a power of 0.3 or more, as superplastic alloys have.
    pub fn is_superplastic(&self) -> bool {
        self.law().is_superplastic()
    }
}
