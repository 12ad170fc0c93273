//! Ludwik's law.

use super::flow_stress::{FlowStress, HardeningLaw, power};
use crate::material::law::prelude::*;

/// σ = initial + k ε^n.
///
/// Valid for metals with a marked yield stress; just beyond yield its slope is infinite, a chord over 1e-6 takes its place.
/// Source: P. Ludwik, Elemente der technologischen Mechanik, Springer, Berlin (1909).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ludwik {
    /// Yield stress σ₀ \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(example = "150 MPa")]
    initial: f64,
    /// K, the hardening at a strain of 1 \[MPa\].
    #[serde(with = "As::<NonNegative<Stress>>")]
    #[schemars(example = "400 MPa")]
    k: f64,
    /// Hardening exponent, above 0 and up to 1.
    #[serde(with = "As::<Fraction>")]
    #[schemars(example = 0.5)]
    n: f64,
}

constructor!(Ludwik { initial, k, n });

impl Law for Ludwik {
    fn examples() -> Vec<Self> {
        vec![Self { initial: 150.0, k: 400.0, n: 0.5 }]
    }

    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        let Self { initial, k, n } = *self;
        require("initial", initial > 0.0 && initial.is_finite(), || {
            format!("the initial yield stress must be positive, found {initial} MPa")
        })?;
        require("k", k >= 0.0 && k.is_finite(), || format!("k must not be negative, found {k} MPa"))?;
        require("n", n > 0.0 && n <= 1.0, || format!("n must lie above 0 and up to 1, found {n}"))
    }

    fn formula(&self) -> String {
        format!("Ludwik, σ = {} + {} ε^{} MPa", rounded(self.initial), rounded(self.k), rounded(self.n))
    }
}

impl HardeningLaw for Ludwik {
    #[inline]
    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let (value, slope) = power(strain, self.n);
        FlowStress { stress: self.initial + self.k * value, slope: self.k * slope }
    }
}
