//! Whether the elements are small enough for the tools' radii.

use super::Finding;
use crate::assess::estimate;
use crate::model::Model;
use crate::table::Unit;
use crate::units::{Amount, Digits};

/// Elements per 90° below which the load ticks as nodes pass a corner \[–\], and that are proposed.
const FINE: f64 = 8.0;
const FINER: f64 = 10.0;

/// The corner with the fewest elements per 90°.
pub(super) fn coarse(model: &Model) -> Option<Finding> {
    let fit = estimate::coarsest_corner(model).filter(|fit| fit.per_quarter < FINE)?;
    let needed = (model.blank.elements as f64 * FINER / fit.per_quarter).ceil();
    let found = format!(
        "{n} elements per 90° at the {tool}'s radius of {radius} (below {fine}): the load will tick as nodes pass it; about \
         {needed} elements give {finer}",
        n = Amount::new(fit.per_quarter, Unit::None, Digits::Significant(2)),
        tool = fit.role.name(),
        radius = Amount::size(fit.radius),
        fine = Amount::number(FINE),
        needed = needed as usize,
        finer = Amount::number(FINER)
    );
    let limit = format!("{limit} at least", limit = Amount::number(FINE));
    Some(Finding::warning("mesh", "Mesh", found).against(fit.per_quarter, Unit::None, limit).at_least(FINE, None))
}
