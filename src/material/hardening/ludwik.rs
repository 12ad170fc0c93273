use super::*;

parameters! {
    /// σ = initial + k ε^n.
    ///
    /// Valid for metals with a marked yield stress; just beyond yield its slope is infinite, a chord over 1e-6 takes its place.
    /// Source: P. Ludwik, Elemente der technologischen Mechanik, Springer, Berlin (1909).
    pub struct Ludwik as HardeningLaw {
        /// Yield stress σ₀ \[MPa\].
        initial: "As::<Positive<Stress>>" = "150 MPa",
        /// K, the hardening at a strain of 1 \[MPa\].
        k: "As::<NonNegative<Stress>>" = "400 MPa",
        /// Hardening exponent, above 0 and up to 1.
        n: "As::<Fraction>" = 0.5,
    }
}

impl HardeningLaw for Ludwik {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        let Self { initial, k, n } = *self;
        require("initial", initial > 0.0, || format!("initial must be positive, found {initial} MPa"))?;
        require("k", k >= 0.0, || format!("k must not be negative, found {k} MPa"))?;
        require("n", n > 0.0 && n <= 1.0, || format!("n must lie above 0 and up to 1, found {n}"))
    }

    fn formula(&self) -> String {
        format!("Ludwik, σ = {} + {} ε^{} MPa", rounded(self.initial), rounded(self.k), rounded(self.n))
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let (value, slope) = power(strain, self.n);
        FlowStress { stress: self.initial + self.k * value, slope: self.k * slope }
    }
}
