//! Picture of Woo's hemispherical cup: thinnest place and load over the travel, with the normal stress of contact and without.

use stampflow::case;
use stampflow::plot::chart::{Chart, Panel, Series, Style};
use stampflow::solver::solution::StepRecord;
use stampflow::table::fields::step::{PUNCH_FORCE, THINNEST, TRAVEL};
use stampflow::table::{Csv, Field};

const CASE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/woo_hemispherical.toml");
const RECORD: &str = include_str!("../../../reference_data/woo_pole_without_normal_stress.csv");

/// Both panels over the travel.
pub fn chart() -> Result<Chart, String> {
    let case = case::load(CASE, &[]).map_err(|error| error.to_string())?;
    let run = stampflow::run(case.model(), &mut ());
    let extent = case.model().extent();
    let panel = |field: &Field<StepRecord>, column: &str, height: f64| {
        let series = vec![
            Series::new("With the normal stress", TRAVEL.against(field, &run.steps), Style::curve(0)),
            Series::new("Without it (version 0.1.0)", record(column)?, Style::curve(1)),
        ];
        let (x, y) = (TRAVEL.axis(extent), field.axis(extent));
        Ok::<_, String>(Panel::fit(x, y, height, 0.0).with(series))
    };
    let thickness = panel(&THINNEST, "thinnest_mm", 250.0)?;
    let mut force = panel(&PUNCH_FORCE, "punch_force_N", 200.0)?;
    // One legend says what the curves of both panels are.
    force.series.iter_mut().for_each(|series| series.label = None);
    Ok(Chart {
        title: case.model().title.clone(),
        legend: String::new(),
        panels: vec![thickness, force],
        notes: case.model().notes.clone(),
    })
}

/// A column of the record over its travel, in solver units.
fn record(column: &str) -> Result<Vec<(f64, f64)>, String> {
    let csv = Csv::read(RECORD, "the record", "travel_mm,thinnest_mm").map_err(|error| error.to_string())?;
    let at = |name: &str| csv.column(name).ok_or_else(|| format!("no {name} in the record"));
    let (x, y) = (at("travel_mm")?, at(column)?);
    let number = |row: &stampflow::table::Record, column| {
        row.number(column).map_err(|error| error.to_string())?.ok_or_else(|| format!("line {} has a gap", row.line))
    };
    csv.rows.iter().map(|row| Ok((number(row, x)?, number(row, y)?))).collect()
}
