use super::*;

parameters! {
    /// exp(−coefficient (T − reference)).
    ///
    /// Valid in the range of temperatures that the coefficient was fitted to: 0.001 to 0.005 /K in warm forming.
    /// Source: in common use for warm forming.
    pub struct Exponential {
        /// Share of the strength lost per kelvin \[1/K\].
        pub coefficient: "As::<Positive<PerKelvin>>" = "0.003 /K",
        /// Temperature at which the hardening law was measured \[K\].
        pub reference: "As::<Positive<Temperature>>" = "20 °C",
    }
}

impl TemperatureLaw for Exponential {
    fn formula(&self) -> String {
        format!("exp(−{} /K (T − {} °C))", self.coefficient, celsius(self.reference))
    }

    fn at(&self, temperature: f64) -> f64 {
        (-self.coefficient * (temperature - self.reference)).exp()
    }
}
