//! Friction, clearance between punch and die, and ironing.

use super::tear::{is_upright, place};
use super::*;
use crate::measure::thickest;
use crate::model::Friction;
use crate::rules::{IRONING_LIMIT, SIZED};

/// Coefficient of dry steel on steel \[–\].
const DRY: f64 = 0.3;
/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Gap over the thickness above which a wall is neither straight nor to size, declared \[–\].
const WIDE: f64 = 1.5;
/// Reduction of the thickness above which a wall counts as ironed \[–\].
const IRONED: f64 = 0.01;
/// Reduction of the thickness up to which a draw sizes its wall, declared: less than half of [`IRONING_LIMIT`] \[–\].
const LIGHTLY: f64 = 0.15;
/// Reduction up to which a ring irons the wall, declared: well within [`IRONING_LIMIT`] \[–\].
const RING: f64 = 0.30;

pub(super) fn dry_friction(model: &Model, tool: &Tool) -> Option<Finding> {
    let (friction, dry) = (tool.friction.largest_coefficient(), DRY);
    if matches!(tool.friction, Friction::Tresca(_)) {
        return None;
    }
    let text = format!("the {}'s friction of {{}} is above that of dry steel, {dry}", model.name_of(tool.role));
    Finding::warning("dry_friction", "Friction", text).number(Amount::number(friction)).at_most(dry, None).if_beyond()
}

pub(super) fn narrow(model: &Model) -> Option<Finding> {
    let t = model.blank.thickness;
    let gap = estimate::clearance(model, model.travel).filter(|gap| *gap < t * LEAST)?;
    let size = Amount::size(t);
    let text = format!(
        "at the full travel punch and die are {{}} apart, less than the thickness of {size}: thicker sheet is ironed"
    );
    Some(Finding::warning("narrow_clearance", "Clearance", text).number(Amount::size(gap)).at_least(t, None))
}

/// Gap between punch and die over the thickness in the worst stage, else the last; wide ones matter beside an upright wall.
pub(super) fn clearance(run: &Run) -> Option<Finding> {
    let blank = &run.case.model().blank;
    let judged = |i: usize, stage: &StageSolution| {
        let (model, mut travel) = (&stage.model, stage.model.travel);
        // New tools of a later stage begin where they touch the sheet.
        if let (Some(frame), true) = (stage.frames.last(), run.case.stages[i].begin.meets.contains(&Role::Die)) {
            let tools = model.tools.iter().zip(&frame.tool_displacement);
            let moved = |role: Role| tools.clone().find(|(tool, _)| tool.role == role).map_or(0.0, |(_, by)| by.y);
            travel = moved(Role::Punch) - moved(Role::Die);
        }
        let gap = estimate::clearance(model, travel)? / blank.thickness;
        if gap < LEAST && estimate::has_land(model) {
            return None;
        }
        let upright = is_upright(stage).unwrap_or(false);
        let wide = if upright { WIDE / LEAST } else { f64::INFINITY };
        let wall = stage.frames.last().and_then(thickest).map(|(wall, _)| wall / blank.thickness);
        let wall = wall.filter(|wall| upright && *wall < gap);
        let sizes = |wall| format!("; the wall is {} thick at most: nothing sizes it", Amount::thicknesses(wall));
        let text = run.of_stage("{} between punch and die".into(), i) + &wall.map_or_else(String::new, sizes);
        let number = Amount::thicknesses(gap).to(Digits::Decimals(2));
        let judged = Finding::judged("clearance", "Clearance", text).number(number);
        let judged = judged.source("a sheet that does not thin is ironed in less; 1.5 t: declared");
        let limit = if upright { format!("; {WIDE} t at most beside a straight wall") } else { String::new() };
        let judged = if gap > LEAST { judged.at_most(wide, None) } else { judged.light(Light::Amber) };
        let throat = Amount::size(2.0 * (SIZED * blank.thickness + extent(stage.model.tool(Role::Punch)?).1));
        let advice = format!("a gap of {SIZED} t, throat {throat} wide: `--clearance {SIZED}t` of `stampflow new`");
        Some(judged.limit(format!("1 t at least{limit}")).advice(advice))
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
    let (careful, advice) = if run.stages.iter().any(|stage| estimate::has_land(&stage.model)) {
        (RING, "one ring more (`stampflow new cup --rings`), or a thicker wall")
    } else {
        (LIGHTLY, "a wider gap between punch and die there (`stampflow new cup --clearance`), or one draw more")
    };
    let source = "up to 15 % a draw sizes its wall, 30 % of a ring (declared); in one pass (Chin. J. Mech. Eng. 2022, 10.1186/s10033-022-00681-9)";
    let judged = Finding::judged("ironing", "Ironing", text).number(Amount::share(most.ironing));
    Some(judged.at_most(100.0 * careful, 100.0 * IRONING_LIMIT).source(source).advice(advice))
}
