//! Yield condition in biaxial stretching.

use super::forming_limit::other_condition;
use super::tear::tear_sentence;
use super::{Finding, Run};
use crate::case::file::Crystal;
use crate::forming_limit::SHORTEST;
use crate::material::{Hosford, YieldCriterion};
use crate::model::Stage;
use crate::solver::solution::{StageSolution, StopKind};
use crate::solver::solve;
use crate::units::{Amount, joined};

/// r̄ below which Hill's condition of 1948 is softer in biaxial stretching than aluminium \[–\].
const LEAST: f64 = 0.8;
/// Crystal of sheets of such low r̄: aluminium.
const CRYSTAL: Crystal = Crystal::Fcc;

/// Amber if a low r̄ goes by Hill's condition and the worst place is stretched both ways; then with the result by Hosford's
/// condition.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let criterion = run.case.model().material.yield_criterion;
    let (r, last) = (criterion.ratio(), run.stages.last()?);
    last.steps.last()?;
    let doubtful = matches!(criterion, YieldCriterion::Hill48(_)) && r < LEAST && is_biaxial(run, last);
    let name = match criterion {
        YieldCriterion::Hill48(_) => "Hill 1948, r̄ = {}".to_owned(),
        YieldCriterion::Hosford(hosford) => {
            format!("Hosford, exponent {}, r̄ = {{}}", Amount::number(hosford.exponent()))
        }
    };
    let soft = || "too soft where the sheet is worst off, stretched both ways".to_owned();
    let text = match doubtful {
        true => joined([Some(name), Some(soft()), by_hosford(run)].into_iter().flatten(), "; "),
        false => name,
    };
    let least = Amount::number(LEAST);
    let limit = format!("r̄ of {least} and more by Hill 1948, where the sheet is stretched both ways");
    let finding = Finding::judged("yield_condition", "Yield condition", text)
        .number(Amount::number(r))
        .source("Woodthorpe and Pearce (1970), not read; the number is a declared rule of thumb");
    Some(if doubtful { finding.at_least(limit, LEAST, None).advice(other_condition()) } else { finding.limit(limit) })
}

/// Whether the thinnest place, or the one nearest to the forming limit, is stretched both ways.
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

/// Result by Hosford's condition of fcc metal, all else alike; `None` if it cannot be solved, or the run was interrupted.
fn by_hosford(run: &Run) -> Option<String> {
    if run.is_one_of_many || run.stages.last()?.stop.kind == StopKind::Interrupted {
        return None;
    }
    let stages: Vec<Stage> = run.case.stages.iter().cloned().map(with_hosford).collect();
    let solved = solve(&stages, &mut ());
    let end = solved.last()?.steps.last()?;
    Some(format!(
        "with Hosford's condition of fcc metal, exponent {}, it thins by {} at s0 = {}, and {}",
        Amount::number(CRYSTAL.exponent()),
        Amount::share(1.0 - end.thinnest / run.case.model().blank.thickness),
        Amount::place(end.thinnest_s0),
        tear_sentence(&solved)
    ))
}

fn with_hosford(mut stage: Stage) -> Stage {
    let material = &mut stage.model.material;
    material.yield_criterion = Hosford::new(material.yield_criterion.ratio(), CRYSTAL.exponent()).into();
    stage.model.forming_limit = stage.model.forming_limit.and_then(|curve| curve.of_material(material).ok());
    stage
}
