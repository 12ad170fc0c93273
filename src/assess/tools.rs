//! Friction, clearance between punch and die, and ironing.

use super::{tear::nose, tear::place, *};
use crate::geometry::Point;
use crate::measure::thickest;
use crate::model::{Friction, tool_sizes::apart, tool_sizes::mouth, tool_sizes::throat};
use crate::numerics::bisect;
use crate::rules::{IRONING_LIMIT, SIZED, strip_clearance};

/// Coefficient of dry steel on steel \[–\].
const DRY: f64 = 0.3;
/// Smallest gap over the thickness \[–\]; rounded sums of decimals may miss it.
const LEAST: f64 = 1.0 - 1e-6;
/// Overlap of tools over the thickness that counts \[–\], and number of travels at which it is looked for.
const OVERLAP: f64 = 1e-3;
const LOOKS: usize = 16;
/// Force of a tool that does not press over the tensile strength, beyond rounding: declared [mm², or mm in plane strain].
const IDLE: f64 = 1e-6;
/// Gap of closed tools over the thickness below which they coin the sheet instead of bending it, declared \[–\].
const SQUEEZED: f64 = 0.95;
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
    let is_closed = model.tool(Role::Die).is_some_and(|die| throat(die).is_none());
    let what = if is_closed { "they squeeze the sheet" } else { "thicker sheet is ironed" };
    let text = format!("at the full travel punch and die are {{}} apart, less than the thickness of {size}: {what}");
    Some(Finding::warning("narrow_clearance", "Clearance", text).number(Amount::size(gap)).at_least(t, None))
}

/// A punch that an earlier run's cup does not take in.
pub(super) fn wide(model: &Model) -> Option<Finding> {
    let (blank, punch) = (&model.blank, model.tool(Role::Punch)?);
    let sheet = blank.preform.as_ref().filter(|_| model.geometry == Geometry::Axisymmetric)?;
    let [wide, inside] = [mouth(punch, 0.0), blank.edge_radius() - 0.5 * blank.thickness].map(|half| 2.0 * half);
    let text = format!("the punch Ø {{}} does not go into the sheet of {}: it pushes on the rim", sheet.folder);
    let warning = Finding::warning("wide_punch", "Punch", text).number(Amount::drawn(wide)).at_most(inside, None);
    warning.source("the earlier run's edge").advice(format!("at most Ø {}", Amount::drawn(inside))).if_beyond()
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
    let least = IDLE * estimate::flange_strength(run.case.model());
    let is_new = |i: usize, role: Role| i == 0 || run.case.stages[i].begin.meets.contains(&role);
    // Stages of a tool, until another has its place.
    let stages = |(first, role): (usize, Role)| {
        let own = formed(run.stages).skip_while(move |(i, _)| *i < first);
        let own = own.take_while(move |(i, _)| *i == first || !is_new(*i, role));
        own.filter_map(move |(_, stage)| Some((stage, stage.model.tool_index(role)?)))
    };
    // In a stage that was cut short it may still have come.
    let presses = |stage: &StageSolution, j| stage.pressing(j).into_iter().any(|force| force > least);
    let may_press = |own| stages(own).any(|(stage, j)| !stage.stop.is_complete() || presses(stage, j));
    let tools = formed(run.stages).flat_map(|(i, stage)| stage.model.tools.iter().map(move |tool| (i, tool.role)));
    let tools = tools.filter(|(_, role)| !matches!(role, Role::Holder | Role::Pad));
    let idle: Vec<_> = tools.filter(|&(i, role)| is_new(i, role) && !may_press((i, role))).collect();
    let first = *idle.first()?;
    let all = stages(first).flat_map(|(on, j)| on.start.iter().chain(&on.frames).map(move |frame| (on, j, frame)));
    let near = all.map(|(stage, j, frame)| {
        let (tool, moved) = (&stage.model.tools[j].profile, frame.tool_displacement[j]);
        let gap = |node: &NodeRecord| tool.closest(Point::new(node.r, node.z) - moved).distance - 0.5 * node.thickness;
        (frame.nodes.iter().map(gap).fold(f64::INFINITY, f64::min), instant(stage, frame.travel, frame.time))
    });
    let (gap, at) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let name = |(i, role): &(usize, Role)| run.of_stage(run.stages[*i].model.name_of(*role).into(), *i);
    let names = joined(idle.iter().map(name), " and the ");
    let text = format!("the sheet never presses on the {names}; it comes within {{}} of the {}, at {at}", name(&first));
    let light = if idle.iter().any(|own| own.1 == Role::Punch) { Light::Red } else { Light::Amber };
    let judged = Finding::judged("idle_tool", "Idle tool", text).number(Amount::place(gap.max(0.0))).light(light);
    Some(judged.limit("in contact").source("the run").advice("another size, drive or `gap`, or do without it"))
}

pub(super) fn clearance(run: &Run) -> Option<Finding> {
    let blank = &run.case.model().blank;
    let rings = run.stages.iter().any(|stage| estimate::has_land(&stage.model)).then_some("Ironing judges the rings");
    let judged = |i: usize, stage: &StageSolution| {
        let (model, mut travel) = (&stage.model, stage.model.travel);
        // New tools of a later stage begin where they touch the sheet.
        if let (Some(frame), true) = (stage.frames.last(), run.case.stages[i].begin.meets.contains(&Role::Die)) {
            let tools = model.tools.iter().zip(&frame.tool_displacement);
            let moved = |role: Role| tools.clone().find(|(tool, _)| tool.role == role).map_or(0.0, |(_, by)| by.y);
            travel = moved(Role::Punch) - moved(Role::Die);
        }
        let (gap, die) = (estimate::clearance(model, travel)? / blank.thickness, model.tool(Role::Die)?);
        // Rings, and a throat in less than t, iron the wall.
        if estimate::has_land(model) || (gap < LEAST && throat(die).is_some()) {
            return None;
        }
        // A straight wall begins where nose and shoulder have passed each other.
        let shoulder = die.profile.corners().map(|arc| arc.radius).fold(0.0, f64::max);
        let upright = nose(stage).is_some_and(|(nose, upright)| upright && model.travel > nose.radius + shoulder);
        let wall = stage.frames.last().and_then(thickest).map(|(wall, _)| wall / blank.thickness);
        let wall = wall.filter(|wall| upright && *wall < gap);
        let sizes = |wall| format!("the wall is {} thick at most: nothing sizes it", Amount::thicknesses(wall));
        let text = run.of_stage("{} between punch and die".into(), i);
        let text = joined([text, wall.map_or_else(String::new, sizes), rings.unwrap_or_default().into()], "; ");
        let number = Amount::thicknesses(gap).to(Digits::Decimals(2));
        let judged = Finding::judged("clearance", "Clearance", text).number(number);
        let judged = judged.source("closed tools squeeze a sheet in less; 0.95 t, 1.5 t: declared");
        if gap < LEAST {
            return Some(judged.at_least(1.0, SQUEEZED).advice("a gap of 1 t or more between the closed tools"));
        }
        let limit = if upright { format!("1 t to {WIDE} t beside a straight wall") } else { "1 t at least".to_owned() };
        let sized = if blank.has_hole() { 1.0 } else { worded(model.geometry, SIZED, strip_clearance(1.0).value) };
        let throat = Amount::size(2.0 * (sized * blank.thickness + extent(model.tool(Role::Punch)?).1));
        let advice = format!("a gap of {sized} t, throat {throat} wide (`stampflow new … --clearance {sized}t`)");
        let judged = judged.at_most(if upright { WIDE / LEAST } else { f64::INFINITY }, None);
        Some(judged.limit(limit).advice(advice))
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
        (RING, "one ring more (`stampflow new … --rings`), or a thicker wall")
    } else if estimate::draw_ratio(run.case.model()).is_some() {
        (LIGHTLY, "a wider gap (`stampflow new cup --clearance`), or one draw more")
    } else {
        (LIGHTLY, "a gap of 1 t or more between the tools")
    };
    let source = "up to 15 % a draw sizes its wall, 30 % of a ring (declared); in one pass (Chin. J. Mech. Eng. 2022, 10.1186/s10033-022-00681-9)";
    let judged = Finding::judged("ironing", "Ironing", text).number(Amount::share(most.ironing));
    Some(judged.at_most(100.0 * careful, 100.0 * IRONING_LIMIT).source(source).advice(advice))
}
