use super::*;

parameters! {
    /// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
    ///
    /// Valid for metals whose hardening comes to an end at large strains, such as aluminium and deep-drawing steel; just beyond
    /// yield its slope is infinite for an exponent below 1, a chord over 1e-6 takes its place.
    /// Source: J. E. Hockett, O. D. Sherby, J. Mech. Phys. Solids 23 (1975) 87–98 (not read; the form is in common use).
    pub struct HockettSherby as HardeningLaw {
        /// σ₀ at the start of yield \[MPa\].
        initial: "As::<Positive<Stress>>" = "130 MPa",
        /// σ_s at large strains \[MPa\].
        saturation: "As::<Positive<Stress>>" = "390 MPa",
        /// N.
        rate: "As::<NonNegative<Number>>" = 5.0,
        /// p, above 0 and up to 1.
        exponent: "As::<Fraction>" = 0.75,
    }
}

impl HardeningLaw for HockettSherby {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        check_saturating([self.initial, self.saturation, self.rate, self.exponent])
    }

    fn formula(&self) -> String {
        let [saturation, span, rate] = [self.saturation, self.saturation - self.initial, self.rate].map(rounded);
        format!("Hockett-Sherby, σ = {saturation} − {span} exp(−{rate} ε^{}) MPa", rounded(self.exponent))
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        saturating(self.initial, self.saturation, self.rate, power(strain, self.exponent))
    }
}
