//! Whether one draw reaches the draw ratio.

use super::Finding;
use crate::model::Model;
use crate::rules::estimate;
use crate::rules::limits::LIMITING_RATIO;
use crate::table::Unit;

/// A blank that is too large for one draw over its punch.
pub(super) fn large(model: &Model) -> Option<Finding> {
    let ratio = estimate::draw_ratio(model).filter(|ratio| *ratio > LIMITING_RATIO)?;
    let found = format!("the draw ratio of {ratio:.2} is above {LIMITING_RATIO}: one draw will hardly reach it");
    Some(
        Finding::warning("draw_ratio", "Draw ratio", found)
            .value(ratio, Unit::None)
            .limit(format!("{LIMITING_RATIO} at most")),
    )
}
