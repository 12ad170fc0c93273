//! Whether the holder holds the sheet.

use super::run::Run;
use super::{Finding, Light, closing, strength};
use crate::assess::estimate::{held_from, holder_pressure, tensile_strength};
use crate::measure::rests_on_blocks;
use crate::model::{Model, Motion, Role, Tool};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::Unit;
use crate::units::{Amount, joined};

/// Lift over the thickness that is worth a word, and at which the holder has left the flange to itself \[–\].
const LIFTED: f64 = 0.3;
const OFF: f64 = 1.0;
/// Width of a flange that no longer buckles as it runs out over the shoulder, its rim tilting, over the thickness \[–\].
const RUN_OUT: f64 = 2.0 * StepRecord::RIM;
/// Normal pressure over the tensile strength that a shell, which yields without one, can overlook \[–\].
const PRESSURE: f64 = 0.1;
/// Share of the holder's force on the rim alone from which it is worth a word \[–\].
const RIM_SHARE: f64 = 0.9;
/// Share of the travel from which it is worth a word that the holder rests on its blocks \[–\].
const RESTS: f64 = 0.1;

/// A holder without a force.
pub(super) fn idle(model: &Model) -> Option<Finding> {
    let idle = |motion: &Motion| matches!(motion, Motion::Pressed(press) if press.is_idle());
    model.tools.iter().any(|tool| idle(&tool.motion)).then(|| {
        let found = "the holder has no force and takes no part: the flange may swing up through where it is drawn";
        Finding::warning("holder_force", "Holder", found).against(0.0, Unit::None, "above 0")
    })
}

/// A holder that presses harder than the sheet is strong; where that is weaker than any, the law is to blame.
pub(super) fn crushing(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let pressure = holder_pressure(model).filter(|pressure| !strength::is_weak(model) && *pressure > strength)?;
    let found = format!(
        "the holder presses with {pressure}, more than the sheet's tensile strength of {strength}",
        pressure = Amount::stress(pressure),
        strength = Amount::stress(strength)
    );
    Some(
        Finding::warning("holder_pressure", "Holder pressure", found)
            .against(pressure, Unit::MPa, Amount::stress(strength))
            .at_most(strength, None)
            .advice("check its force"),
    )
}

/// How far a holder that is pressed is lifted until the flange runs out, six thicknesses wide \[mm\]; `None` of a
/// stage without one. A narrower flange no longer buckles, and its rim tilts as it goes over the shoulder.
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

/// How far the holder is lifted, over the thickness, until the flange runs out; how hard it presses at first, and whether
/// the rim takes nearly all of its force at the end.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let model = &first.model;
    let lift = holder_lift(first)? / model.blank.thickness;
    if let Some(gap) = closing::open(first) {
        let found = format!("not judged: it stands open by {gap} on its bead", gap = Amount::thickness(gap));
        let judged = Finding::judged("holder", "Holder", Light::Grey, found);
        return Some(judged.limit("closed on the sheet").advice(closing::advice(model)));
    }
    let last = first.steps.iter().rev().find(|step| step.holder_force > 0.0)?;
    let (pressure, strength) = (holder_pressure(model).unwrap_or(0.0), tensile_strength(&model.material));
    let (lifts, presses) = (Light::of(lift, [LIFTED, OFF]), Light::within(pressure / strength, PRESSURE));
    let advice = match presses {
        Light::Green => "more holder force; a larger die shoulder raises the flange less",
        _ => "less holder force: the flange is squeezed thinner",
    };
    let found = format!(
        "{lifted}; presses with {pressure} at first",
        lifted = lifted_by(lift * model.blank.thickness),
        pressure = Amount::stress(pressure)
    );
    let rim = (last.rim_share > RIM_SHARE).then(|| {
        let (share, rim) = (Amount::share(last.rim_share), Amount::size(StepRecord::RIM * model.blank.thickness));
        format!("in the end {share} of its force on the outer {rim}")
    });
    let found = joined([found, rim.unwrap_or_default()], "; ");
    let limit = format!(
        "lifted by {lifted}, red above {off}; {pressure}",
        lifted = Amount::thickness(LIFTED * model.blank.thickness),
        off = Amount::thickness(OFF * model.blank.thickness),
        pressure = Amount::stress(PRESSURE * strength)
    );
    Some(
        Finding::judged("holder", "Holder", lifts.max(presses), run.of_stage(found, 0))
            .against(lift * model.blank.thickness, Unit::Mm, limit)
            .at_most(LIFTED * model.blank.thickness, OFF * model.blank.thickness)
            .advice(advice),
    )
}

/// A lift \[mm\].
fn lifted_by(lift: f64) -> String {
    format!("lifted by {lift} at most", lift = Amount::thickness(lift))
}

/// A holder that is lifted far while there is a flange to be held.
pub(super) fn lifted(stage: &StageSolution) -> Option<Finding> {
    let lift = holder_lift(stage)? / stage.model.blank.thickness;
    (lift > LIFTED).then(|| {
        let thickness = stage.model.blank.thickness;
        let lifted = lifted_by(lift * thickness);
        let found = format!("the holder is {lifted}: the flange thickens or rises under it");
        Finding::warning("holder_lift", "Holder", found)
            .against(lift * thickness, Unit::Mm, Amount::thickness(LIFTED * thickness))
            .at_most(LIFTED * thickness, None)
    })
}

/// A holder that rests on its distance blocks presses no sheet there, however hard it is pressed.
pub(super) fn rests(stage: &StageSolution) -> Option<Finding> {
    let [from, to] = resting(stage.model.travel, &stage.steps)?;
    let found = format!(
        "the holder rests on its distance blocks from {from} to {to} of travel, not on the sheet: it does not hold it there, \
         whatever its force",
        from = Amount::place(from),
        to = Amount::place(to)
    );
    let limit = format!("{share} of the travel", share = Amount::given_share(RESTS));
    let warning = Finding::warning("holder_rests", "Distance blocks", found).against(to - from, Unit::Mm, limit);
    Some(warning.at_most(RESTS * stage.model.travel, None))
}

/// Where in the travel the holder rests on its blocks \[mm\], if it does for a good part of it.
fn resting(travel: f64, history: &[StepRecord]) -> Option<[f64; 2]> {
    let begins = |i: usize| i.checked_sub(1).map_or(0.0, |before| history[before].travel);
    let (mut longest, mut since) = ([0.0; 2], None);
    for (i, record) in history.iter().enumerate() {
        since = if rests_on_blocks(&history[i]) { since.or(Some(begins(i))) } else { None };
        if let Some(from) = since.filter(|from| record.travel - from > longest[1] - longest[0]) {
            longest = [from, record.travel];
        }
    }
    (longest[1] - longest[0] > RESTS * travel).then_some(longest)
}

/// A tool that the sheet has left, and that stands still from there on.
pub(super) fn lost(stage: &StageSolution) -> Option<Finding> {
    let mut tools = stage.model.tools.iter().zip(&stage.left_at);
    let (tool, travel) = tools.find_map(|(tool, left)| Some((tool.role.name(), (*left)?)))?;
    let found = format!(
        "the sheet left the {tool} at {travel} of travel; the {tool} stands still from there on",
        travel = Amount::place(travel)
    );
    let warning = Finding::warning("holder_lost", "Holder", found).against(travel, Unit::Mm, "the whole travel");
    Some(warning.at_least(stage.model.travel, None))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by construction.
    #[test]
    fn a_holder_that_rests_on_its_blocks_for_long_is_said() {
        let history = |borne: [f64; 4]| {
            let record = |(i, block_force)| StepRecord {
                travel: (i + 1) as f64,
                block_force,
                holder_force: 100.0 - block_force,
                ..StepRecord::default()
            };
            borne.into_iter().enumerate().map(record).collect::<Vec<_>>()
        };
        assert_eq!(resting(4.0, &history([90.0, 0.0, 100.0, 60.0])), Some([2.0, 4.0]));
        assert_eq!(resting(4.0, &history([40.0, 0.0, 10.0, 0.0])), None);
        assert_eq!(resting(20.0, &history([100.0, 0.0, 0.0, 100.0])), None);
    }
}
