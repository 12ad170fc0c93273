//! Tables of the forming limit curve and of every element's strain path.

use super::StageView;
use crate::forming_limit::Curve;
use crate::table::fields::element::{S0, STRAIN_HOOP, STRAIN_MERIDIONAL};
use crate::table::fields::step::TRAVEL;
use crate::table::{Column, Table, Unit};

fn minor(values: Vec<f64>) -> Column {
    Column::new("strain_minor", "Minor true strain, mid-surface", Unit::None, values)
}

fn major(values: Vec<f64>) -> Column {
    Column::new("strain_major", "Major true strain, mid-surface", Unit::None, values)
}

/// The points of a curve.
pub fn curve(curve: &Curve) -> Table {
    let column = |i: usize| curve.points().iter().map(|point| point[i]).collect();
    Table::new(vec![minor(column(0)), major(column(1))])
}

pub(super) fn curve_of(view: &StageView) -> Option<Table> {
    view.model().forming_limit.as_ref().map(curve)
}

/// One row per element and accepted step: its strains and its distance to the curve; the crookedness is that of the whole
/// path.
pub(super) fn paths_of(view: &StageView) -> Option<Table> {
    let assessment = view.forming_limit()?;
    let curve = view.model().forming_limit.as_ref()?;
    let paths = &view.stage.paths;
    let mut columns: [Vec<f64>; 10] = Default::default();
    for (e, judged) in assessment.elements.iter().enumerate() {
        for (instant, [minor, major]) in paths.instants.iter().zip(paths.of(e)) {
            let [meridional, hoop] = instant.strains[e];
            let limit = if curve.knows(minor) { curve.major_at(minor) } else { f64::NAN };
            let row = [
                judged.s0,
                instant.time,
                instant.travel,
                minor,
                major,
                meridional,
                hoop,
                limit,
                limit - major,
                judged.crookedness,
            ];
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
    }
    let extent = view.extent();
    let [s0, time, travel, minors, majors, meridional, hoop, limit, margin, crookedness] = columns;
    Some(Table::new(vec![
        S0.filled(extent, s0),
        Column::new("time", "Time", Unit::Second, time),
        TRAVEL.filled(extent, travel),
        minor(minors),
        major(majors),
        STRAIN_MERIDIONAL.filled(extent, meridional),
        STRAIN_HOOP.filled(extent, hoop),
        Column::new("limit_major", "Major strain of the limit", Unit::None, limit),
        Column::new("margin", "Margin in major strain", Unit::None, margin),
        Column::new(
            "crookedness",
            "Distance of the path from a straight line, over its length",
            Unit::None,
            crookedness,
        ),
    ]))
}
