//! `[material.softening]`: how the yield stress depends on the temperature.

use crate::units::{Energy, Fraction, Number, PerKelvin, Positive, Temperature};
use schemars::JsonSchema;
use serde::Deserialize;

/// A factor on the hardening law: exactly one. A table of curves by temperature is `[material.hardening.isotherms]`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Softening {
    pub johnson_cook: Option<Melting>,
    pub exponential: Option<Exponential>,
    pub arrhenius: Option<Arrhenius>,
}

/// 1 − ((T − reference)/(melting − reference))^exponent; 1 below the reference.
///
/// Valid up to some tenths of the way to the melting point.
/// Source: in common use; G. R. Johnson, W. H. Cook (1983) (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Melting {
    /// Temperature at which the hardening law was measured.
    #[schemars(example = "20 °C")]
    pub reference: Positive<Temperature>,
    #[schemars(example = "600 °C")]
    pub melting: Positive<Temperature>,
    #[schemars(example = 1.0)]
    pub exponent: Positive<Number>,
}

/// exp(−coefficient (T − reference)).
///
/// Valid in the range of temperatures that the coefficient was fitted to.
/// Source: in common use for warm forming.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Exponential {
    #[schemars(example = "0.003 /K")]
    pub coefficient: Positive<PerKelvin>,
    /// Temperature at which the hardening law was measured.
    #[schemars(example = "20 °C")]
    pub reference: Positive<Temperature>,
}

/// exp(exponent activation/R (1/T − 1/reference)): with a power of the strain rate of the same exponent the stress
/// depends on the Zener-Hollomon parameter alone.
///
/// Valid for hot metal, above half its absolute melting point.
/// Source: in common use; C. Zener, J. H. Hollomon, J. Appl. Phys. 15 (1944) 22–32 (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arrhenius {
    /// Activation energy Q.
    #[schemars(example = "150 kJ/mol")]
    pub activation: Positive<Energy>,
    /// m, 0 to 1.
    #[schemars(example = 0.1)]
    pub exponent: Fraction,
    /// Temperature at which the hardening law was measured.
    #[schemars(example = "420 °C")]
    pub reference: Positive<Temperature>,
}
