//! Friction, clearance between punch and die, and ironing.

use super::tear::{is_upright, place};
use super::*;
use crate::measure::thickest;
use crate::model::Friction;
use crate::rules::{IRONING_LIMIT, drawing_clearance};

/// Coefficient of dry steel on steel \[–\].
const DRY: f64 = 0.3;
/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Share by which sizes that a case has rounded may miss a rule \[–\].
const ROUNDED: f64 = 1e-3;
/// Gap over the thickness above which a wall is not straight, and wall above which a shop irons it to size, declared: a rim of
/// β = 2.2 is √β thicknesses thick \[–\].
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

/// Gap between punch and die over the thickness in the stage that is worst, else in the last; wide ones matter beside an
/// upright wall only, where a rim of draw ratio β may be √β thicknesses thick.
pub(super) fn clearance(run: &Run) -> Option<Finding> {
    let blank = &run.case.model().blank;
    let judged = |i: usize, stage: &StageSolution| {
        let gap = estimate::clearance(&stage.model)? / blank.thickness;
        let upright = is_upright(stage).unwrap_or(false);
        let ratio = blank.length / extent(stage.model.tool(Role::Punch)?).1;
        let rim = drawing_clearance(blank.thickness, ratio).value / blank.thickness;
        let wide = if upright { WIDE.max(rim) } else { f64::INFINITY };
        let wall = stage.frames.last().and_then(thickest).map(|(wall, _)| wall / blank.thickness);
        let wall = wall.filter(|wall| upright && *wall < gap);
        let sizes = |wall| format!("; the wall is {} thick at most: nothing sizes it", Amount::thicknesses(wall));
        let loose = wall.map_or_else(String::new, sizes);
        let text = run.of_stage("{} between punch and die".into(), i) + &loose;
        let judged = Finding::judged("clearance", "Clearance", text)
            .number(Amount::thicknesses(gap).to(Digits::Decimals(2)))
            .source("a sheet that does not thin is ironed in less; 1.5 t, or t √β of the draw ratio: declared");
        let most = Amount::thicknesses(wide).to(Digits::Decimals(2));
        let limit = if upright { format!("; {most} at most beside a straight wall") } else { String::new() };
        if gap > LEAST && wall > Some(WIDE) {
            let limit = format!("a wall of {} at most", Amount::thicknesses(WIDE));
            return Some(judged.light(Light::Amber).limit(limit).advice("a last draw that irons the wall to size"));
        }
        let judged = match gap > LEAST {
            true => judged.at_most(wide * (1.0 + ROUNDED), None),
            false => judged.light(Light::Amber),
        };
        Some(judged.limit(format!("1 t at least{limit}")))
    };
    let new = run.stages.iter().enumerate().filter(|(i, stage)| *i == 0 || stage.model.release.is_none());
    new.filter_map(|(i, stage)| judged(i, stage)).max_by_key(|finding| finding.light)
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
