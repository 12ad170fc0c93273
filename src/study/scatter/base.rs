//! The case of a scatter as it stands: what its table's columns are, and what its numbers are held against.

use super::StudyError;
use super::curves::Grids;
use crate::assess;
use crate::study::verify::{Of, Watch};
use crate::study::{Columns, Designs, Solved, Subject};
use crate::table::Unit;
use crate::units::Amount;
use crate::units::Limits;

/// The case as it stands.
#[derive(Clone, Debug)]
pub struct Base {
    /// Columns of the table, but for those of the curves.
    pub columns: Columns,
    /// Numbers, in the order of their columns.
    pub numbers: Vec<Known>,
    /// Rows of its verdict: name in files, and in tables.
    pub rows: Vec<(&'static str, &'static str)>,
    /// Where curves are kept.
    pub grids: Grids,
}

/// A number of the case as it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Known {
    /// Name in tables.
    pub label: &'static str,
    /// The row of the verdict that judges it; `None` of others.
    pub row: Option<&'static str>,
    /// Its unit.
    pub unit: Unit,
    /// How it is told.
    told: Amount,
    /// What it is held against.
    pub limits: Option<Limits>,
    /// Of the case as it stands, in its unit.
    pub value: f64,
}

impl Known {
    /// A value of it, as it is told.
    pub fn amount(&self, value: f64) -> Amount {
        self.told.of(value)
    }
}

impl Base {
    /// Of designs, by a run of their case.
    ///
    /// # Errors
    /// When a mistake of this program ends it.
    pub fn of(designs: &dyn Designs, watch: &dyn Watch) -> Result<Self, StudyError> {
        let case = designs.subject().case(&[])?;
        let solution = Subject::solution(case, watch).map_err(|why| {
            StudyError::new(format!("the case as it stands cannot be run: {why}"), "try `stampflow check`")
        })?;
        let solved = Solved::of(&solution);
        let findings = assess::after_one_of_many(&solution.case, &solution.stages);
        let judged: Vec<_> = assess::judgements(&findings).collect();
        let numbers = solved.outcome.numbers.iter().map(|number| {
            let row = judged.iter().find(|row| number.of == Of::Verdict && row.key == number.key);
            Known {
                label: number.label,
                row: row.map(|row| row.key),
                unit: number.amount.unit,
                told: number.amount,
                limits: row.and_then(|row| row.limits()),
                value: number.amount.value,
            }
        });
        Ok(Self {
            columns: Columns::of(designs, &solved),
            numbers: numbers.collect(),
            rows: judged.iter().map(|row| (row.key, row.label)).collect(),
            grids: Grids::of(&solution),
        })
    }

    /// The first line of the table.
    pub fn header(&self) -> Vec<String> {
        self.columns.header().into_iter().chain(self.grids.headers()).collect()
    }
}
