//! Whether the friction is known or guessed.

use super::{Finding, Light, run::Run};
use crate::model::{Model, Tool};
use crate::table::Unit;
use std::ops::RangeInclusive;

/// Coefficients of sheet on tools \[–\]: from the best of lubricants to dry steel on steel; beyond, a slip of the decimal
/// point.
const USUAL: RangeInclusive<f64> = 0.01..=0.3;

/// A coefficient above that of dry steel.
pub(super) fn dry(_: &Model, tool: &Tool) -> Option<Finding> {
    let (friction, dry) = (tool.friction.largest_coefficient(), USUAL.end());
    (friction > *dry && !tool.friction.needs_shear_yield()).then(|| {
        let found = format!("the {}'s friction of {friction} is above that of dry steel, {dry}", tool.role.name());
        Finding::warning("dry_friction", "Friction", found).against(friction, Unit::None, format!("{dry} at most"))
    })
}

/// Amber unless the case says where its friction comes from, and the coefficients are sheet metal's.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let coefficients = || run.case.model().tools.iter().map(|tool| tool.friction.largest_coefficient());
    let most = coefficients().reduce(f64::max)?;
    let usual = coefficients().all(|mu| USUAL.contains(&mu));
    let (light, said) = match &run.case.sources.friction {
        _ if !usual => (Light::Amber, ", outside what sheet on tools has".to_owned()),
        Some(source) => (Light::Green, format!(": {source}")),
        None => (Light::Amber, ", no source is given".to_owned()),
    };
    Some(
        Finding::judged("friction", "Friction", light, format!("{most} at most{said}"))
            .against(most, Unit::None, format!("a measured or cited number, {} to {}", USUAL.start(), USUAL.end()))
            .advice(
                "run it with 0.02 more and less (--set) to see what hangs on it; write as `source` of [friction] where it was \
                 measured, or author and year",
            ),
    )
}
