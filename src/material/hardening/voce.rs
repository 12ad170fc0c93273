use super::*;

parameters! {
    /// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
    ///
    /// Valid for metals whose hardening comes to an end, such as aluminium.
    /// Source: E. Voce, J. Inst. Metals 74 (1948) 537–562; the exponent: J. E. Hockett, O. D. Sherby (1975).
    pub struct Voce as HardeningLaw {
        /// Yield stress σ₀ \[MPa\].
        initial: "As::<Positive<Stress>>" = "125 MPa",
        /// Stress σ_s that hardening comes to \[MPa\].
        saturation: "As::<Positive<Stress>>" = "320 MPa",
        /// b: how fast it comes there.
        rate: "As::<NonNegative<Number>>" = 7.5,
        /// Power of the strain; 1 when not given.
        #[serde(default = "one")]
        exponent: "As::<Fraction>" = 1.0,
    }
}

impl HardeningLaw for Voce {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        check_saturating([self.initial, self.saturation, self.rate, self.exponent])
    }

    fn formula(&self) -> String {
        let exponent = if self.exponent == 1.0 { String::new() } else { format!("^{}", rounded(self.exponent)) };
        let [saturation, span, rate] = [self.saturation, self.saturation - self.initial, self.rate].map(rounded);
        format!("Voce, σ = {saturation} − {span} exp(−{rate} ε{exponent}) MPa")
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let power = if self.exponent == 1.0 { (strain, 1.0) } else { power(strain, self.exponent) };
        saturating(self.initial, self.saturation, self.rate, power)
    }
}
