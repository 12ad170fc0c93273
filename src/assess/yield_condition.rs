//! Whether the sheet's yield condition says what biaxial stretching asks of it.

use super::answer::whether_it_tears;
use super::forming_limit::other_condition;
use super::{Finding, Light, run::Run};
use crate::case::file::Crystal;
use crate::forming_limit::SHORTEST;
use crate::material::{Hosford, YieldCriterion};
use crate::model::Stage;
use crate::solver::solution::{StageSolution, Stop};
use crate::solver::solve;
use crate::table::Unit;
use crate::units::{Amount, joined};

/// r̄ from which on Hill's condition of 1948 is taken at its word in biaxial stretching \[–\]: below it is softer there than
/// aluminium is.
const LEAST: f64 = 0.8;
/// What the other answer is computed with: sheets of such low r̄ are of aluminium.
const CRYSTAL: Crystal = Crystal::Fcc;

/// Amber where a low r̄ goes by Hill's condition and the thinnest place, or the one nearest to the forming limit, is
/// stretched both ways; then with what Hosford's condition says of the same case.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let criterion = run.case.model().material.yield_criterion;
    let (r, last) = (criterion.ratio(), run.stages.last()?);
    last.steps.last()?;
    let doubtful = matches!(criterion, YieldCriterion::Hill48(_)) && r < LEAST && is_biaxial(run, last);
    let name = match criterion {
        YieldCriterion::Hill48(_) => format!("Hill 1948, r̄ = {r}", r = Amount::number(r)),
        YieldCriterion::Hosford(hosford) => {
            format!("Hosford, exponent {a}, r̄ = {r}", a = Amount::number(hosford.exponent()), r = Amount::number(r))
        }
    };
    let found = match doubtful {
        true => {
            let soft = "too soft where the sheet is worst off, stretched both ways".into();
            joined([Some(name), Some(soft), other(run)].into_iter().flatten(), "; ")
        }
        false => name,
    };
    let limit = format!(
        "r̄ of {least} and more by Hill 1948, where the sheet is stretched both ways",
        least = Amount::number(LEAST)
    );
    let finding = Finding::judged("yield_condition", "Yield condition", Light::doubtful(doubtful), found)
        .against(r, Unit::None, limit)
        .source("Woodthorpe and Pearce (1970), not read; the number is a declared rule of thumb");
    // With another condition, or without biaxial stretching, any r̄ will do.
    Some(if doubtful { finding.at_least(LEAST, None).advice(other_condition()) } else { finding })
}

/// Whether the thinnest place, or that which comes nearest to the forming limit, is stretched both ways.
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

/// What comes out with Hosford's condition of fcc metal, all else alike; `None` where it cannot be solved, as with voids, or
/// the user has had enough.
fn other(run: &Run) -> Option<String> {
    if run.is_one_of_many || matches!(run.stages.last()?.stop, Stop::Interrupted { .. }) {
        return None;
    }
    let stages: Vec<Stage> = run.case.stages.iter().cloned().map(with_hosford).collect();
    let solved = solve(&stages, &mut ());
    let end = solved.last()?.steps.last()?;
    Some(format!(
        "with Hosford's condition of fcc metal, exponent {a}, it thins by {thinning} at s0 = {s0}, and {tears}",
        a = Amount::number(CRYSTAL.exponent()),
        thinning = Amount::share(1.0 - end.thinnest / run.case.model().blank.thickness),
        s0 = Amount::place(end.thinnest_s0),
        tears = whether_it_tears(&solved)
    ))
}

/// The stage with the other condition, and the forming limit that follows from it; none where it has none.
fn with_hosford(mut stage: Stage) -> Stage {
    let material = &mut stage.model.material;
    material.yield_criterion = Hosford::new(material.yield_criterion.ratio(), CRYSTAL.exponent()).into();
    stage.model.forming_limit = stage.model.forming_limit.and_then(|curve| curve.of_material(material).ok());
    stage
}
