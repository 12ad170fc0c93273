use super::*;

/// σ = weight σ_swift + (1 − weight) σ_voce.
///
/// Valid where each of both was fitted to the same test: the weight says how far beyond its end hardening goes on. With an
/// exponent below 1 the second is Hockett and Sherby's.
/// Source: in common use for sheet; no first author is known.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mixed {
    /// Share of Swift's law, 0 to 1.
    #[serde(with = "As::<Fraction>")]
    weight: f64,
    /// The law that hardens without end.
    swift: Swift,
    /// The law that comes to an end.
    voce: Voce,
}

impl Example for Mixed {
    fn example() -> Self {
        Self { weight: 0.6, swift: Swift::example(), voce: Voce::example() }
    }
}

impl HardeningLaw for Mixed {
    fn prepare(&mut self, young: Option<f64>) -> Result<(), LawError> {
        let within = |law: &'static str| move |e: LawError| LawError { key: format!("{law}.{}", e.key), ..e };
        self.swift.prepare(young).map_err(within("swift"))?;
        self.voce.prepare(young).map_err(within("voce"))
    }

    fn formula(&self) -> String {
        let [weight, rest] = [self.weight, 1.0 - self.weight].map(rounded);
        format!("{weight} of {}, {rest} of {}", self.swift.formula(), self.voce.formula())
    }

    fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        let voce = self.voce.at_temperature(strain, temperature);
        voce.towards(self.swift.at_temperature(strain, temperature), self.weight)
    }
}
