//! Whether one draw reaches the draw ratio.

use super::Finding;
use crate::model::Model;
use crate::rules::design::LIMITING_RATIO;
use crate::rules::estimate;
use crate::table::Unit;

/// A blank that is too large for one draw over its punch.
pub(super) fn large(model: &Model) -> Option<Finding> {
    let ratio = estimate::draw_ratio(model).filter(|ratio| *ratio > LIMITING_RATIO)?;
    let found = format!("the draw ratio of {ratio:.2} is above {LIMITING_RATIO}: one draw will hardly reach it");
    Some(Finding::warning("draw_ratio", "Draw ratio", found).against(
        ratio,
        Unit::None,
        format!("{LIMITING_RATIO} at most"),
    ))
}
