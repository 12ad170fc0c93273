//! Softening towards the melting point: the thermal term of Johnson and Cook.

/// h = 1 − ((T − T_r)/(T_m − T_r))^q, 1 below the reference; held at a thousandth just below the melting point, where the
/// law has no stress.
///
/// # References
/// G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics, The Hague (1983) 541–547 (not read; the form is in
/// common use).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Melting {
    /// T_r \[K\].
    pub reference: f64,
    /// T_m \[K\].
    pub melting: f64,
    /// q \[–\].
    pub exponent: f64,
}

/// What is left at the melting point \[–\].
const LEAST: f64 = 1e-3;

impl Melting {
    /// The factor.
    #[inline]
    pub fn at(&self, temperature: f64) -> f64 {
        let x = ((temperature - self.reference) / (self.melting - self.reference)).max(0.0);
        (1.0 - x.powf(self.exponent)).max(LEAST)
    }
}
