//! Named columns of numbers with units: what every file, plot and comparison reads.
//!
//! A [`Column`] is the only place that knows how a quantity is called, so the header of a CSV file and the label
//! of an axis cannot disagree.

mod csv;
mod field;
pub mod fields;
mod spacing;

pub use crate::units::{Unit, UnitError};

use crate::units::DisplayUnit;
pub use csv::{Csv, CsvError, Record};
pub use field::{Field, worded};
pub use spacing::Spacing;
use std::borrow::Cow;

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

/// What an axis is of, and the unit of its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    labels: Vec<Cow<'static, str>>,
    unit: Unit,
    symbol: &'static str,
    names: Vec<String>,
    spacing: Spacing,
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
        Axis::new(vec![self.label.into()], self.unit)
    }
}

impl Axis {
    fn new(labels: Vec<Cow<'static, str>>, unit: Unit) -> Self {
        Self { labels, unit, symbol: unit.symbol(), names: Vec::new(), spacing: Spacing::Even }
    }

    /// Of what is no column: a label, and the unit of the values.
    pub fn named(label: impl Into<Cow<'static, str>>, unit: Unit) -> Self {
        Self::new(vec![label.into()], unit)
    }

    /// Of things that have names and no numbers: the first stands at 0, the next at 1.
    pub fn of_names(label: impl Into<Cow<'static, str>>, names: Vec<String>) -> Self {
        Self { names, ..Self::named(label, Unit::None) }
    }

    /// The same for values that stand so: what is drawn along it are their places, and what is written are the values.
    pub fn spaced(self, spacing: Spacing) -> Self {
        Self { spacing, ..self }
    }

    /// How values stand along it: at which places they are drawn.
    pub fn spacing(&self) -> Spacing {
        self.spacing
    }

    /// The names along it; empty where there are numbers.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// One axis for several columns: the words that their labels end with in common, or all labels.
    ///
    /// # Panics
    /// When the columns differ in unit: they cannot share an axis.
    pub fn shared(columns: &[&Column]) -> Self {
        let unit = columns.first().map_or(Unit::None, |c| c.unit);
        assert!(columns.iter().all(|c| c.unit == unit), "columns of different units on one axis");
        let words: Vec<Vec<&str>> = columns.iter().map(|c| c.label.rsplit(' ').collect()).collect();
        let fewest = words.iter().map(Vec::len).min().unwrap_or(0);
        let common = (0..fewest).take_while(|&i| words.iter().all(|w| w[i] == words[0][i])).count();
        let labels = match words.as_slice() {
            [first, _, ..] if common > 0 => {
                vec![capitalised(&first[..common].iter().rev().copied().collect::<Vec<_>>().join(" ")).into()]
            }
            _ => columns.iter().map(|c| c.label.into()).collect(),
        };
        Self::new(labels, unit)
    }

    /// Axis in display units for values up to `largest`, and the conversion to them.
    pub fn displayed(self, largest: f64) -> (Self, DisplayUnit) {
        let unit = self.unit.display(largest);
        let symbol = if unit.symbol.is_empty() { self.symbol } else { unit.symbol };
        (Self { symbol, ..self }, unit)
    }

    /// The text to draw: `Punch force [N]`.
    pub fn text(&self) -> String {
        let labels = self.labels.join(", ");
        if self.names.is_empty() { format!("{labels} [{}]", self.symbol) } else { labels }
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
