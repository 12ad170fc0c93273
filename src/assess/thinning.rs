//! How thin the sheet has become.

use super::nearest::Nearest;
use super::{Finding, Light, run::Run};
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
    let refused = if allowed {
        String::new()
    } else {
        format!(", at most {:.0} % unless a forming limit is kept", 100.0 * LIMITS[1])
    };
    let found = format!("{:.1} % at s0 = {:.1} mm", 100.0 * thinning, last.thinnest_s0);
    Some(
        Finding::judged("thinning", "Thinning", light, found)
            .against(100.0 * thinning, Unit::Percent, format!("below {:.0} %{refused}", 100.0 * LIMITS[0]))
            .advice(ADVICE),
    )
}
