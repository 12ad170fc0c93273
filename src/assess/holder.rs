//! Holder: force, lift, distance blocks.

use super::run::Run;
use super::{Finding, Light, closing, material};
use crate::assess::estimate::{held_from, holder_pressure, tensile_strength};
use crate::measure::rests_on_blocks;
use crate::model::{Model, Motion, Role, Tool};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::Amount;

/// Lift over the thickness that is reported, and at which the flange is no longer held \[–\].
const LIFTED: f64 = 0.3;
const OFF: f64 = 1.0;
/// Width of a flange that no longer buckles as it runs out over the shoulder, its rim tilting, over the thickness \[–\].
const RUN_OUT: f64 = 2.0 * StepRecord::RIM;
/// Normal pressure over the tensile strength that a shell, which yields without one, can overlook \[–\].
const PRESSURE: f64 = 0.1;
/// Share of the holder's force on the rim alone from which it is reported \[–\].
const RIM_SHARE: f64 = 0.9;
/// Share of the travel from which resting on the blocks is reported \[–\].
const RESTS: f64 = 0.1;

pub(super) fn idle(model: &Model) -> Option<Finding> {
    let idle = |motion: &Motion| matches!(motion, Motion::Pressed(press) if press.is_idle());
    model.tools.iter().any(|tool| idle(&tool.motion)).then(|| {
        let text = "the holder has no force and takes no part: the flange may swing up through where it is drawn";
        Finding::warning("holder_force", "Holder", text).number(Amount::count(0.0)).limit("above 0")
    })
}

/// Holder pressure above the strength of the sheet, unless the hardening law is to blame.
pub(super) fn crushing(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let pressure = holder_pressure(model).filter(|pressure| !material::is_weak(model) && *pressure > strength)?;
    let limit = Amount::stress(strength);
    let text = format!("the holder presses with {{}}, more than the sheet's tensile strength of {limit}");
    let warning = Finding::warning("holder_pressure", "Holder pressure", text).number(Amount::stress(pressure));
    Some(warning.at_most(limit, strength, None).advice("check its force"))
}

/// Lift of a pressed holder until the flange runs out, six thicknesses wide \[mm\]. A narrower flange no longer buckles,
/// and its rim tilts as it goes over the shoulder.
pub fn holder_lift(stage: &StageSolution) -> Option<f64> {
    let model = &stage.model;
    let pressed = |holder: &Tool| matches!(&holder.motion, Motion::Pressed(press) if !press.is_idle());
    model.tool(Role::Holder).filter(|holder| pressed(holder) && model.release.is_none())?;
    let width = model.blank.length - held_from(model)?;
    let held = stage.steps.iter().filter(|step| width - step.draw_in > RUN_OUT * model.blank.thickness);
    // A holder that has closed over a bead is lifted from there.
    let closed = stage.closing.map_or(0.0, |closing| closing.way - closing.gap);
    Some(held.map(|step| closed - step.holder_move).fold(0.0, f64::max))
}

/// Lift of the holder until the flange runs out, its first pressure, and whether the rim takes nearly all of its force.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let model = &first.model;
    let thickness = model.blank.thickness;
    let lift = holder_lift(first)?;
    if let Some(gap) = closing::gap_left(first) {
        let text = "not judged: it stands open by {} on its bead";
        let judged = Finding::judged("holder", "Holder", text).number(Amount::thickness(gap)).light(Light::Grey);
        return Some(judged.limit("closed on the sheet").advice(closing::advice(model)));
    }
    let last = first.steps.iter().rev().find(|step| step.holder_force > 0.0)?;
    let (pressure, strength) = (holder_pressure(model).unwrap_or(0.0), tensile_strength(&model.material));
    let presses = pressure > PRESSURE * strength;
    let mut text = format!("lifted by {{}} at most; presses with {} at first", Amount::stress(pressure));
    if last.rim_share > RIM_SHARE {
        text += &format!("; at the end it sits on the outer {} only", Amount::size(StepRecord::RIM * thickness));
    }
    let [lifted, off] = [LIFTED, OFF].map(|times| Amount::thickness(times * thickness));
    let limit = format!("lifted by {lifted}, red above {off}; {}", Amount::stress(PRESSURE * strength));
    let judged = Finding::judged("holder", "Holder", run.of_stage(text, 0)).number(Amount::thickness(lift));
    let judged = judged.at_most(limit, LIFTED * thickness, OFF * thickness);
    let light = judged.light.max(if presses { Light::Amber } else { Light::Green });
    Some(judged.light(light).advice(match presses {
        false => "more holder force; a larger die shoulder raises the flange less",
        true => "less holder force: the flange is squeezed thinner",
    }))
}

pub(super) fn lifted(stage: &StageSolution) -> Option<Finding> {
    let (lift, thickness) = (holder_lift(stage)?, stage.model.blank.thickness);
    let most = LIFTED * thickness;
    (lift > most).then(|| {
        let text = "the holder is lifted by {} at most: the flange thickens or rises under it";
        let warning = Finding::warning("holder_lift", "Holder", text).number(Amount::thickness(lift));
        warning.at_most(Amount::thickness(most), most, None)
    })
}

/// Holder that rests on its distance blocks, where it presses no sheet.
pub(super) fn rests(stage: &StageSolution) -> Option<Finding> {
    let travel = stage.model.travel;
    let [from, to] = resting(travel, &stage.steps)?;
    let [begin, end] = [from, to].map(Amount::place);
    let text =
        format!("the holder rests on its distance blocks from {begin} to {end} of travel, and does not hold the sheet");
    let warning = Finding::warning("holder_rests", "Distance blocks", text).number(Amount::place(to - from));
    Some(warning.at_most(format!("{} of the travel", Amount::given_share(RESTS)), RESTS * travel, None))
}

/// Part of the travel in which the holder rests on its blocks \[mm\], if it is a large one.
fn resting(travel: f64, history: &[StepRecord]) -> Option<[f64; 2]> {
    let (mut longest, mut from) = ([0.0; 2], 0.0);
    for record in history {
        from = if rests_on_blocks(record) { from } else { record.travel };
        if record.travel - from > longest[1] - longest[0] {
            longest = [from, record.travel];
        }
    }
    (longest[1] - longest[0] > RESTS * travel).then_some(longest)
}

pub(super) fn lost(stage: &StageSolution) -> Option<Finding> {
    let mut tools = stage.model.tools.iter().zip(&stage.left_at);
    let (tool, travel) = tools.find_map(|(tool, left)| Some((tool.role.name(), (*left)?)))?;
    let text = format!("the sheet left the {tool} at {{}} of travel; the {tool} stands still from there on");
    let warning = Finding::warning("holder_lost", "Holder", text).number(Amount::place(travel));
    Some(warning.at_least("the whole travel", stage.model.travel, None))
}
