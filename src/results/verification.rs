//! The numbers of a verification, of every run.

use super::csv::number;
use crate::study::verify::{Number, Outcome, Verification};
use std::fmt::Write;

/// File of the numbers.
pub const FILE: &str = "verification.csv";

/// What a file of ours begins with.
pub const BEGINNING: &str = "told_by,quantity,unit,value,error_bar";

/// One row per number: value, error bar, and the value of every finer run, a column each; a cell without a number is empty.
pub fn csv(verification: &Verification) -> String {
    let runs: Vec<&Outcome> = verification.outcomes.iter().filter(|run| run.direction.is_some()).collect();
    let mut text = BEGINNING.to_owned();
    for run in &runs {
        let direction = run.direction.map_or("", |direction| direction.key());
        let _ = write!(text, ",{direction}_{}", run.times);
    }
    text.push('\n');
    for bar in &verification.bars {
        let Number { of, key, amount, .. } = &bar.number;
        let half = bar.half.map_or_else(String::new, number);
        let _ = write!(text, "{},{key},{},{},{half}", of.key(), amount.unit.spelled(), number(amount.value));
        for run in &runs {
            let _ = write!(text, ",{}", run.value(&bar.number).map_or_else(String::new, number));
        }
        text.push('\n');
    }
    text
}
