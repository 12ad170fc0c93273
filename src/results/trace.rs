//! Iterations of the corrector as tables: of a run, and of one step with several matrices.

use super::csv::csv_with_texts;
use crate::model::Iteration;
use crate::solver::solution::IterationRecord;
use crate::solver::trace::IterationHistory;
use crate::table::{Column, Table, Unit};

/// Name of a matrix in case files and tables.
pub fn key(matrix: Iteration) -> &'static str {
    match matrix {
        Iteration::PrimalDual => "primal_dual",
        Iteration::Newton => "newton",
        Iteration::Secant => "secant",
    }
}

/// One row per iteration, of rejected steps too.
pub fn table(iterations: &[IterationRecord]) -> Table {
    let column = |key, label, unit, value: fn(&IterationRecord) -> f64| {
        Column::new(key, label, unit, iterations.iter().map(value).collect())
    };
    Table::new(vec![
        column("step", "Step", Unit::None, |i| i.step as f64),
        column("travel", "Punch travel", Unit::Mm, |i| i.travel),
        column("iteration", "Iteration", Unit::None, |i| i.iteration as f64),
        column("velocity_norm", "Relative velocity increment", Unit::None, |i| i.velocity_norm),
        column("residual_norm", "Relative residual", Unit::None, |i| i.residual_norm),
        column("cut", "Share of the increment taken", Unit::None, |i| i.share),
        column("active_contacts", "Active contacts", Unit::None, |i| i.active_contacts as f64),
        column("worst_r", "Radius of the largest residual", Unit::Mm, |i| i.worst_r),
        column("cut_off_elements", "Elements in cut-off", Unit::None, |i| i.cut_off as f64),
        column("contacts", "Points in contact", Unit::None, |i| i.touching as f64),
        column("sticking", "Points that stick", Unit::None, |i| i.sticking as f64),
    ])
}

/// [`table`] of a step with several matrices as CSV, with the method, the start and the matrix of each row.
pub fn step_csv(histories: &[IterationHistory]) -> Vec<u8> {
    let rows = || histories.iter().flat_map(|history| history.rows.iter().map(move |row| (history.matrix, row)));
    let all: Vec<IterationRecord> = rows().map(|(_, row)| *row).collect();
    let texts = [
        ("method", rows().map(|(method, _)| key(method).to_owned()).collect()),
        ("start", rows().map(|(_, row)| row.start.key().to_owned()).collect()),
        ("matrix", rows().map(|(_, row)| key(row.matrix).to_owned()).collect()),
    ];
    csv_with_texts(&table(&all), &texts)
}
