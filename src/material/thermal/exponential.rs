//! A share of the strength lost per kelvin.

use super::{TemperatureLaw, celsius};
use crate::material::law::prelude::*;

/// exp(−coefficient (T − reference)).
///
/// Valid in the range of temperatures that the coefficient was fitted to: 0.001 to 0.005 /K in warm forming.
/// Source: in common use for warm forming.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exponential {
    /// Share of the strength lost per kelvin \[1/K\].
    #[serde(with = "As::<Positive<PerKelvin>>")]
    #[schemars(example = "0.003 /K")]
    pub coefficient: f64,
    /// Temperature at which the hardening law was measured \[K\].
    #[serde(with = "As::<Positive<Temperature>>")]
    #[schemars(example = "20 °C")]
    pub reference: f64,
}

impl Law for Exponential {
    fn examples() -> Vec<Self> {
        vec![Self { coefficient: 0.003, reference: 293.15 }]
    }

    fn formula(&self) -> String {
        format!("exp(−{} /K (T − {} °C))", self.coefficient, celsius(self.reference))
    }
}

impl TemperatureLaw for Exponential {
    #[inline]
    fn at(&self, temperature: f64) -> f64 {
        (-self.coefficient * (temperature - self.reference)).exp()
    }
}
