//! Results of a study: a headline, notes, tables and charts, for every kind of study.

use super::run_table::record;
use crate::assess::Light;
use crate::plot::chart::Chart;
use crate::units::{Amount, rounded};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Results of a study.
#[derive(Clone, Debug, Default, serde::Serialize)]
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
#[derive(Clone, Debug, serde::Serialize)]
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
        let widths: Vec<usize> = (0..self.columns.len()).map(|i| 1 + usize::from(is_amount(i))).collect();
        let header = self.columns.iter().map(|column| {
            let key = column.to_lowercase().replace([' ', '-'], "_").replace(['%', '²'], "");
            [key.clone(), key + "_unit"]
        });
        let pair = |cell: &Cell| match cell {
            Cell::Amount(amount) => [rounded(amount.value).to_string(), amount.unit.spelled().to_owned()],
            cell => [cell.to_string(), String::new()],
        };
        let rows = self.rows.iter().map(|row| row.iter().map(pair).collect());
        let lines = std::iter::once(header.collect()).chain(rows);
        let fields = |line: Vec<[String; 2]>| -> Vec<String> {
            line.into_iter().zip(&widths).flat_map(|(pair, width)| pair.into_iter().take(*width)).collect()
        };
        lines.flat_map(|line| record(&fields(line))).collect()
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
        let Self::Amount(amount) = self else { return serializer.collect_str(self) };
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("value", &rounded(amount.value))?;
        if let Some(error) = amount.bar {
            map.serialize_entry("error", &rounded(error))?;
        }
        map.serialize_entry("unit", amount.unit.spelled())?;
        map.end()
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
