//! Named columns of numbers with units: what every file, plot and comparison reads.
//!
//! A [`Column`] is the only place that knows how a quantity is called, so the header of a CSV file and the label
//! of an axis cannot disagree.

mod csv;
mod field;
pub mod fields;
mod spacing;

use crate::units::DisplayUnit;
pub use crate::units::{Unit, UnitError};
pub use csv::{Csv, CsvError, Record};
pub use field::{Field, worded};
use serde::Serialize;
pub use spacing::Spacing;

/// One N·mm, the solver's unit of work \[J\].
pub const JOULES: f64 = 1e-3;

/// One quantity, in solver units.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name in file headers and JSON, without the unit: `punch_force`.
    pub key: &'static str,
    /// Name on axes and in legends: `Punch force`.
    pub label: &'static str,
    /// Unit of the values.
    pub unit: Unit,
    /// The numbers, one a row; NaN or infinite where there is none, which is written as an empty cell.
    pub values: Vec<f64>,
}

/// Columns of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// From left to right.
    pub columns: Vec<Column>,
}

/// Axis of a plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// Name of the quantity.
    pub label: String,
    /// Symbol of the unit: `mm`, or `–` for plain numbers.
    pub unit: String,
    /// Names of categories at 0, 1, 2, …; empty for numbers.
    pub names: Vec<String>,
    /// Linear or logarithmic; along a logarithmic axis points are given by their logarithms.
    pub spacing: Spacing,
    /// Unit of the values until they are converted for display.
    #[serde(skip)]
    solver_unit: Option<Unit>,
}

impl Column {
    /// A column of values in `unit`.
    pub fn new(key: &'static str, label: &'static str, unit: Unit, values: Vec<f64>) -> Self {
        Self { key, label, unit, values }
    }

    /// Key and unit as in a CSV header: `punch_force_N`.
    pub fn header(&self) -> String {
        self.unit.keyed(self.key)
    }

    /// Label and unit: `Punch force [N]`.
    pub fn axis(&self) -> Axis {
        Axis::named(self.label, self.unit)
    }
}

impl Axis {
    /// Axis of numbers in a unit.
    pub fn named(label: impl Into<String>, unit: Unit) -> Self {
        let (label, names, spacing) = (label.into(), Vec::new(), Spacing::Even);
        Self { label, unit: unit.symbol().to_owned(), names, spacing, solver_unit: Some(unit) }
    }

    /// Axis of categories: the first stands at 0, the next at 1.
    pub fn of_names(label: impl Into<String>, names: Vec<String>) -> Self {
        Self { names, ..Self::named(label, Unit::None) }
    }

    /// Same axis, linear or logarithmic.
    pub fn spaced(self, spacing: Spacing) -> Self {
        Self { spacing, ..self }
    }

    /// Common axis of several columns: the word that their labels end with, or all labels.
    ///
    /// # Panics
    /// If the columns differ in unit.
    pub fn shared(columns: &[&Column]) -> Self {
        let unit = columns.first().map_or(Unit::None, |c| c.unit);
        assert!(columns.iter().all(|c| c.unit == unit), "columns of different units on one axis");
        let word = |c: &&Column| c.label.rsplit(' ').next();
        let is_common = columns.len() > 1 && columns.iter().all(|c| word(c) == word(&columns[0]));
        let label = match columns.first().and_then(word).filter(|_| is_common) {
            Some(word) => capitalised(word),
            None => columns.iter().map(|c| c.label).collect::<Vec<_>>().join(", "),
        };
        Self::named(label, unit)
    }

    /// Axis in the display unit of values up to `largest`, and the conversion to it; `None` if it was converted before.
    pub fn displayed(self, largest: f64) -> (Self, Option<DisplayUnit>) {
        let Some(to) = self.solver_unit.map(|unit| unit.display(largest)) else { return (self, None) };
        let unit = if to.symbol.is_empty() { self.unit } else { to.symbol.to_owned() };
        (Self { unit, solver_unit: None, ..self }, Some(to))
    }

    /// Label with its unit: `Punch force [N]`.
    pub fn text(&self) -> String {
        if self.names.is_empty() { format!("{} [{}]", self.label, self.unit) } else { self.label.clone() }
    }
}

impl Table {
    /// Joins columns.
    ///
    /// # Panics
    /// When the columns differ in length or two have the same header: a mistake of the caller.
    pub fn new(columns: Vec<Column>) -> Self {
        let rows = columns.first().map_or(0, |c| c.values.len());
        for (i, column) in columns.iter().enumerate() {
            assert_eq!(column.values.len(), rows, "column {} has another length", column.key);
            assert!(columns[..i].iter().all(|c| c.key != column.key), "column {} appears twice", column.key);
        }
        Self { columns }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.values.len())
    }

    /// The column of a key.
    ///
    /// # Panics
    /// When there is none: keys are fixed in the program.
    pub fn column(&self, key: &str) -> &Column {
        self.columns.iter().find(|c| c.key == key).unwrap_or_else(|| panic!("the table has no column {key}"))
    }
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
