//! How thin the sheet has become.

use super::{Finding, Light};
use crate::case::Case;
use crate::solver::Pass;
use crate::table::Unit;

/// Thinning that a designer looks at twice, and that is refused without a forming limit that allows it \[–\].
const LIMITS: [f64; 2] = [0.20, 0.30];

/// The least thickness of the last stage over that of the blank.
pub(super) fn judge(case: &Case, passes: &[Pass]) -> Option<Finding> {
    let last = passes.last()?.run.history.last()?;
    let thinning = 1.0 - last.thinnest / case.model.blank.thickness;
    let light = match thinning {
        t if t < LIMITS[0] => Light::Green,
        t if t < LIMITS[1] => Light::Amber,
        _ => Light::Red,
    };
    let advice = "less holder force or friction, a larger punch nose or die shoulder, a smaller blank";
    Some(Finding {
        key: "thinning",
        label: "Thinning",
        light,
        value: Some(100.0 * thinning),
        unit: Unit::Percent,
        found: format!("{:.1} % at s0 = {:.1} mm", 100.0 * thinning, last.thinnest_s0),
        limit: format!("below {:.0} %, at most {:.0} %", 100.0 * LIMITS[0], 100.0 * LIMITS[1]),
        source: "declared rule of thumb",
        advice: if light == Light::Green { String::new() } else { advice.into() },
    })
}
