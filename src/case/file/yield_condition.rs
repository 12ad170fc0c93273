//! `yield_condition` of `[material]`.

use crate::units::{Number, Positive};
use serde::Deserialize;

/// The curve of the stresses at which the sheet yields; both take r̄ from `anisotropy`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
#[derive(schemars::JsonSchema)]
pub enum YieldCondition {
    /// Hill's of 1948, quadratic.
    Hill48,
    /// Hosford's.
    Hosford(Hosford),
}

impl YieldCondition {
    /// Hosford's of fcc metal, as `[material]` has it.
    pub const FCC: &str = "yield_condition = { hosford = { crystal = \"fcc\" } }";
}

/// (1 + r̄) σ_y^a = |σ_s|^a + |σ_θ|^a + r̄ |σ_s − σ_θ|^a.
///
/// The crystals' own curve: flatter sides and sharper corners than Hill's, which is its a = 2. Valid for sheet that is alike in
/// all its directions, without voids; the transverse shear is added quadratically, as Hill's condition has it.
/// Source: W. F. Hosford, J. Appl. Mech. 39 (1972) 607–609; R. W. Logan, W. F. Hosford, Int. J. Mech. Sci. 22 (1980) 419–430
/// (not read; the form is in common use).
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(rename = "HosfordLaw")]
pub struct Hosford {
    /// Lattice of the metal, which says a: 8 for fcc, 6 for bcc.
    #[schemars(example = &"fcc")]
    pub crystal: Option<Crystal>,
    /// a, 2 to 10, in the place of `crystal`.
    #[schemars(example = 8)]
    pub exponent: Option<Positive<Number>>,
}

/// Lattice of a metal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
#[derive(schemars::JsonSchema)]
pub enum Crystal {
    /// Body-centred cubic: ferritic steel; a = 6.
    Bcc,
    /// Face-centred cubic: aluminium, copper, austenitic steel; a = 8.
    Fcc,
}

impl Crystal {
    /// a, by R. W. Logan and W. F. Hosford \[–\].
    pub fn exponent(self) -> f64 {
        match self {
            Self::Bcc => 6.0,
            Self::Fcc => 8.0,
        }
    }
}
