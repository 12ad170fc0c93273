//! Named columns of numbers with units: what every file, plot and comparison reads.
//!
//! A [`Column`] is the only place that knows how a quantity is called, so the header of a CSV file and the label
//! of an axis cannot disagree.

#[cfg(feature = "case")]
mod csv;
mod field;
pub mod fields;

pub use crate::units::{Unit, UnitError};
#[cfg(feature = "case")]
pub use csv::{Csv, CsvError, Record};
pub use field::{Field, worded};

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

/// The text of an axis; it can only be made from columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis(String);

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
        Axis(format!("{} [{}]", self.label, self.unit.symbol()))
    }
}

impl Axis {
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
        let noun = match words.as_slice() {
            [first, _, ..] if common > 0 => {
                capitalised(&first[..common].iter().rev().copied().collect::<Vec<_>>().join(" "))
            }
            _ => columns.iter().map(|c| c.label).collect::<Vec<_>>().join(", "),
        };
        Self(format!("{noun} [{}]", unit.symbol()))
    }

    /// The same in a unit a thousand times as large, kN for N.
    pub fn in_thousands(self) -> Self {
        Self(self.0.replace(" [", " [k"))
    }

    /// The text to draw.
    pub fn text(&self) -> &str {
        &self.0
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
