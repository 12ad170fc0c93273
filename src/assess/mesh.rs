//! Whether the elements are small enough for the tools' radii.

use super::Finding;
use crate::model::Model;
use crate::rules::estimate;
use crate::table::Unit;
use crate::units::mm;

/// Elements per 90° below which the load ticks as nodes pass a corner \[–\], and that are proposed.
const FINE: f64 = 8.0;
const FINER: f64 = 10.0;

/// The corner with the fewest elements per 90°.
pub(super) fn coarse(model: &Model) -> Option<Finding> {
    let fit = estimate::coarsest_corner(model).filter(|fit| fit.per_quarter < FINE)?;
    let needed = (model.blank.elements as f64 * FINER / fit.per_quarter).ceil();
    let found = format!(
        "{:.1} elements per 90° at the {}'s radius of {} mm (below {FINE}): the load will tick as nodes pass it; about \
         {needed:.0} elements give {FINER}",
        fit.per_quarter,
        fit.role.name(),
        mm(fit.radius)
    );
    Some(Finding::warning("mesh", "Mesh", found).against(fit.per_quarter, Unit::None, format!("{FINE} at least")))
}
