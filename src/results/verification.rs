//! Numbers of a verification in every run.

use super::csv::{number, records};
use crate::study::verify::{Number, Outcome, Verification};

/// Name of the file.
pub const FILE: &str = "verification.csv";

/// First columns, by which the file is recognised.
pub const BEGINNING: &str = "told_by,quantity,unit,value,error_bar";

/// One row per number: value, error bar, and a column with the value of every finer run.
pub fn csv(verification: &Verification) -> Vec<u8> {
    let runs: Vec<&Outcome> = verification.outcomes.iter().filter(|run| run.direction.is_some()).collect();
    let names = runs.iter().map(|run| format!("{}_{}", run.direction.map_or("", |d| d.key()), run.times));
    let header = BEGINNING.split(',').map(str::to_owned).chain(names).collect();
    let rows = verification.bars.iter().map(|bar| {
        let Number { of, key, amount, .. } = &bar.number;
        let cells = [of.key().to_owned(), (*key).to_owned(), amount.unit.spelled().to_owned()];
        let values = [Some(amount.value), bar.half].into_iter().chain(runs.iter().map(|run| run.value(&bar.number)));
        cells.into_iter().chain(values.map(|value| value.map_or_else(String::new, number))).collect::<Vec<_>>()
    });
    records(std::iter::once(header).chain(rows))
}
