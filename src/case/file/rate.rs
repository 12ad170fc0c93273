//! `[material.rate]`: how the yield stress depends on the strain rate.

use crate::units::{Fraction, Number, Positive, StrainRate};
use schemars::JsonSchema;
use serde::Deserialize;

/// A factor on the hardening law: exactly one.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rate {
    pub power: Option<PowerRate>,
    pub cowper_symonds: Option<CowperSymonds>,
    pub johnson_cook: Option<JohnsonCook>,
}

/// (rate/reference)^exponent; with a reference of 1/s on a Hollomon law the superplastic K ε^n ε̇^m.
///
/// Valid over the two or three decades of the rate that m was measured in.
/// Source: in common use; W. A. Backofen, I. R. Turner, D. H. Avery, Trans. ASM 57 (1964) 980–990 (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PowerRate {
    /// m, 0 to 1.
    #[schemars(example = 0.02)]
    pub exponent: Fraction,
    /// Strain rate at which the hardening law was measured.
    #[schemars(example = "0.001 /s")]
    pub reference: Positive<StrainRate>,
}

/// 1 + (rate/C)^(1/p), which is Perzyna's law with the fluidity C.
///
/// Valid for the strong rate dependence of mild steel at press speeds and beyond.
/// Source: in common use; G. R. Cowper, P. S. Symonds (1957), P. Perzyna (1966) (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CowperSymonds {
    /// C.
    #[schemars(example = "40 /s")]
    pub rate: Positive<StrainRate>,
    /// p.
    #[schemars(example = 5.0)]
    pub exponent: Positive<Number>,
}

/// 1 + C ln(rate/reference) above the reference rate, smoothly 1 below it.
///
/// Valid above the reference rate, for a weak dependence.
/// Source: in common use; G. R. Johnson, W. H. Cook (1983) (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JohnsonCook {
    /// C.
    #[schemars(example = 0.015)]
    pub coefficient: Positive<Number>,
    /// ε̇₀.
    #[schemars(example = "0.001 /s")]
    pub reference: Positive<StrainRate>,
}
