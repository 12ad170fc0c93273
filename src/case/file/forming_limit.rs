//! `[forming_limit]`: the curve that the strains are held against.

use crate::units::{Fraction, Length, Number, Positive, StrainRate};
use schemars::JsonSchema;
use serde::Deserialize;

/// A forming limit curve, exactly one: `points`, `keeler_brazier`, `hill`, `swift` or `marciniak_kuczynski`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormingLimit {
    /// Pairs of minor and major strain from left to right, plain numbers: `[[-0.2, 0.5], [0, 0.3], [0.3, 0.45]]`.
    ///
    /// Valid for the sheet and the thickness it was measured on, and for straight strain paths. Source: the case's own.
    pub points: Option<Vec<(Number, Number)>>,
    /// How `points` are measured: needed with them.
    #[schemars(example = &"logarithmic")]
    pub strain: Option<StrainMeasure>,
    /// The empirical curve of steels; `{}` takes n from the hardening law.
    pub keeler_brazier: Option<KeelerBrazier>,
    /// Hill's localised necking on the left, Swift's diffuse necking on the right: from the hardening law and r̄.
    #[schemars(example = true)]
    pub hill: Option<bool>,
    /// Swift's diffuse necking on both sides: from the hardening law and r̄.
    #[schemars(example = true)]
    pub swift: Option<bool>,
    /// Hardening exponent of `keeler_brazier`, `hill` or `swift` in place of the hardening law's own: without it
    /// `keeler_brazier` takes the uniform strain at the load maximum of the law, the others the law itself.
    #[schemars(example = 0.21)]
    pub n: Option<Fraction>,
    /// A groove in the sheet: from the hardening law, the rate law and r̄.
    pub marciniak_kuczynski: Option<MarciniakKuczynski>,
}

/// Strains of a measured curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StrainMeasure {
    /// True strain.
    #[serde(alias = "true")]
    Logarithmic,
    /// Change of length over the initial length.
    Engineering,
}

/// FLC₀ = (23.3 + 14.13 t/mm) n/0.21 percent (engineering) at plane strain; left ε₁ + ε₂ = const, right a slope of 0.6.
///
/// Valid for mild and conventional high-strength steel up to 3.1 mm; n counts as 0.21 at most.
/// Source: S. P. Keeler, W. G. Brazier, Micro Alloying 75 (1977) 517–530 (not read; as AHSS Insights and programs quote it).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KeelerBrazier {
    /// Thickness that counts, 3.1 mm at most; that of the blank when not given.
    #[schemars(example = "1 mm")]
    pub thickness: Option<Positive<Length>>,
}

/// A groove of `imperfection` times the sheet's thickness takes over.
///
/// Valid for straight strain paths; with β > 0 it is high by Hill's condition where r̄ is below 1.
/// Source: Z. Marciniak, K. Kuczyński, Int. J. Mech. Sci. 9 (1967) 609–620 (not read; derived in the program).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MarciniakKuczynski {
    /// f₀, 0.9 to 0.9999: thickness of the groove over that around it; 0.995 when not given, an assumption.
    #[schemars(example = 0.995)]
    pub imperfection: Option<Fraction>,
    /// Strain rate of the sheet; 1 /s when not given, an assumption. A power law of the rate does not feel it.
    #[schemars(example = "1 /s")]
    pub strain_rate: Option<Positive<StrainRate>>,
}
