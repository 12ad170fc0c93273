//! The logarithm of the rate: the rate term of Johnson and Cook.
//!
//! g = 1 + C ln(ε̄̇/ε̇₀) above the reference rate; below it, where the logarithm would fall without bound, g comes smoothly
//! down to 1: g = 1 + ½ C ln(1 + (ε̄̇/ε̇₀)²).

use super::{Factor, RateLaw};
use crate::material::law::prelude::*;

/// 1 + C ln(rate/reference) above the reference rate, smoothly 1 below it.
///
/// Valid above the reference rate, for a weak dependence.
/// Source: in common use; G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics, The Hague (1983) 541–547 (not
/// read).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JohnsonCook {
    /// C.
    #[serde(with = "As::<Positive<Number>>")]
    #[schemars(example = 0.015)]
    pub coefficient: f64,
    /// ε̇₀ \[1/s\].
    #[serde(with = "As::<Positive<StrainRate>>")]
    #[schemars(example = "0.001 /s")]
    pub reference: f64,
}

impl Law for JohnsonCook {
    fn examples() -> Vec<Self> {
        vec![Self { coefficient: 0.015, reference: 1e-3 }]
    }

    fn formula(&self) -> String {
        format!("[1 + {} ln(ε̄̇/{} 1/s)]", self.coefficient, self.reference)
    }
}

impl RateLaw for JohnsonCook {
    #[inline]
    fn at(&self, rate: f64) -> Factor {
        let x = rate / self.reference;
        let square = x * x;
        Factor {
            value: 1.0 + 0.5 * self.coefficient * square.ln_1p(),
            slope: self.coefficient * x / ((1.0 + square) * self.reference),
        }
    }
}
