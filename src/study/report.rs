//! Results of a study: a headline, notes, tables and charts, for every kind of study.

use crate::assess::Light;
use crate::plot::chart::Chart;
use crate::units::{Amount, rounded};
use serde::{Serialize, Serializer};

/// Results of a study.
#[derive(Clone, Debug, Default, Serialize)]
pub struct StudyReport {
    /// The result in one sentence.
    pub headline: String,
    /// Notes on it, a sentence each.
    pub notes: Vec<String>,
    /// Tables.
    pub tables: Vec<ReportTable>,
    /// Whether it found what it was asked for.
    pub found: bool,
    /// Pictures by their file names.
    #[serde(skip)]
    pub charts: Vec<(String, Chart)>,
}

/// A table of results.
#[derive(Clone, Debug, Serialize)]
pub struct ReportTable {
    /// File name without its ending.
    pub name: &'static str,
    /// Headers.
    pub columns: Vec<String>,
    /// One cell per column.
    pub rows: Vec<Vec<Cell>>,
}

/// A cell of a table.
#[derive(Clone, Debug)]
pub enum Cell {
    /// Text.
    Text(String),
    /// A number with its unit, and maybe its error bar.
    Amount(Amount),
    /// A light of the verdict, and what has it.
    Light(Light, String),
}

impl ReportTable {
    /// A table without rows.
    pub fn new(name: &'static str, columns: &[&str]) -> Self {
        Self { name, columns: columns.iter().map(|column| (*column).to_owned()).collect(), rows: Vec::new() }
    }

    /// Formats CSV; the unit of a number stands in a column behind it.
    pub fn csv(&self) -> Vec<u8> {
        let is_amount = |i: usize| self.rows.iter().any(|row| matches!(row.get(i), Some(Cell::Amount(_))));
        let has_unit: Vec<bool> = (0..self.columns.len()).map(is_amount).collect();
        let with_unit = |cells: Vec<[String; 2]>| -> Vec<String> {
            let cells = cells.into_iter().zip(&has_unit);
            cells.flat_map(|(cell, has_unit)| cell.into_iter().take(1 + usize::from(*has_unit))).collect()
        };
        let header = self.columns.iter().map(|column| {
            let key = column.to_lowercase().replace([' ', '-'], "_").replace(['%', '²'], "");
            [key.clone(), key + "_unit"]
        });
        let pair = |cell: &Cell| match cell {
            Cell::Amount(amount) => [rounded(amount.value).to_string(), amount.unit.spelled().to_owned()],
            cell => [cell.to_string(), String::new()],
        };
        let rows = self.rows.iter().map(|row| row.iter().map(pair).collect());
        std::iter::once(header.collect())
            .chain(rows)
            .flat_map(|row| super::run_table::record(&with_unit(row)))
            .collect()
    }
}

impl std::fmt::Display for Cell {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Amount(amount) => amount.fmt(f),
            Self::Light(light, text) if text.is_empty() => f.write_str(light.name()),
            Self::Light(light, text) => write!(f, "{}: {text}", light.name()),
        }
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Number {
            value: f64,
            #[serde(skip_serializing_if = "Option::is_none")]
            error: Option<f64>,
            unit: &'static str,
        }
        match self {
            Self::Amount(amount) => {
                let error = amount.bar().map(rounded);
                Number { value: rounded(amount.value), error, unit: amount.unit.spelled() }.serialize(serializer)
            }
            text => serializer.serialize_str(&text.to_string()),
        }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<Amount> for Cell {
    fn from(amount: Amount) -> Self {
        Self::Amount(amount)
    }
}
