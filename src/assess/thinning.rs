//! How thin the sheet has become.

use super::nearest::Nearest;
use super::{Finding, Light, run::Run};
use crate::message::{Amount, message};
use crate::table::Unit;

/// Thinning that a designer looks at twice, and that is refused without a forming limit that allows it \[–\].
const LIMITS: [f64; 2] = [0.20, 0.30];

/// What makes a sheet thin less.
pub(super) const ADVICE: &str =
    "less holder force or friction, a larger punch nose or die shoulder, a smaller blank or a shorter travel";

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
        message!("below {share}", share = Amount::share(LIMITS[0]))
    } else {
        message!(
            "below {share}, at most {most} unless a forming limit is kept",
            share = Amount::share(LIMITS[0]),
            most = Amount::share(LIMITS[1])
        )
    };
    let found =
        message!("{thinning} at s0 = {s0}", thinning = Amount::share(thinning), s0 = Amount::place(last.thinnest_s0));
    Some(
        Finding::judged("thinning", "Thinning", light, found)
            .against(100.0 * thinning, Unit::Percent, limit)
            .at_most(100.0 * LIMITS[0], (!allowed).then_some(100.0 * LIMITS[1]))
            .advice(ADVICE),
    )
}
