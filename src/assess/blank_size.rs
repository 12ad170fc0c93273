//! Whether the blank is large enough for the part.

use super::Finding;
use crate::model::{Edge, Model};
use crate::rules::estimate;
use crate::table::Unit;

/// A free blank whose area is that of the part, or less, where that is not wished.
pub(super) fn drawn_through(model: &Model) -> Option<Finding> {
    let free = model.blank.edge == Edge::Free && !model.stop.drawn_through;
    let share = estimate::drawn_share(model).filter(|share| free && *share >= 1.0)?;
    let found = format!(
        "at the full travel the part needs {:.0} % of the blank's area: the blank will be drawn through the die",
        100.0 * share
    );
    Some(
        Finding::warning("drawn_share", "Blank", found)
            .against(100.0 * share, Unit::Percent, "below 100 %")
            .source("the sheet keeps its area, its mean thickness hardly changing"),
    )
}
