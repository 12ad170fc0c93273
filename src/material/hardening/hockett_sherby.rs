use super::flow_stress::{FlowStress, HardeningLaw, power, saturating};
use crate::material::law::prelude::*;

parameters! {
    /// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
    ///
    /// Valid for metals whose hardening comes to an end at large strains, such as aluminium and deep-drawing steel; just beyond
    /// yield its slope is infinite for an exponent below 1, a chord over 1e-6 takes its place.
    /// Source: J. E. Hockett, O. D. Sherby, J. Mech. Phys. Solids 23 (1975) 87–98 (not read; the form is in common use).
    pub struct HockettSherby {
        /// σ₀ at the start of yield \[MPa\].
        initial: Positive<Stress> = "130 MPa",
        /// σ_s at large strains \[MPa\].
        saturation: Positive<Stress> = "390 MPa",
        /// N.
        rate: NonNegative<Number> = 5.0,
        /// p, above 0 and up to 1.
        exponent: Fraction = 0.75,
    }
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
