//! What a user should know before trusting a result.

use super::distance_blocks;
use super::process::Process;
use super::termination::neck;
use crate::model::{ContactMethod, Mode, Model};
use crate::numerics::lobatto;
use crate::solution::{StageSolution, Stop};
use crate::state::State;
use crate::units::ZERO_CELSIUS;

/// Power balance that a user should be able to rely on \[–\].
pub(crate) const LARGEST_IMBALANCE: f64 = 0.01;
/// A run whose steps strain the sheet by less in all forms nothing: shares of its work say nothing \[–\].
const FORMED: f64 = 2e-3;
/// Penetration that would show in the result, over the thickness \[–\].
pub(crate) const LARGEST_PENETRATION: f64 = 0.05;
/// Plastic power in cut-off zones that puts stresses in doubt \[–\].
pub(crate) const LARGEST_CUT_OFF: f64 = 0.05;

/// Thickness over the initial one that no sheet metal, superplastic alloys apart, is drawn to in one piece \[–\].
const TORN: f64 = 0.5;
/// How far a temperature may lie beyond the curves given without a word \[K\].
const NEAR_ENOUGH: f64 = 10.0;
/// Squeeze between two tools from which the sheet is ironed \[–\].
pub(crate) const IRONED: f64 = 0.01;
/// Plastic strain, or stress over the yield stress, from which a point has yielded again \[–\].
const YIELDED: f64 = 1e-4;
/// Lift of the holder over the thickness that is worth a word \[–\].
pub(crate) const LIFTED: f64 = 0.3;

/// What a user should know before trusting the result.
pub(super) fn warnings(process: &Process, state: &State, run: &StageSolution) -> Vec<String> {
    let model = process.model;
    let mut warnings = Vec::new();
    let Some(last) = run.steps.last() else { return warnings };
    warnings.extend(thinned(model, state, run));
    let largest = |value: fn(&crate::solution::StepRecord) -> f64| run.steps.iter().map(value).fold(0.0, f64::max);
    let formed = formed(run);
    let imbalance = last.work.imbalance();
    if formed && imbalance.abs() > LARGEST_IMBALANCE {
        warnings.push(format!(
            "the power balance misses {:.2} % of the external work: take smaller steps (solver.max_step)",
            100.0 * imbalance
        ));
    }
    let deepest = largest(|r| r.penetration);
    if deepest > LARGEST_PENETRATION {
        warnings.push(format!(
            "a tool penetrates the sheet by {:.1} % of its thickness: raise solver.contact_stiffness",
            100.0 * deepest
        ));
    }
    if formed && last.work.cutoff > LARGEST_CUT_OFF * last.work.plastic {
        warnings.push(format!(
            "{:.1} % of the plastic work is done where the strain rate is cut off: stresses there are not the true ones",
            100.0 * last.work.cutoff / last.work.plastic
        ));
    }
    let strain = state.points.iter().map(|p| p.strain).fold(0.0, f64::max);
    if let Some(end) = model.material.hardening.valid_up_to().filter(|&end| strain > end) {
        warnings.push(format!(
            "the hardening table ends at a strain of {end:.3}; the run reaches {strain:.3} on its extrapolation"
        ));
    }
    if let Some([cold, hot]) = model.material.hardening.temperatures() {
        let hottest = largest(|r| r.hottest);
        let coldest = run.steps.iter().map(|r| r.coldest).fold(f64::INFINITY, f64::min);
        if coldest < cold - NEAR_ENOUGH || hottest > hot + NEAR_ENOUGH {
            let celsius = |kelvin: f64| kelvin - ZERO_CELSIUS;
            warnings.push(format!(
                "hardening is given from {:.0} to {:.0} °C; the sheet has {:.0} to {:.0} °C, and the outermost curves are \
                 held beyond",
                celsius(cold),
                celsius(hot),
                celsius(coldest),
                celsius(hottest)
            ));
        }
    }
    if let Some(first) = run.steps.iter().find(|r| r.ironing > IRONED) {
        warnings.push(format!(
            "ironing from {:.2} mm of travel: the sheet is up to {:.1} % thicker than the gap between two tools; it is \
             pressed with a stiffness of {:.0} MPa over half its thickness on either face and not thinned by it, so forces \
             there are an indication only",
            first.travel,
            100.0 * largest(|r| r.ironing),
            model.settings.contact_stiffness
        ));
    }
    if let Some(asked) = model.stop.contact_share.filter(|_| !matches!(run.stop, Stop::ContactShare { .. })) {
        warnings.push(format!(
            "{:.1} % of the sheet lies on its tools at the end, not the {:.1} % that were to end the run: more time, travel or \
             pressure gets further",
            100.0 * last.contact_share,
            100.0 * asked
        ));
    }
    let lifted = largest(|r| -r.holder_move) / model.blank.thickness;
    if lifted > LIFTED {
        warnings.push(format!(
            "the holder was lifted by up to {lifted:.2} thicknesses as the flange thickened or rose under it"
        ));
    }
    warnings.extend(distance_blocks::rests(model.travel, &run.steps));
    if model.settings.contact == ContactMethod::AugmentedLagrangian
        && deepest > 1.01 * crate::model::Settings::PENETRATION
    {
        warnings.push(format!("the augmented Lagrangian left a penetration of {deepest:.1e} thicknesses"));
    }
    for (role, travel) in process.released() {
        warnings.push(format!(
            "the sheet left the {tool} at {travel:.2} mm of travel; the {tool} stands still from there on",
            tool = role.name()
        ));
    }
    warnings
}

/// Whether the run strains the sheet enough for shares of its work to say something.
pub(crate) fn formed(run: &StageSolution) -> bool {
    run.steps.iter().map(|r| r.strain_increment).sum::<f64>() > FORMED
}

/// A neck, or a sheet that is too thin to be whole; a run that ended by it has said so.
pub(crate) fn thinned(model: &Model, state: &State, run: &StageSolution) -> Option<String> {
    if matches!(run.stop, Stop::Localised { .. } | Stop::Coalesced { .. }) {
        return None;
    }
    let neck = neck(model, state, None);
    let (place, left) = (neck.s0, 100.0 * neck.share);
    if neck.stands_out {
        return Some(format!(
            "thinning has localised at s0 = {place:.1} mm, down to {left:.0} % of the thickness: the sheet tears there, and \
             what is computed after that depends on the mesh"
        ));
    }
    let superplastic = model.material.rate.is_some_and(|rate| rate.is_superplastic());
    (neck.share < TORN && !superplastic)
        .then(|| format!("the sheet is down to {left:.0} % of its thickness at s0 = {place:.1} mm: it has torn before"))
}

/// How much of the sheet yields again, the other way, while its tools are taken away; `before` is ε̄ of its layers then.
/// By D(E, ν) alone that is where the stress that is left lies beyond the yield stress.
pub(super) fn yielded_again(model: &Model, before: &[f64], state: &State) -> Option<String> {
    model.release?;
    let rule = lobatto::rule(model.blank.layers);
    let (mut volume, mut total) = (0.0, 0.0);
    for (i, (point, before)) in state.points.iter().zip(before).enumerate() {
        let (e, k) = (i / rule.len(), i % rule.len());
        let share = state.volume[e] * rule[k].weight;
        let limit = model.material.yield_stress(point.strain, state.temperature[e]);
        let beyond = model.mode != Mode::ElastoViscoplastic
            && model.material.anisotropy.equivalent_stress(point.stress) > limit * (1.0 + YIELDED);
        total += share;
        volume += if beyond || point.strain - before > YIELDED { share } else { 0.0 };
    }
    let share = 100.0 * volume / total;
    let what = match model.mode {
        Mode::Elastic => "would yield again as the tools are taken away, which D(E, ν) alone leaves out",
        _ => "yields again as the tools are taken away",
    };
    (share > 0.1).then(|| format!("{share:.1} % of the sheet {what}"))
}
