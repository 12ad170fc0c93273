//! Hollomon's power law, started at the elastic line.

use super::{FlowStress, LawError, Swift, require};
use crate::units::rounded;

/// σ_y = K (ε₀ + ε̄)^n.
///
/// Hollomon's σ = K ε^n is zero with an infinite slope at ε = 0. The offset ε₀ is either given, or is the strain
/// where the law meets the elastic line, K ε₀^n = E ε₀.
///
/// # References
/// J. H. Hollomon, Tensile deformation, Trans. AIME 162 (1945) 268–290.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hollomon {
    law: Swift,
    from_elastic_line: bool,
}

impl Hollomon {
    /// Law with a declared offset strain ε₀ > 0. `k` \[MPa\].
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn with_offset(k: f64, n: f64, offset: f64) -> Result<Self, LawError> {
        Ok(Self { law: Swift::new(k, n, offset)?, from_elastic_line: false })
    }

    /// Law whose offset is its intersection with the elastic line of modulus `young` \[MPa\].
    ///
    /// # Errors
    /// When a parameter is out of range, or the intersection lies at a strain above 0.05 (then K or E has a wrong unit).
    pub fn from_elastic_line(k: f64, n: f64, young: f64) -> Result<Self, LawError> {
        require("", young > 0.0 && (0.0..1.0).contains(&n), || {
            format!("hollomon: needs young > 0 and 0 <= n < 1, found young = {young} MPa, n = {n}")
        })?;
        let offset = (k / young).powf(1.0 / (1.0 - n));
        require("k", offset < 0.05, || {
            format!(
                "hollomon: K = {} MPa meets the elastic line of E = {} MPa at a strain of {offset:.3}; check their units",
                rounded(k),
                rounded(young)
            )
        })?;
        Ok(Self { law: Swift::new(k, n, offset)?, from_elastic_line: true })
    }

    #[inline]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        self.law.at(strain)
    }

    pub(super) fn describe(&self) -> String {
        let origin = if self.from_elastic_line { "offset from the elastic line" } else { "declared offset" };
        format!("Hollomon, {} ({origin})", self.law.formula())
    }
}
