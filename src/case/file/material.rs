//! `[material]`: elastic constants and exactly one law of each kind.

use super::*;
use crate::grade::Coil;
use crate::material::law::{Family, LawError};
use crate::material::{
    self, BackStress, BackStresses, Elastic, Fracture, Gtn, Hardening, Hill48, RValues, Rate, ThermalLaw,
    YieldCriterion,
};
use crate::material::{fracture::FractureTable, hardening::HardeningTable, rate::RateTable, thermal::ThermalTable};
use crate::units::Digits;

/// The sheet's material, isotropic in its plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "young": ["poisson"], "poisson": ["young"] }))]
pub struct Material {
    /// Sheet of the built-in library (`stampflow materials` lists them); other keys written here replace the library's.
    pub name: Option<String>,
    /// Coil within the band of the library's sheet; default its middle.
    pub coil: Option<Coil>,
    /// Factor of the flow stress; default 1.
    pub strength: Option<Positive<Number>>,
    /// Source of the numbers: author and year, or how they were measured; left out if they are assumed.
    pub source: Option<String>,
    /// Young's modulus; given together with `poisson`.
    pub young: Option<Positive<Stress>>,
    /// Poisson's ratio, below 0.5.
    pub poisson: Option<Fraction>,
    /// Normal anisotropy r̄, 0.1 to 10: width strain over thickness strain in tension, mean over the directions in the
    /// sheet; default 1. Or r of three directions, `{ r0 = 0.525, r45 = 0.248, r90 = 0.429 }`, whose mean
    /// r̄ = (r0 + 2 r45 + r90)/4 is used, and from which ears are estimated.
    ///
    /// σ_y² = σ_s² − 2 r̄/(1 + r̄) σ_s σ_θ + σ_θ²: too soft in equi-biaxial tension with r̄ below 1, too strong in biaxial
    /// tension with r̄ above 1, for which `yield_condition` has another curve. Source: R. Hill, Proc. R. Soc. London A 193 (1948) 281–297.
    pub anisotropy: Option<Anisotropy>,
    /// Curve of the stresses at which the sheet yields; default that of the library's sheet, else "hill48", which is right for
    /// hexagonal metal such as titanium as far as its r̄ is.
    #[schemars(extend("default" = "hill48"))]
    pub yield_condition: Option<YieldCondition>,
    /// Response to strain; default "flow". The others need `young` and `poisson`.
    #[schemars(extend("default" = "flow"))]
    pub mode: Option<Mode>,
    /// Strain-rate dependence; default none. The punch's `speed` then matters.
    pub rate: Option<RateTable>,
    /// Dependence on the temperature; default none. `[heat]` gives the temperature.
    pub softening: Option<ThermalTable>,
    /// Back-stresses of an elasto-viscoplastic sheet, at most two; default none. The hardening law is then without them.
    /// dα = C ξ/σ_R dε − γ α dε: for metal that is bent and bent back; it needs tests with reversed strain. Source:
    /// J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188 (not read).
    #[serde(default)]
    #[schemars(length(max = 2))]
    pub kinematic: Vec<BackStress>,
    /// Microscopic voids; default none.
    pub voids: Option<Gtn>,
    /// Criterion of ductile fracture, summed up at every thickness point; default none, and fracture is not judged.
    pub fracture: Option<FractureTable>,
    /// Source of the constants of `fracture`: author and year, or the test; left out if they are assumed.
    pub fracture_source: Option<String>,
    /// Largest strain of the measurements that a formula of hardening is fitted to; a run that strains the sheet further
    /// reports it. A table ends at its last point.
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
    pub fn mean(self) -> f64 {
        match self {
            Self::Mean(mean) => mean.value(),
            Self::Directions(r) => r.mean(),
        }
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
    pub crystal: Option<Crystal>,
    /// a, 2 to 10, instead of `crystal`.
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
        [6.0, 8.0][self as usize]
    }
}

const HARDENING: &str = "material.hardening";
/// Yield stress at 10 % strain, from hot superplastic alloys far below to piano wire far above \[MPa\].
const YIELD: RangeInclusive<f64> = 0.1..=1e5;

impl Material {
    pub fn model(&self, source: &Source) -> Result<material::Material> {
        let elastic = match (self.young, self.poisson) {
            (None, None) => None,
            (Some(young), Some(poisson)) => Some(Elastic { young: young.value(), poisson: poisson.value() }),
            (Some(_), None) => return Err(source.missing("material", "poisson")),
            (None, Some(_)) => return Err(source.missing("material", "young")),
        };
        if let Some(Elastic { poisson, .. }) = elastic {
            let what = format!("`poisson` must be below 0.5, found {poisson}");
            source.require(poisson < 0.5, "material.poisson", what, "0.3 for steel, 0.33 for aluminium")?;
        }
        let hardening = self.hardening(elastic, source)?;
        let stress = hardening.at(0.1).stress;
        let what = format!("the law has a yield stress of {stress:.3e} MPa at a strain of 0.1: no metal has");
        let help = format!("between {} and {} MPa; check the units of the constants", YIELD.start(), YIELD.end());
        source.require(YIELD.contains(&stress), HARDENING, what, help)?;
        let yield_criterion = self.yield_criterion(source)?;
        let rate = self.rate.map(|table| only(Rate::named(table), None, "material.rate", source)).transpose()?;
        let thermal = self.softening.map(|table| only(ThermalLaw::named(table), None, "material.softening", source));
        let thermal = thermal.transpose()?;
        let fracture = self.fracture.map(|table| only(Fracture::named(table), None, "material.fracture", source));
        let fracture = fracture.transpose()?;
        let alone = self.fracture_source.is_some() && fracture.is_none();
        let help = "add a criterion, such as [material.fracture.cockcroft_latham], or drop it";
        source.require(!alone, "material.fracture_source", "`fracture_source` stands without `fracture`", help)?;
        let mut gtn = self.voids;
        gtn.iter_mut().try_for_each(Gtn::prepare).map_err(|error| blame(error, "material.voids", source))?;
        let (fitted_up_to, chaboche) = (self.fitted_up_to.map(Dimensioned::value), self.back_stresses(source)?);
        let own = material::Material { fitted_up_to, elastic, rate, thermal, ..material::Material::plain(hardening) };
        Ok(material::Material { yield_criterion, chaboche, gtn, fracture, ..own })
    }

    /// r-values by direction, with a note on the mean that is taken.
    pub fn r_values(&self, source: &Source) -> Option<RValues> {
        let Some(Anisotropy::Directions(r)) = self.anisotropy else { return None };
        let [mean, r0, r45, r90, planar] =
            [r.mean(), r.r0, r.r45, r.r90, r.planar()].map(|r| Amount::number(r).to(Digits::Given(6)));
        source.note(format!(
            "r̄ = {mean}, the normal anisotropy: (r0 + 2 r45 + r90)/4 of {r0}, {r45} and {r90}; computed is the mean over the \
             directions, about which the rim has ears (Δr = {planar})"
        ));
        Some(r)
    }

    fn hardening(&self, elastic: Option<Elastic>, source: &Source) -> Result<Hardening> {
        let laws = self.hardening.clone().map_or(Vec::new(), Hardening::named);
        let names: Vec<String> = laws.iter().map(|law| format!("`{}`", law.name())).collect();
        if let Some(second) = laws.get(1) {
            let what = format!("the material has {} hardening laws: {}", names.len(), names.join(" and "));
            return Err(source.error(&format!("{HARDENING}.{}", second.name()), what, "keep one of them"));
        }
        let help = format!("write one of [{HARDENING}.…]: {}", Hardening::NAMES.join(", "));
        source.require(!laws.is_empty(), HARDENING, "the material has no hardening law", help)?;
        let law = only(laws, elastic.map(|elastic| elastic.young), HARDENING, source)?;
        Ok(self.strength.map_or(law.clone(), |factor| law.scaled(factor.value())))
    }

    fn yield_criterion(&self, source: &Source) -> Result<YieldCriterion> {
        let r = self.anisotropy.map_or(1.0, Anisotropy::mean);
        let hill = Hill48::checked(r).map_err(|error| blame(error, "material.anisotropy", source))?;
        let Some(YieldCondition::Hosford(hosford)) = self.yield_condition else { return Ok(hill.into()) };
        let path = "material.yield_condition.hosford";
        let both = hosford.crystal.is_some() && hosford.exponent.is_some();
        let what = "`crystal` and `exponent` both give the exponent";
        source.require(!both, &format!("{path}.exponent"), what, "keep one of them")?;
        let exponent = hosford.crystal.map(Crystal::exponent).or(hosford.exponent.map(Dimensioned::value));
        let what = "Hosford's condition needs its exponent, or the crystal that decides it";
        let help = "write crystal = \"fcc\" for aluminium, \"bcc\" for ferritic steel, or exponent = 8";
        let exponent = exponent.ok_or_else(|| source.error(path, what, help))?;
        let what = "the model of voids is made for Hill's condition, not for Hosford's";
        let help = "drop [material.voids], or write yield_condition = \"hill48\"";
        source.require(self.voids.is_none(), path, what, help)?;
        Ok(material::Hosford::checked(r, exponent).map_err(|error| blame(error, path, source))?.into())
    }

    fn back_stresses(&self, source: &Source) -> Result<BackStresses> {
        let mut chaboche = BackStresses::default();
        let (count, most) = (self.kinematic.len(), chaboche.len());
        let what = format!("{count} back-stresses are given, more than {most}");
        source.require(count <= most, "material.kinematic.2", what, "keep the two that matter")?;
        let known = count == 0 || self.mode == Some(Mode::ElastoViscoplastic);
        let help = "write mode = \"elasto_viscoplastic\", or drop it";
        source.require(known, "material.kinematic.0", "the flow law has no back-stresses", help)?;
        chaboche[..count].copy_from_slice(&self.kinematic);
        chaboche.iter_mut().for_each(|law| law.modulus *= self.strength.map_or(1.0, Dimensioned::value));
        Ok(chaboche)
    }
}

pub fn checked_mode(mode: Mode, material: &material::Material, path: &str, source: &Source) -> Result<Mode> {
    let flow = mode == Mode::Flow;
    let what = "an elastic sheet needs Young's modulus and Poisson's ratio";
    let help = "add young = \"210 GPa\" and poisson = 0.3 to [material]";
    source.require(flow || material.elastic.is_some(), path, what, help)?;
    let help = "drop [material.voids], or write mode = \"flow\"";
    source.require(flow || material.gtn.is_none(), path, "a sheet with voids has no elastic strains", help)?;
    Ok(mode)
}

/// The only law of a table, its parameters checked; `young` is Young's modulus of the sheet \[MPa\].
pub fn only<F: Family>(laws: Vec<F>, young: Option<f64>, path: &str, source: &Source) -> Result<F> {
    let [law] = <[F; 1]>::try_from(laws).map_err(|laws| not_one(laws.len(), path, &F::NAMES.join(", "), source))?;
    let name = law.name();
    law.prepared(young).map_err(|mut error| {
        error.message = format!("{name}: {}", error.message);
        blame(error, &format!("{path}.{name}"), source)
    })
}

pub fn blame(error: LawError, path: &str, source: &Source) -> CaseError {
    source.error(format!("{path}.{}", error.key).trim_end_matches('.'), error.message, error.help)
}

pub fn not_one(count: usize, path: &str, names: &str, source: &Source) -> CaseError {
    if count > 0 {
        return source.error(path, format!("[{path}] names more than one law"), "keep one of them");
    }
    let number = if path.contains("friction") { "write a coefficient, such as friction = 0.1, or " } else { "" };
    source.error(path, format!("[{path}] names no law"), format!("{number}give one of {names}, or drop [{path}]"))
}
