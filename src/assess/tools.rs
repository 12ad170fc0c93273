//! Friction, clearance between punch and die, and ironing.

use super::tear::{is_upright, place};
use super::*;
use crate::model::Friction;
use crate::rules::IRONING_LIMIT;

/// Coefficient of dry steel on steel \[–\].
const DRY: f64 = 0.3;
/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Gap over the thickness above which a wall is not straight: a rim of β = 2.2 is √β thicknesses thick \[–\].
const WIDE: f64 = 1.5;
/// Reduction of the thickness above which a wall counts as ironed \[–\].
const IRONED: f64 = 0.01;

pub(super) fn dry_friction(_: &Model, tool: &Tool) -> Option<Finding> {
    let (friction, dry) = (tool.friction.largest_coefficient(), DRY);
    if matches!(tool.friction, Friction::Tresca(_)) {
        return None;
    }
    let text = format!("the {}'s friction of {{}} is above that of dry steel, {dry}", tool.role.name());
    let warning = Finding::warning("dry_friction", "Friction", text).number(Amount::number(friction));
    warning.at_most(dry, None).if_beyond()
}

pub(super) fn narrow(model: &Model) -> Option<Finding> {
    let t = model.blank.thickness;
    let gap = estimate::clearance(model).filter(|gap| *gap < t * LEAST)?;
    let size = Amount::size(t);
    let text = format!(
        "at the full travel punch and die are {{}} apart, less than the thickness of {size}: thicker sheet is ironed"
    );
    Some(Finding::warning("narrow_clearance", "Clearance", text).number(Amount::size(gap)).at_least(t, None))
}

/// Gap between punch and die over the thickness; wide ones matter beside an upright wall only.
pub(super) fn clearance(run: &Run) -> Option<Finding> {
    let gap = estimate::clearance(run.case.model())? / run.case.model().blank.thickness;
    let upright = run.stages.first().and_then(is_upright).unwrap_or(false);
    let most = format!("; {} at most beside a straight wall", Amount::given_thicknesses(WIDE));
    let judged = Finding::judged("clearance", "Clearance", "{} between punch and die")
        .number(Amount::thicknesses(gap).to(Digits::Decimals(2)))
        .source("a sheet that does not thin is ironed in less; the upper one is a declared rule of thumb");
    let judged = match gap > WIDE {
        true => judged.at_most(if upright { WIDE } else { f64::INFINITY }, None),
        false => judged.at_least(1.0, None).light(if gap < LEAST { Light::Amber } else { Light::Green }),
    };
    Some(judged.limit(format!("1 t at least{}", if upright { most.as_str() } else { "" })))
}

pub(super) fn ironing(run: &Run) -> Option<Finding> {
    let most = run.steps().max_by(|a, b| a.ironing.total_cmp(&b.ironing))?;
    let text = match run.steps().find(|step| step.ironing > IRONED) {
        None => "no wall is ironed".into(),
        Some(first) => format!(
            "wall ironed by {{}}; {}, from {} of travel, with up to {}",
            place(run.stages, most.ironing_s0),
            Amount::place(first.travel),
            Amount::stress(run.largest(|step| step.ironing_pressure)?)
        ),
    };
    Finding::judged("ironing", "Ironing", text)
        .number(Amount::share(most.ironing))
        .at_most(100.0 * IRONED, 100.0 * IRONING_LIMIT)
        .source("in one pass; a die for one pass is laid out for less (Chin. J. Mech. Eng. 2022, 10.1186/s10033-022-00681-9)")
        .advice("the penalty leaves the wall thicker by up to twice the penetration: raise solver.contact_stiffness")
        .into()
}
