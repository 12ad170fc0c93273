//! g = 1 + C ln(ε̄̇/ε̇₀) above the reference rate, below it smoothly down to 1: g = 1 + ½ C ln(1 + (ε̄̇/ε̇₀)²).

use super::*;

parameters! {
    /// 1 + C ln(rate/reference) above the reference rate, smoothly 1 below it.
    ///
    /// Valid above the reference rate, for a weak dependence.
    /// Source: in common use; G. R. Johnson, W. H. Cook, 7th Int. Symp. on Ballistics (1983) 541–547 (not read).
    pub struct JohnsonCook {
        /// C.
        pub coefficient: "As::<Positive<Number>>" = 0.015,
        /// ε̇₀ \[1/s\].
        pub reference: "As::<Positive<StrainRate>>" = "0.001 /s",
    }
}

impl RateLaw for JohnsonCook {
    fn formula(&self) -> String {
        format!("[1 + {} ln(ε̄̇/{} 1/s)]", self.coefficient, self.reference)
    }

    fn at(&self, rate: f64) -> ValueAndSlope {
        let x = rate / self.reference;
        let square = x * x;
        let value = 1.0 + 0.5 * self.coefficient * square.ln_1p();
        ValueAndSlope { value, slope: self.coefficient * x / ((1.0 + square) * self.reference) }
    }
}
