//! Whether the friction is known or guessed.

use super::{DECLARED, Finding, Light};
use crate::case::Case;
use crate::table::Unit;

/// How a note begins that says of itself that it is an assumption.
const ASSUMED: &str = "declared";

/// Amber unless a note of the case names the friction and does not call it declared.
pub(super) fn judge(case: &Case) -> Option<Finding> {
    let tools = &case.model.tools;
    let most = tools.iter().map(|tool| tool.friction.largest_coefficient()).reduce(f64::max)?;
    let mut naming = case.model.notes.iter().filter(|note| note.contains("friction"));
    let known = naming.clone().any(|note| !note.trim_start().starts_with(ASSUMED));
    let said = if known {
        "a note says where it comes from"
    } else if naming.next().is_some() {
        "a declared assumption"
    } else {
        "no note says where it comes from"
    };
    let light = if known { Light::Green } else { Light::Amber };
    Some(Finding {
        key: "friction",
        label: "Friction",
        light,
        value: Some(most),
        unit: Unit::None,
        found: format!("{most} at most, {said}"),
        limit: "a measured or cited number".into(),
        source: DECLARED,
        advice: light
            .advice("run it with 0.02 more and less (--set) to see what hangs on it; write its source in `notes`"),
    })
}
