use super::*;

/// R \[N mm/(mol K)\].
const GAS_CONSTANT: f64 = 8_314.462_618;

parameters! {
    /// exp(exponent activation/R (1/T − 1/reference)): with the rate's exponent, of Z = ε̄̇ exp(Q/RT) (Zener-Hollomon) alone.
    ///
    /// Valid for hot metal, above half its absolute melting point.
    /// Source: in common use; C. Zener, J. H. Hollomon, J. Appl. Phys. 15 (1944) 22–32 (not read).
    pub struct Arrhenius {
        /// Activation energy Q \[N mm/mol\].
        pub activation: "As::<Positive<Energy>>" = "150 kJ/mol",
        /// m, 0 to 1.
        pub exponent: "As::<Fraction>" = 0.1,
        /// Temperature at which the hardening law was measured \[K\].
        pub reference: "As::<Positive<Temperature>>" = "420 °C",
    }
}

impl TemperatureLaw for Arrhenius {
    fn formula(&self) -> String {
        let Self { exponent, reference, .. } = self;
        format!("exp({exponent} × {:.0} K (1/T − 1/{reference} K))", self.activation / GAS_CONSTANT)
    }

    fn at(&self, temperature: f64) -> f64 {
        (self.exponent * (self.activation / GAS_CONSTANT) * (1.0 / temperature - 1.0 / self.reference)).exp()
    }
}
