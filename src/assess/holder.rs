//! Holder: force, lift, distance blocks, closing over slopes of holder and die.

use super::{estimate::flange_strength, estimate::held_from, estimate::holder_pressure, *};
use crate::measure::rests_on_blocks;
use crate::solver::closing_way;

/// Lift over the thickness that is reported, and at which the flange is no longer held \[–\].
const LIFTED: [f64; 2] = [0.3, 1.0];
/// Gap over the thickness that a holder may keep \[–\]: thickening of a flange that is drawn.
const OPEN: f64 = 0.1;
/// Width of a flange that no longer buckles as it runs out over the shoulder, its rim tilting, over the thickness \[–\].
const RUN_OUT: f64 = 2.0 * StepRecord::RIM;
/// Normal pressure over the tensile strength that a shell, which yields without one, can overlook \[–\].
const PRESSURE: f64 = 0.1;
/// Pressure of a pad over the tensile strength from which it marks the sheet: declared \[–\].
const MARKS: f64 = 0.5;
/// Share of the holder's force on the rim alone from which it is reported \[–\].
const RIM_SHARE: f64 = 0.9;
/// Share of the travel from which resting on the blocks is reported \[–\].
const RESTS: f64 = 0.1;

fn is_pressed(tool: &Tool, acts: bool) -> bool {
    matches!(&tool.motion, Motion::Pressed(press) if press.is_idle() != acts)
}

pub(super) fn idle(model: &Model) -> Option<Finding> {
    let text = "the holder has no force and takes no part: the flange may swing up through where it is drawn";
    let warning = Finding::warning("holder_force", "Holder", text).number(Amount::count(0.0)).limit("above 0");
    model.tools.iter().any(|tool| is_pressed(tool, false)).then_some(warning)
}

pub(super) fn crushing(model: &Model) -> Option<Finding> {
    let strength = flange_strength(model);
    let pressure = Amount::stress(holder_pressure(model).filter(|_| !material::is_weak(model))?);
    let limit = pressure.with_value(strength);
    let text = format!("the holder presses with {{}}, more than the sheet's tensile strength of {limit}");
    let warning = Finding::warning("holder_pressure", "Holder pressure", text).number(pressure);
    warning.at_most(strength, None).limit(limit).advice("check its force").if_beyond()
}

/// Lift of a pressed holder \[mm\] until the flange, six thicknesses wide, no longer buckles and tilts at the shoulder.
pub fn holder_lift(stage: &StageSolution) -> Option<f64> {
    let model = &stage.model;
    model.tool(Role::Holder).filter(|holder| is_pressed(holder, true) && model.release.is_none())?;
    let width = model.blank.length - held_from(model)?;
    let held = stage.steps.iter().filter(|step| width - step.draw_in > RUN_OUT * model.blank.thickness);
    let closed = stage.closing.map_or(0.0, |closing| closing.way - closing.gap);
    Some(held.map(|step| closed - step.holder_move).fold(0.0, f64::max))
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let (model, thickness) = (&first.model, first.model.blank.thickness);
    if model.blank.preform.is_some() {
        return None;
    }
    let lift = holder_lift(first)?;
    let judged = |text: String| Finding::judged("holder", "Holder", text);
    if let Some(open) = if_open(first, judged("not judged: it stands open by {}".into())) {
        return Some(open.limit("closed on the sheet"));
    }
    let last = first.steps.iter().rev().find(|step| step.holder_force > 0.0)?;
    let (pressure, most) = (holder_pressure(model).unwrap_or(0.0), PRESSURE * flange_strength(model));
    let rim = (last.rim_share > RIM_SHARE).then(|| Amount::size(StepRecord::RIM * thickness));
    let rim = rim.map_or_else(String::new, |rim| format!("; at the end it sits on the outer {rim} only"));
    let text = format!("lifted by {{}}; presses with {} at first{rim}", Amount::stress(pressure));
    let [lifted, off] = LIFTED.map(|times| Amount::thickness(times * thickness));
    let judged = judged(run.of_stage(text, 0)).number(Amount::thickness(lift)).at_most(lifted.value, off.value);
    let light = if pressure > most { judged.light.max(Light::Amber) } else { judged.light };
    Some(judged.limit(format!("{lifted} at most, red above {off}; at most {}", Amount::stress(most))).light(light))
}

/// Pressure of pads and other pressed tools but the holder on their faces.
pub(super) fn pads(run: &Run) -> Option<Finding> {
    let pressure = |(i, stage): (usize, &StageSolution), (j, tool): (usize, &Tool)| {
        let (extent, (low, high)) = (stage.model.extent(), extent(tool));
        let force = stage.pressing(j).into_iter().fold(0.0, f64::max);
        let name = run.of_stage(stage.model.name_of(tool.role).into(), i);
        (force / (extent.area(high) - extent.area(low)), name)
    };
    let is_pad = |tool: &Tool| tool.role != Role::Holder && matches!(tool.motion, Motion::Pressed(_));
    let all = formed(run.stages).flat_map(|own| {
        let pads = own.1.model.tools.iter().enumerate().filter(|(_, tool)| is_pad(tool));
        pads.map(move |pad| pressure(own, pad))
    });
    let (most, name) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let strength = flange_strength(run.case.model());
    let text = format!("the {name} presses with {{}} on its face: it marks the sheet, then squeezes it");
    let judged = Finding::judged("pad_pressure", "Pad pressure", text).number(Amount::stress(most));
    let judged =
        judged.at_most(MARKS * strength, strength).source("half of the tensile strength, and all of it: declared");
    judged.advice("less force of it, or a larger face").if_beyond()
}

pub(super) fn rests(stage: &StageSolution) -> Option<Finding> {
    let (mut longest, mut from) = ([0.0; 2], 0.0);
    for record in &stage.steps {
        from = if rests_on_blocks(record) { from } else { record.travel };
        if record.travel - from > longest[1] - longest[0] {
            longest = [from, record.travel];
        }
    }
    let [begin, end] = longest.map(Amount::place);
    let text = format!("the holder rests on its distance blocks from {begin} to {end} of travel, and holds no sheet");
    let warning = Finding::warning("holder_rests", "Distance blocks", text);
    warning.number(Amount::place(end.value - begin.value)).at_most(RESTS * stage.model.travel, None).if_beyond()
}

pub(super) fn lost(stage: &StageSolution) -> Option<Finding> {
    if stage.model.stop.drawn_through {
        return None;
    }
    let mut tools = stage.model.tools.iter().zip(&stage.left_at);
    let (tool, travel) = tools.find_map(|(tool, left)| Some((stage.model.name_of(tool.role), (*left)?)))?;
    let text = format!("the sheet left the {tool} at {{}} of travel; it stands still from there on");
    let warning = Finding::warning("holder_lost", "Holder", text).number(Amount::place(travel));
    Some(warning.at_least(stage.model.travel, None))
}

/// Edge that passes a bead, of one by its section half its width.
pub(super) fn out_of_bead(stage: &StageSolution) -> Option<Finding> {
    let blank = &stage.model.blank;
    let left = |bead: &Bead| {
        let most = blank.edge_radius() - bead.at - bead.round.map_or(0.0, |round| round.radius);
        stage.steps.iter().find(|step| step.draw_in > most).map(|step| step.travel)
    };
    let travel = stage.model.beads.iter().filter_map(left).reduce(f64::min)?;
    let warning = Finding::warning("bead_lost", "Bead", "the sheet runs out of its bead at {} of travel");
    let warning = warning.number(Amount::place(travel)).at_least(stage.model.travel, None);
    Some(warning.advice("a larger blank, or the bead further in")).filter(|_| !stage.model.stop.drawn_through)
}

/// Closing of holder and die over their slopes, by displacement \[mm\].
pub(super) fn closes(model: &Model) -> Option<Finding> {
    let text = "holder and die do not lie flat on the sheet: the holder closes over it by {} before the punch comes";
    Some(Finding::assumed(text).number(Amount::place(closing_way(model)?)))
}

pub(super) fn stays_open(stage: &StageSolution) -> Option<Finding> {
    let closing = stage.closing.filter(|_| stage.model.blank.preform.is_none())?;
    let force = Amount::force(closing.force, stage.model.extent().force_unit());
    let text = format!("the holder did not close: with {force} it stands open by {{}} when the draw begins");
    let warning = if_open(stage, Finding::warning("holder_open", "Holder", text))?;
    Some(warning.light(Light::Amber).limit(format!("open by at most {} t", Amount::number(OPEN))))
}

pub(super) fn if_open(stage: &StageSolution, finding: Finding) -> Option<Finding> {
    let gap = stage.closing?.gap;
    let finding = finding.number(Amount::thickness(gap)).light(Light::Grey);
    let finding = finding.advice("more holder force, until it closes; or a flat holder and die with [[tools.beads]]");
    (gap > OPEN * stage.model.blank.thickness).then_some(finding)
}
