//! Material data: sheet, tensile strength, range of the hardening law.

use super::estimate::tensile_strength;
use super::{Finding, Light, Run, largest};
use crate::case::Case;
use crate::model::Model;
use crate::solver::solution::StageSolution;
use crate::units::{Amount, ZERO_CELSIUS};

/// Tensile strengths of cold-formed sheet \[MPa\].
const STRENGTHS: [f64; 2] = [10.0, 3000.0];
/// Relative difference in thickness up to which numbers of another sheet are used \[–\]: above a mill's tolerance.
const NEAR: f64 = 0.1;
/// Strain that a hardening table should reach \[–\].
const FAR: f64 = 0.5;
/// Extrapolation in temperature without a warning \[K\].
const NEAR_ENOUGH: f64 = 10.0;
const OWN: &str = "the case's material";

pub(super) fn mixed(case: &Case) -> Option<Finding> {
    let sheets = case.sources.sheets.as_ref()?;
    let library = sheets.library.clone();
    let own = sheets.case.as_ref().map_or_else(|| "this case".to_owned(), |source| format!("this case ({source})"));
    let (hardening, anisotropy) = if sheets.own_hardening { (own, library) } else { (library, own) };
    let text = format!("hardening of {hardening} with r̄ = {{}} of {anisotropy}: no sheet has both");
    let warning = Finding::warning("two_sheets", "Material", text).number(Amount::number(sheets.anisotropy));
    Some(warning.advice("take one sheet: --material NAME, or [material] with `name` alone"))
}

pub(super) fn thickness(case: &Case) -> Option<Finding> {
    let of = case.sources.thickness.as_ref()?;
    let t = case.model().blank.thickness;
    let [low, high] = of.range;
    (t < low * (1.0 - NEAR) || t > high * (1.0 + NEAR)).then(|| {
        let range = match of.range.map(Amount::size) {
            [one, other] if one == other => one.to_string(),
            [low, high] => format!("{low} to {high}"),
        };
        let text = format!("{} was measured on sheet of {range}; this blank is {{}} thick", of.name);
        Finding::warning("sheet_thickness", "Material", text)
            .number(Amount::size(t))
            .limit(range)
            .source("the library; the distance is a declared rule of thumb")
            .advice("take the numbers of a coil of this thickness, if there are some")
    })
}

/// Whether the sheet is weaker than any; hot sheet, whose stress depends on the rate, may be.
pub(super) fn is_weak(model: &Model) -> bool {
    tensile_strength(&model.material) < STRENGTHS[0] && model.material.rate.is_none()
}

pub(super) fn strength(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let too_strong = strength > STRENGTHS[1];
    if !too_strong && !is_weak(model) {
        return None;
    }
    let [low, high] = STRENGTHS.map(Amount::given_stress);
    let limit = format!("{low} to {high}");
    let warning = Finding::warning("strength", "Tensile strength", "no sheet metal has a tensile strength of {}");
    let warning = warning.number(Amount::stress(strength));
    let warning = match too_strong {
        true => warning.at_most(limit, STRENGTHS[1], None),
        false => warning.at_least(limit, STRENGTHS[0], None),
    };
    Some(warning.advice("check the unit of the law's stresses"))
}

pub(super) fn short(model: &Model) -> Option<Finding> {
    let strain = model.material.hardening.valid_up_to()?;
    let text = "the hardening table ends at a strain of {}; beyond it the law is extrapolated";
    let warning = Finding::warning("short_table", "Hardening law", text).number(Amount::number(strain));
    warning.at_least(format!("{} at least", Amount::number(FAR)), FAR, None).if_beyond()
}

/// Largest equivalent strain of a stage \[–\].
fn reached(stage: &StageSolution) -> f64 {
    stage.end.points.iter().map(|point| point.strain).fold(0.0, f64::max)
}

pub(super) fn hardening(run: &Run) -> Option<Finding> {
    let material = &run.stages.last()?.model.material;
    let strain = run.stages.iter().map(reached).fold(0.0, f64::max);
    let judged = Finding::judged("hardening_range", "Hardening law", "used up to a true strain of {}").source(OWN);
    let judged = judged.number(Amount::ratio(strain));
    let ends = if material.fitted_up_to.is_some() { "it is fitted up to" } else { "its table ends at" };
    Some(match material.measured_up_to() {
        None => judged
            .light(Light::Grey)
            .limit("a formula: the range of its fit is not in the case")
            .advice("write the range of the fit as [material] fitted_up_to"),
        Some(end) => judged
            .at_most(format!("{ends} {}", Amount::number(end)), end, None)
            .advice("add points at larger strains, from a bulge test"),
    })
}

pub(super) fn extrapolated(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    let strain = reached(stage);
    let material = &stage.model.material;
    let end = material.measured_up_to()?;
    let to = Amount::number(end);
    let range = if material.fitted_up_to.is_some() { "law is fitted up to" } else { "table ends at" };
    let text = format!("the hardening {range} a strain of {to}; the run extrapolates it to {{}}");
    let warning = Finding::warning("extrapolated", "Hardening law", text).number(Amount::ratio(strain));
    warning.at_most(to, end, None).source(OWN).if_beyond()
}

pub(super) fn temperature(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    let [cold, hot] = stage.model.material.hardening.temperatures()?;
    let hottest = largest(stage, |step| step.hottest);
    let coldest = stage.steps.iter().map(|step| step.coldest).fold(f64::INFINITY, f64::min);
    if coldest >= cold - NEAR_ENOUGH && hottest <= hot + NEAR_ENOUGH {
        return None;
    }
    let [cold, hot, coldest, hottest] =
        [cold, hot, coldest, hottest].map(|kelvin| Amount::temperature(kelvin - ZERO_CELSIUS));
    let limit = format!("{cold} to {hot}");
    let text = format!("hardening is given from {limit}; the sheet reaches {{}}, where the outermost curve is used");
    let warning = Finding::warning("temperature_range", "Hardening law", text).source(OWN);
    Some(match hottest.value > hot.value {
        true => warning.number(hottest).at_most(limit, hot.value, None),
        false => warning.number(coldest).at_least(limit, cold.value, None),
    })
}
