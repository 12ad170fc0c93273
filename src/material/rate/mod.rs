//! Rate dependence: a factor g(ε̄̇) with σ_y = σ_s(ε̄) g(ε̄̇). One law, one file: [`law`](crate::material::law).

mod cowper_symonds;
mod johnson_cook;
mod power;

use crate::material::law::prelude::*;

family! {
    /// A factor on the hardening law: exactly one.
    #[derive(Copy)]
    pub enum Rate: RateLaw, named in RateTable as "Rate";
    /// g \[–\] and dg/dε̄̇ \[s\] at the equivalent strain rate `rate` > 0 \[1/s\].
    fn at(rate: f64) -> ValueAndSlope;
    power: PowerRate,
    cowper_symonds: CowperSymonds,
    johnson_cook: JohnsonCook,
}

impl Rate {
    /// Whether the sheet resists necking by its rate alone: a power of 0.3 or more, as superplastic alloys have.
    pub fn is_superplastic(&self) -> bool {
        matches!(self, Self::PowerRate(law) if law.exponent >= 0.3)
    }
}
