use super::*;

/// Least factor, near the melting point \[–\].
const LEAST: f64 = 1e-3;

parameters! {
    /// 1 − ((T − reference)/(melting − reference))^exponent; 1 below the reference.
    ///
    /// Valid up to some tenths of the way to the melting point; held at a thousandth just below it.
    /// Source: in common use; G. R. Johnson, W. H. Cook, 7th Int. Symp. on Ballistics (1983) 541–547 (not read).
    pub struct Melting {
        /// Temperature at which the hardening law was measured \[K\].
        pub reference: "As::<Positive<Temperature>>" = "20 °C",
        /// Melting point \[K\].
        pub melting: "As::<Positive<Temperature>>" = "600 °C",
        /// Thermal exponent.
        pub exponent: "As::<Positive<Number>>" = 1.03,
    }
}

impl TemperatureLaw for Melting {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        let Self { reference, melting, .. } = *self;
        require_or("melting", melting > reference, "600 °C or so for aluminium", || {
            format!("melting at {melting} K is not above the reference of {reference} K")
        })
    }

    fn formula(&self) -> String {
        let (from, span) = (celsius(self.reference), rounded(self.melting - self.reference));
        format!("[1 − ((T − {from} °C)/{span} K)^{}]", self.exponent)
    }

    fn at(&self, temperature: f64) -> f64 {
        let x = ((temperature - self.reference) / (self.melting - self.reference)).max(0.0);
        (1.0 - x.powf(self.exponent)).max(LEAST)
    }
}
