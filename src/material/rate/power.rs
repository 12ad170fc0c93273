//! Power law of the rate, from cold steel to superplastic alloys.

use super::Factor;

/// g = (ε̄̇/ε̇_r)^m.
///
/// With ε̇_r = 1/s on a law σ_s = K ε̄^n it is the superplastic law K ε̄^n ε̄̇^m, which has no yield: what stands still
/// bears nothing.
///
/// # References
/// W. A. Backofen, I. R. Turner, D. H. Avery, Superplasticity in an Al-Zn alloy, Trans. ASM 57 (1964) 980–990 (not read;
/// the form is in common use).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerRate {
    /// m, 0 to 1 \[–\].
    pub exponent: f64,
    /// ε̇_r, at which the factor is 1 \[1/s\].
    pub reference: f64,
}

impl PowerRate {
    /// The factor and its slope.
    #[inline]
    pub fn at(&self, rate: f64) -> Factor {
        let value = (rate / self.reference).powf(self.exponent);
        Factor { value, slope: self.exponent * value / rate }
    }
}
