//! Softening by a share per kelvin.

/// h = exp(−b (T − T_r)).
///
/// # References
/// In common use for warm forming, where b is 0.001 to 0.005 /K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// b \[1/K\].
    pub coefficient: f64,
    /// T_r \[K\].
    pub reference: f64,
}

impl Exponential {
    /// The factor.
    #[inline]
    pub fn at(&self, temperature: f64) -> f64 {
        (-self.coefficient * (temperature - self.reference)).exp()
    }
}
