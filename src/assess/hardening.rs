//! How far the hardening law is used beyond what it was measured for.

use super::run::{Run, largest};
use super::{Finding, Light};
use crate::model::Model;
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::Amount;
use crate::units::ZERO_CELSIUS;

/// Strain at which a table should not have ended \[–\]: draws strain the sheet by as much.
const FAR: f64 = 0.5;
/// How far a temperature may lie beyond the curves given without a word \[K\].
const NEAR_ENOUGH: f64 = 10.0;

const OWN: &str = "the case's material";

/// A table that ends at a small strain.
pub(super) fn short(model: &Model) -> Option<Finding> {
    let strain = model.material.hardening.valid_up_to().filter(|strain| *strain < FAR)?;
    let found = format!(
        "the hardening table ends at a strain of {strain}; beyond it the law is extrapolated",
        strain = Amount::number(strain)
    );
    let limit = format!("{limit} at least", limit = Amount::number(FAR));
    let warning = Finding::warning("short_table", "Hardening law", found);
    Some(warning.against(strain, Unit::None, limit).at_least(FAR, None))
}

/// The largest equivalent strain of a layer.
fn reached(stage: &StageSolution) -> f64 {
    stage.end.points.iter().map(|point| point.strain).fold(0.0, f64::max)
}

/// The largest equivalent strain of a layer, against the last point of a table or the range of a fit; a formula alone does not
/// say its range.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let strain = run.stages.iter().map(reached).fold(0.0, f64::max);
    let material = &last.model.material;
    let range = material.measured_up_to();
    let (light, limit, advice) = match range {
        Some(end) => (
            Light::within(strain, end),
            match material.fitted_up_to {
                Some(_) => format!("it is fitted up to {end}", end = Amount::number(end)),
                None => format!("its table ends at {end}", end = Amount::number(end)),
            },
            "points at larger strains, from a bulge test; else the stress is extrapolated",
        ),
        None => (
            Light::Grey,
            "a formula: the range of its fit is not in the case".into(),
            "write the range of the fit as [material] fitted_up_to; the law's source has it",
        ),
    };
    let found = format!("used up to a true strain of {strain}", strain = Amount::strain(strain));
    let judged = Finding::judged("hardening_range", "Hardening law", light, found).against(strain, Unit::None, limit);
    let judged = if range.is_some() { judged.at_most(range, None) } else { judged };
    Some(judged.source(OWN).advice(advice))
}

/// A stage that strains the sheet beyond the last point of its table, or the range of its law's fit.
pub(super) fn beyond(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    let strain = reached(stage);
    let material = &stage.model.material;
    let end = material.measured_up_to().filter(|end| strain > *end)?;
    let [to, reached] = [Amount::number(end), Amount::strain(strain)];
    let found = match material.fitted_up_to {
        Some(_) => format!(
            "the hardening law is fitted up to a strain of {to}; the run reaches {reached} on its extrapolation"
        ),
        None => format!("the hardening table ends at a strain of {to}; the run reaches {reached} on its extrapolation"),
    };
    Some(
        Finding::warning("extrapolated", "Hardening law", found)
            .against(strain, Unit::None, Amount::number(end))
            .at_most(end, None)
            .source(OWN),
    )
}

/// A sheet that is colder or hotter than its curves.
pub(super) fn other_temperatures(stage: &StageSolution) -> Option<Finding> {
    stage.steps.last()?;
    let [cold, hot] = stage.model.material.hardening.temperatures()?;
    let hottest = largest(stage, |step| step.hottest);
    let coldest = stage.steps.iter().map(|step| step.coldest).fold(f64::INFINITY, f64::min);
    (coldest < cold - NEAR_ENOUGH || hottest > hot + NEAR_ENOUGH).then(|| {
        let [cold, hot, coldest, hottest] = [cold, hot, coldest, hottest].map(|kelvin| kelvin - ZERO_CELSIUS);
        let [low, high] = [cold, hot].map(Amount::temperature);
        let found = format!("hardening is given from {low} to {high}; the sheet has {coldest} to {hottest}, and the outermost curves are held \
             beyond", coldest = Amount::temperature(coldest), hottest = Amount::temperature(hottest));
        let limit = format!("{low} to {high}");
        let warning = Finding::warning("temperature_range", "Hardening law", found);
        let warning = match hottest > hot {
            true => warning.against(hottest, Unit::Celsius, limit).at_most(hot, None),
            false => warning.against(coldest, Unit::Celsius, limit).at_least(cold, None),
        };
        warning.source(OWN)
    })
}
