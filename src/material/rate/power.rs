use super::{Factor, RateLaw};
use crate::material::law::prelude::*;

parameters! {
    /// (rate/reference)^exponent; with a reference of 1/s on a Hollomon law the superplastic K ε^n ε̇^m.
    ///
    /// Valid over the two or three decades of the rate that m was measured in.
    /// Source: in common use; W. A. Backofen, I. R. Turner, D. H. Avery, Superplasticity in an Al-Zn alloy, Trans. ASM 57
    /// (1964) 980–990 (not read).
    pub struct PowerRate {
        /// m, 0 to 1.
        pub exponent: Fraction = 0.02,
        /// Strain rate at which the hardening law was measured \[1/s\].
        pub reference: Positive<StrainRate> = "0.001 /s",
    }
}

impl Law for PowerRate {
    fn examples() -> Vec<Self> {
        vec![Self { exponent: 0.02, reference: 1e-3 }, Self { exponent: 0.5, reference: 1.0 }]
    }

    fn formula(&self) -> String {
        format!("(ε̄̇/{} 1/s)^{}", self.reference, self.exponent)
    }
}

impl RateLaw for PowerRate {
    #[inline]
    fn at(&self, rate: f64) -> Factor {
        let value = (rate / self.reference).powf(self.exponent);
        Factor { value, slope: self.exponent * value / rate }
    }

    fn is_superplastic(&self) -> bool {
        self.exponent >= 0.3
    }
}
