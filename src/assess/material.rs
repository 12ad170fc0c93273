//! Material data: sheet, tensile strength, yield condition, range of the hardening law.

use super::{estimate::tensile_strength, forming_limit::other_condition, *};
use crate::forming_limit::SHORTEST;
use crate::model::Zone;
use crate::units::ZERO_CELSIUS;

/// Tensile strengths of cold-formed sheet \[MPa\].
const STRENGTHS: [f64; 2] = [10.0, 3000.0];
/// Relative difference in thickness up to which numbers of another sheet are used \[–\]: above a mill's tolerance.
const NEAR: f64 = 0.1;
/// Strain that a hardening table should reach \[–\].
const FAR: f64 = 0.5;
/// Extrapolation in temperature without a warning \[K\].
const NEAR_ENOUGH: f64 = 10.0;
/// r̄ below which Hill's condition of 1948 is softer in biaxial stretching than aluminium \[–\].
const LEAST_R: f64 = 0.8;
/// r̄ above which Hill's condition is too strong: limiting draw ratios of 2.5 to 2.7, where Hosford has 2.3 to 2.4 \[–\].
const MOST_R: f64 = 1.3;
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
    let (sheet, t) = (case.sources.thickness.as_ref()?, case.model().blank.thickness);
    let [low, high] = sheet.range;
    (t < low * (1.0 - NEAR) || t > high * (1.0 + NEAR)).then(|| {
        let [low, high] = sheet.range.map(Amount::size);
        let range = if low == high { low.to_string() } else { format!("{low} to {high}") };
        let text = format!("{} was measured on sheet of {range}; this blank is {{}} thick", sheet.name);
        let warning = Finding::warning("sheet_thickness", "Material", text).number(Amount::size(t)).limit(range);
        let warning = warning.source("the library; the distance is a declared rule of thumb");
        warning.advice("take the numbers of a coil of this thickness, if there are some")
    })
}

pub(super) fn earlier(model: &Model) -> Option<Finding> {
    let (sheet, own) = (model.blank.preform.as_ref()?, model.material.describe());
    let text = format!("the sheet of {} is of {}; here it is of {own}", sheet.folder, sheet.material);
    let warning = Finding::warning("earlier_material", "Material", text).limit("that of the earlier run").source(OWN);
    let warning = warning.advice("write the same [material] in both cases");
    (!sheet.material.is_empty() && sheet.material != own).then_some(warning)
}

pub(super) fn is_weak(model: &Model) -> bool {
    tensile_strength(&model.material) < STRENGTHS[0] && model.material.rate.is_none()
}

pub(super) fn strength(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let text = "no sheet metal has a tensile strength of {}";
    let warning = Finding::warning("strength", "Tensile strength", text).number(Amount::stress(strength));
    let [least, most] = STRENGTHS;
    let warning = if is_weak(model) { warning.at_least(least, None) } else { warning.at_most(most, None) };
    warning.advice("check the unit of the law's stresses").if_beyond()
}

pub(super) fn short(model: &Model) -> Option<Finding> {
    let text = "the hardening table ends at a strain of {}; beyond it the law is extrapolated";
    let end = Amount::number(model.material.hardening.valid_up_to()?);
    Finding::warning("short_table", "Hardening law", text).number(end).at_least(FAR, None).if_beyond()
}

pub(super) fn yield_condition(run: &Run) -> Option<Finding> {
    let (criterion, last) = (run.case.model().material.yield_criterion, run.stages.last()?);
    last.steps.last()?;
    let r = criterion.ratio();
    let judged = |text: &str| Finding::judged("yield_condition", "Yield condition", text).number(Amount::number(r));
    let [least, most] = [LEAST_R, MOST_R].map(Amount::number);
    let judged = match criterion {
        YieldCriterion::Hosford(hosford) => {
            judged(&format!("Hosford, exponent {}, r̄ = {{}}", Amount::number(hosford.exponent())))
        }
        YieldCriterion::Hill48(_) if r < LEAST_R && is_biaxial(run, last) => {
            let text = "Hill 1948, r̄ = {}; too soft where the sheet is worst off, stretched both ways";
            judged(text).at_least(LEAST_R, None).advice(other_condition())
        }
        YieldCriterion::Hill48(_) if r > MOST_R => {
            let text = "Hill 1948, r̄ = {}; too strong in walls and where the sheet is stretched both ways";
            judged(text).at_most(MOST_R, None).advice(other_condition())
        }
        YieldCriterion::Hill48(_) => judged("Hill 1948, r̄ = {}"),
    };
    let source = "Woodthorpe and Pearce (1970); draw ratios of this program; the numbers are declared rules of thumb";
    let limit = format!("r̄ of {least} to {most} by Hill 1948; below, where the sheet is not stretched both ways");
    Some(judged.source(source).limit(limit))
}

fn is_biaxial(run: &Run, last: &StageSolution) -> bool {
    let thinnest = last.frames.last().and_then(|frame| {
        let thinnest = frame.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
        Some([thinnest.strain_meridional, thinnest.strain_hoop])
    });
    let nearest = run.nearest.as_ref().map(|nearest| {
        let worst = nearest.assessment.open().unwrap_or_else(|| nearest.assessment.worst());
        [worst.minor, worst.major]
    });
    thinnest.into_iter().chain(nearest).any(|[a, b]| a.min(b) > 0.0 && a.max(b) > SHORTEST)
}

pub(super) fn hardening(run: &Run) -> Option<Finding> {
    let material = &run.stages.last()?.model.material;
    let points = run.stages.iter().flat_map(|stage| stage.end.points.iter());
    let strain = Amount::ratio(points.map(|point| point.strain).fold(0.0, f64::max));
    let end = material.measured_up_to();
    let fit = end.map_or(String::new(), |end| format!(", fitted up to {}", Amount::number(end)));
    let judged = Finding::judged("hardening_range", "Hardening law", format!("strain of {{}}{fit}")).number(strain);
    Some(match end {
        None => judged
            .light(Light::Grey)
            .limit("a formula: the range of its fit is not in the case")
            .advice("write the range of the fit as `fitted_up_to` in [material]"),
        Some(end) if strain.value > end => judged
            .light(Light::Grey)
            .limit("no other light changes")
            .advice("without `--no-advice` it is solved with half the hardening"),
        Some(end) => judged.limit(format!("{} at most", Amount::number(end))),
    })
}

pub(super) fn placeholders(run: &Run) -> Option<Finding> {
    let text = format!("the case holds placeholders: {}", run.case.model().placeholders()?);
    let judged = Finding::judged("placeholders", "Placeholders", text).light(Light::Amber).limit("none");
    let advice = "replace them and take the note out; the rest of the verdict is of what was guessed";
    Some(judged.advice(advice).source(OWN))
}

pub(super) fn temperature(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    let celsius = |kelvin| Amount::temperature(kelvin - ZERO_CELSIUS);
    let [cold, hot] = stage.model.material.hardening.temperatures()?;
    let hottest = largest(stage, |step| step.hottest);
    let coldest = stage.steps.iter().map(|step| step.coldest).fold(f64::INFINITY, f64::min);
    if coldest >= cold - NEAR_ENOUGH && hottest <= hot + NEAR_ENOUGH {
        return None;
    }
    let limit = format!("{} to {}", celsius(cold), celsius(hot));
    let text = format!("hardening is given from {limit}; the sheet reaches {{}}, where the outermost curve is used");
    let warning = Finding::warning("temperature_range", "Hardening law", text).source(OWN);
    let warning = match hottest > hot {
        true => warning.number(celsius(hottest)).at_most(celsius(hot).value, None),
        false => warning.number(celsius(coldest)).at_least(celsius(cold).value, None),
    };
    Some(warning.limit(limit))
}

pub(super) fn idle_zone(model: &Model) -> Option<Finding> {
    let own = |zone: &&Zone| zone.material.as_ref().is_some_and(|metal| *metal != model.material);
    let is_idle = |zone: &&Zone| zone.thickness == model.blank.thickness && !own(zone);
    let [from, to] = model.blank.zones.iter().find(is_idle)?.within.map(Amount::set);
    let text = format!("the zone from {from} to {to} is as the rest of the blank: it changes nothing");
    let warning = Finding::warning("idle_zone", "Zone", text).limit("unlike the blank").source("blank.zones");
    Some(warning.advice("give it a thickness or a hardening of its own, or drop it"))
}
