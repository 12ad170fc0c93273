//! Numbers of a verification in every run.

use super::csv::{number as csv_number, records};
use crate::verification::{Outcome, Verification};

/// Name of the file.
pub const FILE: &str = "verification.csv";

/// First columns, by which the file is recognised.
pub const BEGINNING: &str = "told_by,quantity,unit,value,error_bar";

/// One row per number: value, error bar, and a column with the value of every finer run.
pub fn csv(verification: &Verification) -> Vec<u8> {
    let runs: Vec<&Outcome> = verification.outcomes.iter().filter(|run| run.direction.is_some()).collect();
    let names = runs.iter().map(|run| format!("{}_{}", run.direction.map_or("", |d| d.key()), run.times));
    let header = BEGINNING.split(',').map(str::to_owned).chain(names).collect();
    let rows = verification.numbers.iter().map(|own| {
        let number = &own.quantity;
        let cells = [own.origin.key(), number.key, number.amount.unit.spelled()].map(str::to_owned);
        let values = [Some(number.value()), own.half()].into_iter().chain(runs.iter().map(|run| run.value(own)));
        cells.into_iter().chain(values.map(|value| value.map_or_else(String::new, csv_number))).collect::<Vec<_>>()
    });
    records(std::iter::once(header).chain(rows))
}
