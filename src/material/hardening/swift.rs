use super::*;

parameters! {
    /// σ = k (offset + ε)^n.
    ///
    /// Valid up to large strains for most steels; it hardens without end.
    /// Source: H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1–18.
    pub struct Swift as HardeningLaw {
        /// K, the stress at a total strain of 1 \[MPa\].
        k: "As::<Positive<Stress>>" = "520 MPa",
        /// Hardening exponent, 0 to 1.
        n: "As::<Fraction>" = 0.22,
        /// Offset strain, 1e-6 to 1.
        offset: "As::<Positive<Number>>" = 0.005,
    }
}

impl HardeningLaw for Swift {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        let Self { k, n, offset } = *self;
        require("k", k > 0.0 && k.is_finite(), || format!("k must be positive, found {k} MPa"))?;
        require_range(["n"; 2], n, [0.0, 1.0], "check the constants and their units")?;
        require_range(["offset"; 2], offset, [1e-6, 1.0], "check the constants and their units")
    }

    fn formula(&self) -> String {
        format!("Swift, σ = {} ({} + ε)^{} MPa", rounded(self.k), rounded(self.offset), rounded(self.n))
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        offset_power(self.k, self.offset, self.n, strain)
    }
}
