//! Whether the holder stays on the sheet.

use super::{DECLARED, Finding, Light, largest};
use crate::model::{Motion, Role};
use crate::record::StepRecord;
use crate::solver::Pass;
use crate::solver::warnings::LIFTED;
use crate::table::Unit;

/// Lift over the thickness at which the holder has left the flange to itself \[–\].
const OFF: f64 = 1.0;

/// How far the holder is lifted, over the thickness, and how much of its force the rim takes at the end.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let pass = passes.first()?;
    let holder = pass.model.tool(Role::Holder)?;
    if !matches!(&holder.motion, Motion::Pressed(press) if !press.is_idle()) {
        return None;
    }
    let lift = largest(std::slice::from_ref(pass), |step| -step.holder_move) / pass.model.blank.thickness;
    let light = Light::of(lift, [LIFTED, OFF]);
    let last = pass.run.history.iter().rev().find(|step| step.holder_force > 0.0)?;
    Some(Finding {
        key: "holder",
        label: "Holder",
        light,
        value: Some(lift),
        unit: Unit::None,
        found: format!(
            "lifted by up to {lift:.2} t; {:.0} % of its force on the outer {} t",
            100.0 * last.rim_share,
            StepRecord::RIM
        ),
        limit: format!("lifted by at most {LIFTED} t, refused above {OFF} t"),
        source: DECLARED,
        advice: light.advice("more holder force; a larger die shoulder raises the flange less"),
    })
}
