//! Softening of hot metal whose flow is thermally activated.

/// h = exp(m Q/R (1/T − 1/T_r)).
///
/// With a power m of the strain rate the flow stress depends on the Zener-Hollomon parameter Z = ε̄̇ exp(Q/RT) alone.
///
/// # References
/// C. Zener, J. H. Hollomon, J. Appl. Phys. 15 (1944) 22–32 (not read; the form is in common use).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrhenius {
    /// Q/R: activation energy over the gas constant \[K\].
    pub over_gas_constant: f64,
    /// m \[–\].
    pub exponent: f64,
    /// T_r \[K\].
    pub reference: f64,
}

impl Arrhenius {
    /// The factor.
    #[inline]
    pub fn at(&self, temperature: f64) -> f64 {
        (self.exponent * self.over_gas_constant * (1.0 / temperature - 1.0 / self.reference)).exp()
    }
}
