//! `[forming_limit]`: the curve that the strains are held against.

use crate::forming_limit::{KeelerBrazier, MarciniakKuczynski, Strain};
use crate::units::{Fraction, Number};
use serde::Deserialize;

/// A forming limit curve, exactly one: `points`, `measured`, `keeler_brazier`, `hill`, `swift` or `marciniak_kuczynski`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "points": ["strain"], "strain": ["points"] }))]
pub struct FormingLimit {
    /// Pairs of minor and major strain from left to right, plain numbers: `[[-0.2, 0.5], [0, 0.3], [0.3, 0.45]]`.
    ///
    /// Valid for the sheet and the thickness it was measured on, and for straight strain paths. Source: the case's own.
    pub points: Option<Vec<(Number, Number)>>,
    /// How `points` are measured: needed with them.
    #[schemars(example = &"logarithmic")]
    pub strain: Option<Strain>,
    /// The measured points of the library's sheet that `[material] name` names, where it has some.
    #[schemars(example = true)]
    pub measured: Option<bool>,
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
