//! Whether one draw reaches the draw ratio.

use super::Finding;
use crate::assess::design::LIMITING_RATIO;
use crate::assess::estimate;
use crate::model::Model;
use crate::table::Unit;
use crate::units::Amount;

/// A blank that is too large for one draw over its punch.
pub(super) fn large(model: &Model) -> Option<Finding> {
    let ratio = estimate::draw_ratio(model).filter(|ratio| *ratio > LIMITING_RATIO)?;
    let limit = Amount::number(LIMITING_RATIO);
    let found = format!(
        "the draw ratio of {ratio} is above {limit}, about the limit of mild steel: one draw will hardly reach it",
        ratio = Amount::ratio(ratio)
    );
    let warning = Finding::warning("draw_ratio", "Draw ratio", found);
    Some(warning.against(ratio, Unit::None, format!("{limit} at most")).at_most(LIMITING_RATIO, None))
}
