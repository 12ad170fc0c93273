//! Table of the residual stress at every thickness point.

use super::StageView;
use crate::plot::residual_stress::{PLACE, places_with_layers, released};
use crate::solver::solution::{ElementRecord, PointRecord};
use crate::table::fields::element::{R, S0, STRAIN_EQUIVALENT, STRESS_HOOP, STRESS_MERIDIONAL, Z};
use crate::table::{Column, Field, Table, Unit};

/// One row per element and layer, from the axis outward and from the die's face to the punch's.
pub(super) fn of(view: &StageView) -> Option<Table> {
    let (frame, elements) = released(view)?;
    places_with_layers(frame, elements).first()?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    let points = &frame.through.points[..elements.len() * layers.len()];
    let of_elements = |field: Field<ElementRecord>| {
        let each = elements.iter().flat_map(|e| std::iter::repeat_n((field.value)(e), layers.len()));
        field.filled(extent, each.collect())
    };
    let of_points = |field: Field<ElementRecord>, value: fn(&PointRecord) -> f64| {
        field.filled(extent, points.iter().map(value).collect())
    };
    let place = elements.iter().flat_map(|_| layers.iter().map(|layer| 0.5 * layer.xi));
    let zeta = elements.iter().flat_map(|e| layers.iter().map(|layer| 0.5 * layer.xi * e.thickness));
    Some(Table::new(vec![
        of_elements(S0),
        of_elements(R),
        of_elements(Z),
        Column::new("place", PLACE, Unit::None, place.collect()),
        Column::new("zeta", "ζ, from the mid-surface towards the punch", Unit::Mm, zeta.collect()),
        of_points(STRESS_MERIDIONAL, |p| p.stress_meridional),
        of_points(STRESS_HOOP, |p| p.stress_hoop),
        of_points(STRAIN_EQUIVALENT, |p| p.strain_equivalent),
    ]))
}
