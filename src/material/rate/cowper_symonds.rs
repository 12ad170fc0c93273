//! Overstress with a threshold: the law of Cowper and Symonds, which is Perzyna's with a power of the overstress.

use super::Factor;

/// g = 1 + (ε̄̇/C)^(1/p); inverted it is Perzyna's ε̄̇ = C ⟨σ̄/σ_s − 1⟩^p with the fluidity C.
///
/// # References
/// G. R. Cowper, P. S. Symonds, Brown University Tech. Rep. 28 (1957); P. Perzyna, Adv. Appl. Mech. 9 (1966) 243–377
/// (not read; the forms are in common use).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CowperSymonds {
    /// C \[1/s\].
    pub rate: f64,
    /// p \[–\].
    pub exponent: f64,
}

impl CowperSymonds {
    /// The factor and its slope.
    #[inline]
    pub fn at(&self, rate: f64) -> Factor {
        let over = (rate / self.rate).powf(1.0 / self.exponent);
        Factor { value: 1.0 + over, slope: over / (self.exponent * rate) }
    }
}
