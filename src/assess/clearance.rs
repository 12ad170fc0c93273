//! Whether the sheet fits between punch and die.

use super::nose::NoseEnd;
use super::{Finding, Light, run::Run};
use crate::assess::estimate;
use crate::model::Model;
use crate::table::Unit;
use crate::units::{Amount, Digits};

/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Gap over the thickness above which a wall is not straight: a rim of β = 2.2 is √β thicknesses thick \[–\].
const WIDE: f64 = 1.5;

/// Tools that close by more than the sheet leaves room for.
pub(super) fn narrow(model: &Model) -> Option<Finding> {
    let t = model.blank.thickness;
    let gap = estimate::clearance(model).filter(|gap| *gap < t * LEAST)?;
    let found = format!(
        "at the full travel punch and die are {gap} apart, less than the thickness of {thickness}: sheet that does not thin to \
         that is ironed",
        gap = Amount::size(gap),
        thickness = Amount::size(t)
    );
    let warning = Finding::warning("narrow_clearance", "Clearance", found);
    Some(warning.against(gap, Unit::Mm, "one thickness at least").at_least(t, None))
}

/// Gap between punch and die over the thickness; wide ones matter beside a straight wall only.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let gap = estimate::clearance(run.case.model())? / run.case.model().blank.thickness;
    let straight = run.stages.first().and_then(NoseEnd::of).is_some_and(NoseEnd::is_upright);
    let light = Light::doubtful(gap < LEAST || straight && gap > WIDE);
    let limit = match straight {
        true => {
            format!(
                "one thickness at least, {wide} at most beside a straight wall",
                wide = Amount::given_thicknesses(WIDE)
            )
        }
        false => "one thickness at least".into(),
    };
    let found = format!("{gap} between punch and die", gap = Amount::thicknesses(gap).to(Digits::Decimals(2)));
    let judged = Finding::judged("clearance", "Clearance", light, found).against(gap, Unit::None, limit);
    let judged = if gap > WIDE { judged.at_most(straight.then_some(WIDE), None) } else { judged.at_least(1.0, None) };
    Some(
        judged
            .source("a sheet that does not thin is ironed in less; the upper one is a declared rule of thumb")
            .advice(match gap < LEAST {
                true => "a larger throat, a smaller punch or a shorter travel",
                false => "a smaller throat: the wall leans, and puckers",
            }),
    )
}
