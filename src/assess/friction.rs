//! Whether the friction is known or guessed.

use super::{Finding, Light, run::Run};
use crate::model::{Model, Tool};
use crate::table::Unit;
use crate::units::Amount;
use std::ops::RangeInclusive;

/// Coefficients of sheet on tools \[–\]: from the best of lubricants to dry steel on steel; beyond, a slip of the decimal
/// point.
const USUAL: RangeInclusive<f64> = 0.01..=0.3;

/// A coefficient above that of dry steel.
pub(super) fn dry(_: &Model, tool: &Tool) -> Option<Finding> {
    let (friction, dry) = (tool.friction.largest_coefficient(), USUAL.end());
    (friction > *dry && !tool.friction.needs_shear_yield()).then(|| {
        let limit = Amount::number(*dry);
        let found = format!(
            "the {tool}'s friction of {friction} is above that of dry steel, {limit}",
            tool = tool.role.name(),
            friction = Amount::number(friction)
        );
        Finding::warning("dry_friction", "Friction", found)
            .against(friction, Unit::None, format!("{limit} at most"))
            .at_most(*dry, None)
    })
}

/// Amber unless the case says where its friction comes from, and the coefficients are sheet metal's.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let coefficients = || run.case.model().tools.iter().map(|tool| tool.friction.largest_coefficient());
    let most = coefficients().reduce(f64::max)?;
    let usual = coefficients().all(|mu| USUAL.contains(&mu));
    let largest = Amount::number(most);
    let (light, found) = match &run.case.sources.friction {
        _ if !usual => (Light::Amber, format!("{largest} at most, outside what sheet on tools has")),
        Some(source) => (Light::Green, format!("{largest} at most: {source}")),
        None => (Light::Amber, format!("{largest} at most, no source is given")),
    };
    let limit = format!(
        "a measured or cited number, {low} to {high}",
        low = Amount::number(*USUAL.start()),
        high = Amount::number(*USUAL.end())
    );
    Some(
        Finding::judged("friction", "Friction", light, found)
            .against(most, Unit::None, limit)
            .at_most(*USUAL.end(), None)
            .advice(
                "run it with 0.02 more and less (--set) to see what hangs on it; write as `source` of [friction] where it was \
                 measured, or author and year",
            ),
    )
}
