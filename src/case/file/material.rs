//! `[material]`.

use super::Anisotropy;
use super::yield_condition::YieldCondition;
use crate::material::law::Named;
use crate::material::{BackStress, Gtn, Hardening, Rate, ThermalLaw};
use crate::model::Mode;
use crate::units::{Fraction, Number, Positive, Stress};
use serde::Deserialize;

/// The sheet's material, isotropic in its plane.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "young": ["poisson"], "poisson": ["young"] }))]
pub struct Material {
    /// A sheet of the built-in library (`stampflow materials` lists them); what else is written here replaces what the
    /// library says.
    #[schemars(example = &"aa6016-t4")]
    pub name: Option<String>,
    /// Where the numbers come from: author and year, or how they were measured; left out where they are assumed.
    #[schemars(example = &"tension tests of this coil")]
    pub source: Option<String>,
    /// Young's modulus; given together with `poisson`.
    #[schemars(example = "210 GPa")]
    pub young: Option<Positive<Stress>>,
    /// Poisson's ratio, below 0.5.
    #[schemars(example = 0.3)]
    pub poisson: Option<Fraction>,
    /// Normal anisotropy r̄, 0.1 to 10: width strain over thickness strain in tension, mean over the directions in the
    /// sheet; 1 when not given. Or r of three directions, `{ r0 = 0.525, r45 = 0.248, r90 = 0.429 }`, whose mean
    /// r̄ = (r0 + 2 r45 + r90)/4 is taken, and by which the ears to be expected are told.
    /// σ_y² = σ_s² − 2 r̄/(1 + r̄) σ_s σ_θ + σ_θ², unless `yield_condition` says otherwise.
    ///
    /// Valid for sheet that is alike in all its directions; it cannot show ears, and aluminium with r̄ below 1 is stronger in
    /// equi-biaxial tension than it says: `yield_condition` has another curve for it. Source: R. Hill, Proc. R. Soc. London A 193 (1948) 281–297.
    #[schemars(example = 1.6)]
    pub anisotropy: Option<Anisotropy>,
    /// The curve of the stresses at which the sheet yields; "hill48" when not given.
    #[schemars(example = &"hill48", extend("default" = "hill48"))]
    pub yield_condition: Option<YieldCondition>,
    /// How the metal answers to strain; "flow" when not given. The others need `young` and `poisson`.
    #[schemars(example = &"elasto_viscoplastic", extend("default" = "flow"))]
    pub mode: Option<Mode>,
    /// Strain-rate dependence; none when not given. The punch's `speed` then matters.
    pub rate: Option<Named<Rate>>,
    /// Dependence on the temperature; none when not given. `[heat]` says what the temperature is.
    pub softening: Option<Named<ThermalLaw>>,
    /// Back-stresses of an elasto-viscoplastic sheet, at most two; none when not given. The hardening law is then what is
    /// left of the yield stress without them.
    ///
    /// dα = C ξ/σ_R dε − γ α dε: valid for metal that is bent and bent back; it needs tests with reversed strain. Source:
    /// J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188 (not read; the form is in common use).
    #[serde(default)]
    #[schemars(length(max = 2))]
    pub kinematic: Vec<BackStress>,
    /// Microscopic voids; none when not given.
    pub voids: Option<Gtn>,
    /// Largest strain of the measurements that a formula of hardening is fitted to; a run that strains the sheet further says
    /// so. A table ends where it ends.
    #[schemars(example = 0.22)]
    pub fitted_up_to: Option<Positive<Number>>,
    /// Exactly one law, such as `[material.hardening.swift]`.
    pub hardening: Option<Named<Hardening>>,
}
