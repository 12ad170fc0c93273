//! Whether the sheet fits between punch and die.

use super::nose::NoseEnd;
use super::{Finding, Light, run::Run};
use crate::model::Model;
use crate::rules::estimate;
use crate::table::Unit;
use crate::units::mm;

/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Gap over the thickness above which a wall is not straight: a rim of β = 2.2 is √β thicknesses thick \[–\].
const WIDE: f64 = 1.5;

/// Tools that close by more than the sheet leaves room for.
pub(super) fn narrow(model: &Model) -> Option<Finding> {
    let t = model.blank.thickness;
    let gap = estimate::clearance(model).filter(|gap| *gap < t * LEAST)?;
    let found = format!(
        "at the full travel punch and die are {} mm apart, less than the thickness of {} mm: sheet that does not thin to that \
         is ironed",
        mm(gap),
        mm(t)
    );
    Some(Finding::warning("narrow_clearance", "Clearance", found).against(gap, Unit::Mm, "one thickness at least"))
}

/// Gap between punch and die over the thickness; wide ones matter beside a straight wall only.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let gap = estimate::clearance(run.case.model())? / run.case.model().blank.thickness;
    let straight = run.stages.first().and_then(NoseEnd::of).is_some_and(NoseEnd::is_upright);
    let light = Light::doubtful(gap < LEAST || straight && gap > WIDE);
    let most = if straight { format!(", {WIDE} at most beside a straight wall") } else { String::new() };
    Some(
        Finding::judged("clearance", "Clearance", light, format!("{gap:.2} thicknesses between punch and die"))
            .against(gap, Unit::None, format!("one thickness at least{most}"))
            .source("a sheet that does not thin is ironed in less; the upper one is a declared rule of thumb")
            .advice(match gap < LEAST {
                true => "a larger throat, a smaller punch or a shorter travel",
                false => "a smaller throat: the wall leans, and puckers",
            }),
    )
}
