//! The logarithm of the rate: the rate term of Johnson and Cook.

use super::Factor;

/// g = 1 + C ln(ε̄̇/ε̇₀) above the reference rate; below it, where the logarithm would fall without bound, g comes smoothly
/// down to 1: g = 1 + ½ C ln(1 + (ε̄̇/ε̇₀)²).
///
/// # References
/// G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics, The Hague (1983) 541–547 (not read; the form is in
/// common use).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JohnsonCook {
    /// C \[–\].
    pub coefficient: f64,
    /// ε̇₀ \[1/s\].
    pub reference: f64,
}

impl JohnsonCook {
    /// The factor and its slope.
    #[inline]
    pub fn at(&self, rate: f64) -> Factor {
        let x = rate / self.reference;
        let square = x * x;
        Factor {
            value: 1.0 + 0.5 * self.coefficient * square.ln_1p(),
            slope: self.coefficient * x / ((1.0 + square) * self.reference),
        }
    }
}
