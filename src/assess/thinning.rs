//! How thin the sheet has become.

use super::nearest::Nearest;
use super::nose::NoseEnd;
use super::{Finding, Light, run::Run, wrinkling};
use crate::measure::{Band, place_on_part};
use crate::model::{Edge, Geometry, Role};
use crate::solver::solution::StageSolution;
use crate::table::Unit;
use crate::units::Amount;

/// Thinning that a designer looks at twice, and that is refused without a forming limit that allows it \[–\].
const LIMITS: [f64; 2] = [CAREFUL, 0.30];
/// The first of them \[–\].
pub(super) const CAREFUL: f64 = 0.20;

/// What makes a sheet thin less at a place, initially `s0` from the axis \[mm\]: over a round punch the pole is spared by
/// friction that holds it, at a nose by whatever lets the flange come. A flange or a wall that may wrinkle is not let loose.
pub(super) fn advice(run: &Run, stage: &StageSolution, s0: f64) -> String {
    let model = &stage.model;
    if model.tool(Role::Punch).is_none() {
        return "a smaller height, a larger die shoulder or a thicker sheet".into();
    }
    if model.blank.edge == Edge::Clamped {
        return "a shorter travel, larger radii, or an edge that is let in".into();
    }
    let on_dome = || match place_on_part(stage, s0) {
        Some(place) => matches!(place.band, Band::Dome | Band::Unsupported),
        None => false,
    };
    let is_round = model.geometry == Geometry::Axisymmetric && (on_dome() || NoseEnd::of(stage).is_none());
    let holder = model.tool(Role::Holder).is_some() && !wrinkling::wants_holding(run);
    match (is_round, holder) {
        (true, true) => {
            "a smaller blank, less holder force, less friction at die and holder but more at the punch (no oil there)"
        }
        (true, false) => "a smaller blank, less friction at die and holder but more at the punch (no oil there)",
        (false, true) => {
            "a larger punch nose or die shoulder, a smaller blank, less holder force or friction at die and holder"
        }
        (false, false) => "a larger punch nose or die shoulder, a smaller blank, less friction at die and holder",
    }
    .into()
}

/// The least thickness of the last stage over that of the blank.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?.steps.last()?;
    let thinning = 1.0 - last.thinnest / run.case.model().blank.thickness;
    // A forming limit that is kept, or a metal that stretches without a neck, allows more.
    let allowed = run.nearest.as_ref().is_some_and(Nearest::is_kept)
        || run.case.model().material.rate.is_some_and(|r| r.is_superplastic());
    let most = if allowed { f64::INFINITY } else { LIMITS[1] };
    let light = Light::of(thinning, [LIMITS[0], most]);
    let limit = if allowed {
        format!("below {share}", share = Amount::share(LIMITS[0]))
    } else {
        format!(
            "below {share}, at most {most} unless a forming limit is kept",
            share = Amount::share(LIMITS[0]),
            most = Amount::share(LIMITS[1])
        )
    };
    let found =
        format!("{thinning} at s0 = {s0}", thinning = Amount::share(thinning), s0 = Amount::place(last.thinnest_s0));
    Some(
        Finding::judged("thinning", "Thinning", light, found)
            .against(100.0 * thinning, Unit::Percent, limit)
            .at_most(100.0 * LIMITS[0], (!allowed).then_some(100.0 * LIMITS[1]))
            .advice(advice(run, run.stages.last()?, last.thinnest_s0)),
    )
}
