//! Friction, clearance between punch and die, and ironing.

use super::tear::{nose, place};
use super::*;
use crate::geometry::Point;
use crate::measure::thickest;
use crate::model::{Friction, tool_sizes::apart};
use crate::numerics::bisect;
use crate::rules::{IRONING_LIMIT, SIZED, strip_clearance};
use crate::solver::solution::NodeRecord;

/// Coefficient of dry steel on steel \[–\].
const DRY: f64 = 0.3;
/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Overlap of tools over the thickness that counts \[–\], and number of travels at which it is looked for.
const OVERLAP: f64 = 1e-3;
const LOOKS: usize = 16;
/// Gap over the thickness above which a wall is neither straight nor to size, declared \[–\].
const WIDE: f64 = 1.5;
/// Reduction of the thickness above which a wall counts as ironed \[–\].
pub(super) const IRONED: f64 = 0.01;
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

pub(super) fn overlap(model: &Model) -> Option<Finding> {
    let (t, whole) = (model.blank.thickness, model.travel);
    let later = |(i, a)| model.tools[i + 1..].iter().map(move |b| [b, a]);
    let pairs = model.tools.iter().enumerate().flat_map(later).filter(|[further, _]| further.role.further().is_some());
    let first = |pair: [&Tool; 2]| {
        let at = |travel: f64| apart(pair, pair.map(|tool| tool.motion.displacement(travel, whole)));
        let is_apart = |travel: f64| at(travel).0 >= -OVERLAP * t;
        let led = pair.iter().all(|tool| !matches!(tool.motion, Motion::Pressed(_)));
        let looks = (0..=if led { LOOKS } else { 0 }).map(|k| whole * k as f64 / LOOKS as f64);
        let hit = looks.into_iter().find(|travel| !is_apart(*travel))?;
        let [_, from] = bisect((hit - whole / LOOKS as f64).max(0.0), hit, 30, is_apart);
        Some((pair.map(|tool| model.name_of(tool.role)), from, at(from).1))
    };
    let ([name, other], from, at) = pairs.into_iter().find_map(first)?;
    let [r, z] = [at.x, at.y].map(Amount::size);
    let start = if from > 0.0 { "from {} of travel on" } else { "at the start" };
    let text = format!("the {name} and the {other} run into each other {start}, at r = {r}, z = {z}");
    let warning = Finding::warning("overlap", "Overlap", text).number(Amount::place(from));
    Some(warning.limit("apart").source("the sections").advice("another profile, `gap` or drive"))
}

pub(super) fn idle(run: &Run) -> Option<Finding> {
    let last = run.stages.last().filter(|last| last.stop.is_complete())?;
    let touches = |name: &str| {
        run.stages.iter().flat_map(StageSolution::further_peaks).any(|(_, other, peak)| other == name && peak > 0.0)
    };
    let names: Vec<&str> = last.model.further.iter().map(String::as_str).filter(|name| !touches(name)).collect();
    let name = *names.first()?;
    let frames = formed(run.stages).flat_map(|(_, stage)| stage.frames.iter().map(move |frame| (stage, frame)));
    let near = frames.filter_map(|(stage, frame)| {
        let tools = stage.model.tools.iter().zip(&frame.tool_displacement);
        let (tool, moved) = tools.into_iter().find(|(tool, _)| stage.model.name_of(tool.role) == name)?;
        let gap = |node: &NodeRecord| tool.profile.closest(Point::new(node.r, node.z) - moved).distance;
        let gaps = frame.nodes.iter().map(|node| gap(node) - 0.5 * node.thickness);
        Some((gaps.fold(f64::INFINITY, f64::min), instant(stage, frame.travel, frame.time), &tool.motion))
    });
    let (gap, at, motion) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let drive = if *motion == Motion::Fixed { "it stands: give it a drive" } else { "a longer way, more force" };
    let names = joined(names, " and the ");
    let text = format!("the sheet never touches the {names}; the {name} comes within {{}} of it, at {at}");
    let judged = Finding::judged("idle_tool", "Idle tool", text).number(Amount::place(gap)).light(Light::Amber);
    Some(judged.limit("in contact").source("the run").advice(format!("{drive}, or a smaller `gap`")))
}

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
        // A hole's wall is thinner than its sheet: a narrow gap irons it to size.
        if gap < LEAST && (estimate::has_land(model) || blank.has_hole()) {
            return None;
        }
        // A straight wall begins where nose and shoulder have passed each other.
        let shoulder = model.tool(Role::Die)?.profile.corners().map(|arc| arc.radius).fold(0.0, f64::max);
        let upright = nose(stage).is_some_and(|(nose, upright)| upright && model.travel > nose.radius + shoulder);
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
        let sized = if blank.has_hole() { 1.0 } else { worded(model.geometry, SIZED, strip_clearance(1.0).value) };
        let throat = Amount::size(2.0 * (sized * blank.thickness + extent(stage.model.tool(Role::Punch)?).1));
        let advice = format!("a gap of {sized} t, throat {throat} wide: `--clearance {sized}t` of `stampflow new`");
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
    } else if estimate::draw_ratio(run.case.model()).is_some() {
        (LIGHTLY, "a wider gap between punch and die there (`stampflow new cup --clearance`), or one draw more")
    } else {
        (LIGHTLY, "a wider gap between the tools there")
    };
    let source = "up to 15 % a draw sizes its wall, 30 % of a ring (declared); in one pass (Chin. J. Mech. Eng. 2022, 10.1186/s10033-022-00681-9)";
    let judged = Finding::judged("ironing", "Ironing", text).number(Amount::share(most.ironing));
    Some(judged.at_most(100.0 * careful, 100.0 * IRONING_LIMIT).source(source).advice(advice))
}
