//! Friction: known or assumed.

use super::{Finding, Light, run::Run};
use crate::model::{Friction, Model, Tool};
use crate::units::Amount;
use std::ops::RangeInclusive;

/// Coefficients of sheet on tools \[–\]: from the best of lubricants to dry steel on steel.
const USUAL: RangeInclusive<f64> = 0.01..=0.3;
/// Change of a coefficient that is advised to be tried \[–\].
const TRIED: f64 = 0.02;

pub(super) fn dry(_: &Model, tool: &Tool) -> Option<Finding> {
    let (friction, dry) = (tool.friction.largest_coefficient(), *USUAL.end());
    (friction > dry && !matches!(tool.friction, Friction::Tresca(_))).then(|| {
        let limit = Amount::number(dry);
        let text = format!("the {}'s friction of {{}} is above that of dry steel, {limit}", tool.role.name());
        let warning = Finding::warning("dry_friction", "Friction", text).number(Amount::number(friction));
        warning.at_most(format!("{limit} at most"), dry, None)
    })
}

/// Amber unless the case names the source of its friction, and the coefficients are those of sheet metal.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let coefficients = || run.case.model().tools.iter().map(|tool| tool.friction.largest_coefficient());
    let most = coefficients().reduce(f64::max)?;
    let (light, text) = match &run.case.sources.friction {
        _ if !coefficients().all(|mu| USUAL.contains(&mu)) => {
            (Light::Amber, "{} at most, outside the range of sheet on tools".to_owned())
        }
        Some(source) => (Light::Green, format!("{{}} at most: {source}")),
        None => (Light::Amber, "you assumed {} at most".to_owned()),
    };
    let [least, dry, low, high] =
        [*USUAL.start(), *USUAL.end(), (most - TRIED).max(0.0), most + TRIED].map(Amount::number);
    Finding::judged("friction", "Friction", text)
        .number(Amount::number(most))
        .at_most(format!("a measured or cited number, {least} to {dry}"), *USUAL.end(), None)
        .light(light)
        .advice(format!("does {low} or {high} change the answer? Then give its `source` in [friction]"))
        .into()
}
