//! Whether the blank is large enough for the part.

use super::Finding;
use crate::assess::estimate;
use crate::model::{Edge, Model};
use crate::table::Unit;
use crate::units::Amount;

/// A free blank whose area is that of the part, or less, where that is not wished.
pub(super) fn drawn_through(model: &Model) -> Option<Finding> {
    let free = model.blank.edge == Edge::Free && !model.stop.drawn_through;
    let share = estimate::drawn_share(model).filter(|share| free && *share >= 1.0)?;
    let found = format!(
        "at the full travel the part needs {share} of the blank's area: the blank will be drawn through the die",
        share = Amount::share(share)
    );
    Some(
        Finding::warning("drawn_share", "Blank", found)
            .against(100.0 * share, Unit::Percent, format!("below {share}", share = Amount::given_share(1.0)))
            .at_most(100.0, None)
            .source("the sheet keeps its area, its mean thickness hardly changing"),
    )
}
