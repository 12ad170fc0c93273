use super::flow_stress::{FlowStress, HardeningLaw, power, saturating};
use crate::material::law::prelude::*;

/// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
///
/// Valid for metals whose hardening comes to an end, such as aluminium.
/// Source: E. Voce, J. Inst. Metals 74 (1948) 537–562; the exponent: J. E. Hockett, O. D. Sherby (1975).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Voce {
    /// Yield stress σ₀ \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(example = "125 MPa")]
    initial: f64,
    /// Stress σ_s that hardening comes to \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(example = "320 MPa")]
    saturation: f64,
    /// b: how fast it comes there.
    #[serde(with = "As::<NonNegative<Number>>")]
    #[schemars(example = 7.5)]
    rate: f64,
    /// Power of the strain; 1 when not given.
    #[serde(default = "one", with = "As::<Fraction>")]
    #[schemars(example = 1.0)]
    exponent: f64,
}

constructor!(Voce { initial, saturation, rate, exponent });

impl Law for Voce {
    fn examples() -> Vec<Self> {
        vec![
            Self { initial: 180.0, saturation: 400.0, rate: 9.0, exponent: 1.0 },
            Self { initial: 125.0, saturation: 320.0, rate: 7.5, exponent: 0.97 },
        ]
    }

    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        saturating([self.initial, self.saturation, self.rate, self.exponent])
    }

    fn formula(&self) -> String {
        let exponent = if self.exponent == 1.0 { String::new() } else { format!("^{}", rounded(self.exponent)) };
        let [saturation, span, rate] = [self.saturation, self.saturation - self.initial, self.rate].map(rounded);
        format!("Voce, σ = {saturation} − {span} exp(−{rate} ε{exponent}) MPa")
    }
}

impl HardeningLaw for Voce {
    #[inline]
    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let (value, slope) = if self.exponent == 1.0 { (strain, 1.0) } else { power(strain, self.exponent) };
        let rest = (self.saturation - self.initial) * (-self.rate * value).exp();
        FlowStress { stress: self.saturation - rest, slope: rest * self.rate * slope }
    }
}
