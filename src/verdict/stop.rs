//! Whether the run came to its end.

use super::{Finding, Light};
use crate::solver::Pass;
use crate::table::Unit;

/// Red where the last stage stopped early; the stop says why and what to try.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let stop = &passes.last()?.run.stop;
    Some(Finding {
        key: "stop",
        label: "Run",
        light: if stop.is_complete() { Light::Green } else { Light::Red },
        value: None,
        unit: Unit::None,
        found: stop.to_string(),
        limit: "reaches its end".into(),
        source: "the solver",
        advice: String::new(),
    })
}
