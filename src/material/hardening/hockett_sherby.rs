//! The saturating law of Hockett and Sherby.
//!
//! With p < 1 the slope at ε̄ = 0 is infinite, which no iteration matrix can carry: the chord over the first 1e-6 of strain
//! takes the place of ε̄^p there, and changes nothing beyond. With p = 1 the law is Voce's.

use super::flow_stress::{FlowStress, HardeningLaw, power, saturating};
use crate::material::law::prelude::*;

/// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
///
/// Valid for metals whose hardening comes to an end at large strains, such as aluminium and deep-drawing steel; just beyond
/// yield its slope is infinite for an exponent below 1, a chord over 1e-6 takes its place.
/// Source: J. E. Hockett, O. D. Sherby, J. Mech. Phys. Solids 23 (1975) 87–98 (not read; the form is in common use).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HockettSherby {
    /// σ₀ at the start of yield \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(example = "130 MPa")]
    initial: f64,
    /// σ_s at large strains \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(example = "390 MPa")]
    saturation: f64,
    /// N.
    #[serde(with = "As::<NonNegative<Number>>")]
    #[schemars(example = 5.0)]
    rate: f64,
    /// p, above 0 and up to 1.
    #[serde(with = "As::<Fraction>")]
    #[schemars(example = 0.75)]
    exponent: f64,
}

constructor!(HockettSherby { initial, saturation, rate, exponent });

impl Law for HockettSherby {
    fn examples() -> Vec<Self> {
        vec![Self { initial: 130.0, saturation: 390.0, rate: 5.0, exponent: 0.75 }]
    }

    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        saturating([self.initial, self.saturation, self.rate, self.exponent])
    }

    fn formula(&self) -> String {
        let [saturation, span, rate] = [self.saturation, self.saturation - self.initial, self.rate].map(rounded);
        format!("Hockett-Sherby, σ = {saturation} − {span} exp(−{rate} ε^{}) MPa", rounded(self.exponent))
    }
}

impl HardeningLaw for HockettSherby {
    #[inline]
    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let (value, slope) = power(strain, self.exponent);
        let rest = (self.saturation - self.initial) * (-self.rate * value).exp();
        FlowStress { stress: self.saturation - rest, slope: rest * self.rate * slope }
    }
}
