use super::*;

parameters! {
    /// (rate/reference)^exponent; with a reference of 1/s on a Hollomon law the superplastic K ε^n ε̇^m.
    ///
    /// Valid over the two or three decades of the rate that m was measured in.
    /// Source: in common use; W. A. Backofen, I. R. Turner, D. H. Avery, Trans. ASM 57 (1964) 980–990 (not read).
    pub struct PowerRate {
        /// m, 0 to 1.
        pub exponent: "As::<Fraction>" = 0.02,
        /// Strain rate at which the hardening law was measured \[1/s\].
        pub reference: "As::<Positive<StrainRate>>" = "0.001 /s",
    }
}

impl RateLaw for PowerRate {
    fn formula(&self) -> String {
        format!("(ε̄̇/{} 1/s)^{}", self.reference, self.exponent)
    }

    fn at(&self, rate: f64) -> ValueAndSlope {
        let value = (rate / self.reference).powf(self.exponent);
        ValueAndSlope { value, slope: self.exponent * value / rate }
    }
}
