//! `[material]`: elastic constants and exactly one hardening law.

use crate::case::file::{self, Anisotropy, Crystal, YieldCondition};
use crate::case::{CaseError, source::Source};
use crate::material::hardening::HardeningTable;
use crate::material::law::{Family, LawError};
use crate::material::{
    BackStress, BackStresses, Elastic, Hardening, Hill48, Hosford, Material, RValues, Rate, ThermalLaw, YieldCriterion,
};
use crate::model::Mode;
use crate::units::{Amount, Digits, Dimensioned};
use std::ops::RangeInclusive;

const HARDENING: &str = "material.hardening";
/// Yield stress at 10 % strain, from hot superplastic alloys far below to piano wire far above \[MPa\].
const YIELD: RangeInclusive<f64> = 0.1..=1e5;

pub(in crate::case) fn convert(file: &file::Material, source: &Source) -> Result<Material, CaseError> {
    let elastic = match (file.young, file.poisson) {
        (None, None) => None,
        (Some(young), Some(poisson)) => Some(Elastic { young: young.value(), poisson: poisson.value() }),
        (Some(_), None) => return Err(source.missing("material", "poisson")),
        (None, Some(_)) => return Err(source.missing("material", "young")),
    };
    if let Some(Elastic { poisson, .. }) = elastic {
        let what = format!("`poisson` must be below 0.5, found {poisson}");
        source.require(poisson < 0.5, "material.poisson", what, "0.3 for steel, 0.33 for aluminium")?;
    }
    let hardening = hardening(file.hardening.clone(), elastic, source)?;
    let stress = hardening.at(0.1).stress;
    let what = format!("the law has a yield stress of {stress:.3e} MPa at a strain of 0.1: no metal has");
    let help = format!("between {} and {} MPa; check the units of the constants", YIELD.start(), YIELD.end());
    source.require(YIELD.contains(&stress), HARDENING, what, help)?;
    let yield_criterion = yield_criterion(file, source)?;
    let rate = file.rate.map(|table| only(Rate::named(table), "material.rate", source)).transpose()?;
    let thermal =
        file.softening.map(|table| only(ThermalLaw::named(table), "material.softening", source)).transpose()?;
    let mut gtn = file.voids;
    if let Some(gtn) = &mut gtn {
        gtn.prepare().map_err(|error| blame(error, "material.voids", source))?;
    }
    Ok(Material {
        hardening,
        fitted_up_to: file.fitted_up_to.map(Dimensioned::value),
        elastic,
        rate,
        thermal,
        yield_criterion,
        chaboche: chaboche(&file.kinematic, file.mode, source)?,
        gtn,
    })
}

/// Yield criterion from r̄ and the curve.
fn yield_criterion(file: &file::Material, source: &Source) -> Result<YieldCriterion, CaseError> {
    let r = file.anisotropy.map_or(1.0, Anisotropy::mean);
    let hill = Hill48::checked(r).map_err(|error| blame(error, "material.anisotropy", source))?;
    let Some(YieldCondition::Hosford(hosford)) = file.yield_condition else { return Ok(hill.into()) };
    let path = "material.yield_condition.hosford";
    let both = hosford.crystal.is_some() && hosford.exponent.is_some();
    source.require(
        !both,
        &format!("{path}.exponent"),
        "`crystal` and `exponent` both give the exponent",
        "keep one of them",
    )?;
    let exponent = hosford.crystal.map(Crystal::exponent).or(hosford.exponent.map(Dimensioned::value));
    let exponent = exponent.ok_or_else(|| {
        let what = "Hosford's condition needs its exponent, or the crystal that decides it";
        source.error(path, what, "write crystal = \"fcc\" for aluminium, \"bcc\" for ferritic steel, or exponent = 8")
    })?;
    let what = "the model of voids is made for Hill's condition, not for Hosford's";
    let help = "drop [material.voids], or write yield_condition = \"hill48\"";
    source.require(file.voids.is_none(), path, what, help)?;
    Ok(Hosford::checked(r, exponent).map_err(|error| blame(error, path, source))?.into())
}

/// At most two back-stresses, of a sheet in the elasto-viscoplastic mode.
fn chaboche(file: &[BackStress], mode: Option<Mode>, source: &Source) -> Result<BackStresses, CaseError> {
    let mut chaboche = BackStresses::default();
    let most = chaboche.len();
    let what = format!("{} back-stresses are given, more than {most}", file.len());
    source.require(file.len() <= most, "material.kinematic.2", what, "keep the two that matter")?;
    let known = file.is_empty() || mode == Some(Mode::ElastoViscoplastic);
    let help = "write mode = \"elasto_viscoplastic\", or drop it";
    source.require(known, "material.kinematic.0", "the flow law has no back-stresses", help)?;
    chaboche[..file.len()].copy_from_slice(file);
    Ok(chaboche)
}

/// Checks that the material has the constants of a mode.
pub(super) fn mode(mode: Mode, material: &Material, path: &str, source: &Source) -> Result<Mode, CaseError> {
    let flow = mode == Mode::Flow;
    let what = "an elastic sheet needs Young's modulus and Poisson's ratio";
    let help = "add young = \"210 GPa\" and poisson = 0.3 to [material]";
    source.require(flow || material.elastic.is_some(), path, what, help)?;
    let help = "drop [material.voids], or write mode = \"flow\"";
    source.require(flow || material.gtn.is_none(), path, "a sheet with voids has no elastic strains", help)?;
    Ok(mode)
}

/// Hardening law, exactly one.
fn hardening(file: Option<HardeningTable>, elastic: Option<Elastic>, source: &Source) -> Result<Hardening, CaseError> {
    let laws = match <[_; 1]>::try_from(file.map_or(Vec::new(), Hardening::named)) {
        Ok([law]) => return prepared(law, elastic.map(|e| e.young), HARDENING, source),
        Err(laws) => laws,
    };
    let names: Vec<&str> = laws.iter().map(Family::name).collect();
    let Some(second) = names.get(1) else {
        let help = format!("write one of [{HARDENING}.…]: {}", Hardening::NAMES.join(", "));
        return Err(source.error(HARDENING, "the material has no hardening law", help));
    };
    let listed: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let what = format!("the material has {} hardening laws: {}", names.len(), listed.join(" and "));
    Err(source.error(&format!("{HARDENING}.{second}"), what, "keep one of them"))
}

/// Note on r-values by direction: the mean that is taken.
pub(in crate::case) fn mean_of(r: RValues) -> String {
    let [mean, r0, r45, r90, planar] =
        [r.mean(), r.r0, r.r45, r.r90, r.planar()].map(|r| Amount::number(r).to(Digits::Given(6)));
    format!(
        "r̄ = {mean}, the normal anisotropy: (r0 + 2 r45 + r90)/4 of {r0}, {r45} and {r90}; computed is the mean over the \
         directions, about which the rim has ears (Δr = {planar})"
    )
}

/// Law of a table that must name exactly one, ready for use.
pub(super) fn only<F: Family>(laws: Vec<F>, path: &str, source: &Source) -> Result<F, CaseError> {
    match <[F; 1]>::try_from(laws) {
        Ok([law]) => prepared(law, None, path, source),
        Err(laws) => Err(not_one(laws.len(), path, &F::NAMES.join(", "), source)),
    }
}

/// Law made ready for use.
fn prepared<F: Family>(law: F, young: Option<f64>, path: &str, source: &Source) -> Result<F, CaseError> {
    let name = law.name();
    law.prepared(young).map_err(|mut error| {
        error.message = format!("{name}: {}", error.message);
        blame(error, &format!("{path}.{name}"), source)
    })
}

/// Error of a law, shown at its key.
pub(super) fn blame(error: LawError, path: &str, source: &Source) -> CaseError {
    source.error(format!("{path}.{}", error.key).trim_end_matches('.'), error.message, error.help)
}

/// Error of a table that must name exactly one law.
pub(super) fn not_one(count: usize, path: &str, names: &str, source: &Source) -> CaseError {
    if count > 0 {
        return source.error(path, format!("[{path}] names more than one law"), "keep one of them");
    }
    let number = if path.contains("friction") { "write a coefficient, such as friction = 0.1, or " } else { "" };
    let help = format!("{number}give one of {names}, or drop [{path}]");
    source.error(path, format!("[{path}] names no law"), help)
}
