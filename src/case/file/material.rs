//! `[material]` and `[forming_limit]`.

use super::untagged::untagged;
use crate::forming_limit::{KeelerBrazier, MarciniakKuczynski, Strain};
use crate::material::hardening::HardeningTable;
use crate::material::rate::RateTable;
use crate::material::thermal::ThermalTable;
use crate::material::{BackStress, Gtn, RValues};
use crate::model::Mode;
use crate::units::{Dimensioned, Fraction, Number, Positive, Stress};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::IntoDeserializer;

/// The sheet's material, isotropic in its plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "young": ["poisson"], "poisson": ["young"] }))]
pub struct Material {
    /// Sheet of the built-in library (`stampflow materials` lists them); other keys written here replace the library's.
    #[schemars(example = &"aa6016-t4")]
    pub name: Option<String>,
    /// Source of the numbers: author and year, or how they were measured; left out if they are assumed.
    #[schemars(example = &"tension tests of this coil")]
    pub source: Option<String>,
    /// Young's modulus; given together with `poisson`.
    #[schemars(example = "210 GPa")]
    pub young: Option<Positive<Stress>>,
    /// Poisson's ratio, below 0.5.
    #[schemars(example = 0.3)]
    pub poisson: Option<Fraction>,
    /// Normal anisotropy r̄, 0.1 to 10: width strain over thickness strain in tension, mean over the directions in the
    /// sheet; default 1. Or r of three directions, `{ r0 = 0.525, r45 = 0.248, r90 = 0.429 }`, whose mean
    /// r̄ = (r0 + 2 r45 + r90)/4 is used, and from which ears are estimated.
    /// σ_y² = σ_s² − 2 r̄/(1 + r̄) σ_s σ_θ + σ_θ², unless `yield_condition` says otherwise.
    ///
    /// Valid for sheet that is alike in all its directions; it cannot show ears, and aluminium with r̄ below 1 is stronger in
    /// equi-biaxial tension than this: `yield_condition` has another curve. Source: R. Hill, Proc. R. Soc. London A 193
    /// (1948) 281–297.
    #[schemars(example = 1.6)]
    pub anisotropy: Option<Anisotropy>,
    /// Curve of the stresses at which the sheet yields; default "hill48".
    #[schemars(example = &"hill48", extend("default" = "hill48"))]
    pub yield_condition: Option<YieldCondition>,
    /// Response to strain; default "flow". The others need `young` and `poisson`.
    #[schemars(example = &"elasto_viscoplastic", extend("default" = "flow"))]
    pub mode: Option<Mode>,
    /// Strain-rate dependence; default none. The punch's `speed` then matters.
    pub rate: Option<RateTable>,
    /// Dependence on the temperature; default none. `[heat]` gives the temperature.
    pub softening: Option<ThermalTable>,
    /// Back-stresses of an elasto-viscoplastic sheet, at most two; default none. The hardening law is then the yield stress
    /// less the back-stresses.
    ///
    /// dα = C ξ/σ_R dε − γ α dε: valid for metal that is bent and bent back; it needs tests with reversed strain. Source:
    /// J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188 (not read; the form is in common use).
    #[serde(default)]
    #[schemars(length(max = 2))]
    pub kinematic: Vec<BackStress>,
    /// Microscopic voids; default none.
    pub voids: Option<Gtn>,
    /// Largest strain of the measurements that a formula of hardening is fitted to; a run that strains the sheet further
    /// reports it. A table ends at its last point.
    #[schemars(example = 0.22)]
    pub fitted_up_to: Option<Positive<Number>>,
    /// Exactly one law, such as `[material.hardening.swift]`.
    pub hardening: Option<HardeningTable>,
}

/// Normal anisotropy: the mean r-value, or those of three directions.
#[derive(Clone, Copy, Debug, PartialEq, JsonSchema)]
#[schemars(untagged)]
pub enum Anisotropy {
    /// r̄.
    Mean(Positive<Number>),
    /// r by direction.
    Directions(RValues),
}

untagged!(
    [] Anisotropy, "r̄ such as 1.6, or { r0 = 0.5, r45 = 0.3, r90 = 0.4 }",
    number(mean) => Positive::deserialize(mean.into_deserializer()).map(Anisotropy::Mean),
    table => Anisotropy::Directions
);

impl Anisotropy {
    /// r̄ \[–\].
    pub fn mean(self) -> f64 {
        match self {
            Self::Mean(mean) => mean.value(),
            Self::Directions(r) => r.mean(),
        }
    }

    /// r-values, if they are given by direction.
    pub fn directions(self) -> Option<RValues> {
        if let Self::Directions(r) = self { Some(r) } else { None }
    }
}

/// Yield curve; both take r̄ from `anisotropy`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum YieldCondition {
    /// Hill's of 1948, quadratic.
    Hill48,
    /// Hosford's.
    Hosford(Hosford),
}

impl YieldCondition {
    /// Key of Hosford's condition for fcc metal, as `[material]` has it.
    pub const FCC: &str = "yield_condition = { hosford = { crystal = \"fcc\" } }";
}

/// (1 + r̄) σ_y^a = |σ_s|^a + |σ_θ|^a + r̄ |σ_s − σ_θ|^a.
///
/// The crystals' own curve: flatter sides and sharper corners than Hill's, which is its a = 2. Valid for sheet that is alike in
/// all its directions, without voids; the transverse shear is added quadratically, as Hill's condition has it.
/// Source: W. F. Hosford, J. Appl. Mech. 39 (1972) 607–609; R. W. Logan, W. F. Hosford, Int. J. Mech. Sci. 22 (1980) 419–430
/// (not read; the form is in common use).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "HosfordLaw")]
pub struct Hosford {
    /// Lattice of the metal, which decides a: 8 for fcc, 6 for bcc.
    #[schemars(example = &"fcc")]
    pub crystal: Option<Crystal>,
    /// a, 2 to 10, instead of `crystal`.
    #[schemars(example = 8)]
    pub exponent: Option<Positive<Number>>,
}

/// Lattice of a metal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
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

/// Forming limit curve, exactly one: `points`, `measured`, `keeler_brazier`, `hill`, `swift` or `marciniak_kuczynski`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "points": ["strain"], "strain": ["points"] }))]
pub struct FormingLimit {
    /// Pairs of minor and major strain from left to right, plain numbers: `[[-0.2, 0.5], [0, 0.3], [0.3, 0.45]]`.
    ///
    /// Valid for the sheet and the thickness it was measured on, and for straight strain paths. Source: the case's own.
    pub points: Option<Vec<(Number, Number)>>,
    /// Measure of strain of `points`: needed with them.
    #[schemars(example = &"logarithmic")]
    pub strain: Option<Strain>,
    /// Measured points of the library's sheet that `[material] name` names, if it has some.
    #[schemars(example = true)]
    pub measured: Option<bool>,
    /// Empirical curve of steels; `{}` takes n from the hardening law.
    pub keeler_brazier: Option<KeelerBrazier>,
    /// Hill's localised necking on the left, Swift's diffuse necking on the right: from the hardening law and r̄.
    #[schemars(example = true)]
    pub hill: Option<bool>,
    /// Swift's diffuse necking on both sides: from the hardening law and r̄.
    #[schemars(example = true)]
    pub swift: Option<bool>,
    /// Hardening exponent of `keeler_brazier`, `hill` or `swift`. Default: for `keeler_brazier` the uniform strain at the load
    /// maximum of the hardening law, for the others the law itself.
    #[schemars(example = 0.21)]
    pub n: Option<Fraction>,
    /// Groove in the sheet: from the hardening law, the rate law and r̄.
    pub marciniak_kuczynski: Option<MarciniakKuczynski>,
}
