//! Whether the holder stays on the sheet.

use super::{DECLARED, Finding, Light, of_stage};
use crate::model::{Motion, Role};
use crate::rules::estimate::{held_from, holder_pressure, tensile_strength};
use crate::solution::StageSolution;
use crate::solution::StepRecord;
use crate::solver::warnings::LIFTED;
use crate::table::Unit;

/// Lift over the thickness at which the holder has left the flange to itself \[–\].
const OFF: f64 = 1.0;

/// Width of a flange that no longer buckles as it runs out over the shoulder, its rim tilting, over the thickness \[–\].
const RUN_OUT: f64 = 2.0 * StepRecord::RIM;
/// Normal pressure over the tensile strength that a shell, which yields without one, can overlook \[–\].
const PRESSURE: f64 = 0.1;

/// How far the holder is lifted, over the thickness, until the flange runs out; how hard it presses at first, and how much
/// of its force the rim takes at the end.
pub(super) fn judge(passes: &[StageSolution]) -> Option<Finding> {
    let run = passes.first()?;
    let model = &run.model;
    let holder = model.tool(Role::Holder)?;
    if !matches!(&holder.motion, Motion::Pressed(press) if !press.is_idle()) {
        return None;
    }
    let last = run.steps.iter().rev().find(|step| step.holder_force > 0.0)?;
    let thickness = model.blank.thickness;
    let width = model.blank.length - held_from(model).unwrap_or(0.0);
    let held = run.steps.iter().filter(|step| width - step.draw_in > RUN_OUT * thickness);
    let lift = held.map(|step| -step.holder_move / thickness).fold(0.0, f64::max);
    let pressed = holder_pressure(model).unwrap_or(0.0) / tensile_strength(&model.material.hardening);
    let (lifts, presses) = (Light::of(lift, [LIFTED, OFF]), Light::within(pressed, PRESSURE));
    let advice = match presses {
        Light::Green => "more holder force; a larger die shoulder raises the flange less",
        _ => "less holder force: the sheet is squeezed, which the shell does not see",
    };
    Some(Finding {
        key: "holder",
        label: "Holder",
        light: lifts.max(presses),
        value: Some(lift),
        unit: Unit::None,
        found: format!(
            "lifted by up to {lift:.2} t; at first {:.1} % of the tensile strength; in the end {:.0} % of its force on the \
             outer {} t{}",
            100.0 * pressed,
            100.0 * last.rim_share,
            StepRecord::RIM,
            of_stage(passes, 0)
        ),
        limit: format!(
            "lifted by at most {LIFTED} t, refused above {OFF} t, until the flange is {RUN_OUT} t wide; {:.0} % of the \
             tensile strength",
            100.0 * PRESSURE
        ),
        source: DECLARED,
        advice: lifts.max(presses).advice(advice),
    })
}
