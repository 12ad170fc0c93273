//! σ_y = K (ε₀ + ε̄)^n with a declared offset ε₀, or that of the elastic line, K ε₀^n = E ε₀.

use super::*;

/// σ = k ε^n, started at the elastic line or at a declared offset strain.
///
/// Valid beyond a strain of some per cent; at yield it says little.
/// Source: J. H. Hollomon, Tensile deformation, Trans. AIME 162 (1945) 268–290.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hollomon {
    /// K, the stress at a strain of 1 \[MPa\].
    #[serde(with = "As::<Positive<Stress>>")]
    k: f64,
    /// Hardening exponent, 0 to 1.
    #[serde(with = "As::<Fraction>")]
    n: f64,
    /// Offset strain; without it `young` must be given, and the law starts where it meets the elastic line.
    #[serde(default, with = "As::<Positive<Number>>")]
    offset: Option<f64>,
    /// ε₀, declared or of the elastic line.
    #[serde(skip)]
    start: f64,
}

impl Hollomon {
    /// Law with a declared offset strain, or else that of the elastic line of modulus `young`. `k` and `young` \[MPa\].
    /// Fails when a parameter is out of range, or the elastic line is met at a strain above 0.05 (then K or E has a wrong unit).
    pub fn new(k: f64, n: f64, offset: Option<f64>, young: Option<f64>) -> Result<Self, LawError> {
        let mut law = Self { k, n, offset, start: 0.0 };
        law.prepare(young).map(|()| law)
    }
}

impl Example for Hollomon {
    fn example() -> Self {
        Self::new(547.0, 0.18, None, Some(210_000.0)).expect("valid")
    }
}

impl HardeningLaw for Hollomon {
    fn prepare(&mut self, young: Option<f64>) -> Result<(), LawError> {
        let Self { k, n, .. } = *self;
        self.start = match (self.offset, young) {
            (Some(offset), _) => offset,
            (None, Some(young)) => {
                require("", young > 0.0 && (0.0..1.0).contains(&n), || {
                    format!("needs young > 0 and 0 <= n < 1, found young = {young} MPa, n = {n}")
                })?;
                let start = (k / young).powf(1.0 / (1.0 - n));
                require("k", start < 0.05, || {
                    let [k, young] = [k, young].map(rounded);
                    format!("K = {k} MPa meets the elastic line of E = {young} MPa at a strain of {start:.3}")
                })?;
                start
            }
            (None, None) => {
                let help = "add offset = 0.001 to the law, or young = \"210 GPa\" and poisson = 0.3 to [material]";
                let message = "k ε^n has no stress at ε = 0; it needs an `offset`, or `young` to start from";
                return Err(LawError::new(message, help));
            }
        };
        // From here on it is Swift's.
        super::Swift::new(k, n, self.start).map(drop)
    }

    fn formula(&self) -> String {
        let origin = if self.offset.is_some() { "declared offset" } else { "offset from the elastic line" };
        let [k, start, n] = [self.k, self.start, self.n].map(rounded);
        format!("Hollomon, σ = {k} ({start} + ε)^{n} MPa ({origin})")
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        offset_power(self.k, self.start, self.n, strain)
    }
}
