//! Results of a study: a headline, notes, tables and charts, for every kind of study.

use super::*;
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
    /// Shorter table to print in its place.
    #[serde(skip)]
    pub printed: Option<Box<ReportTable>>,
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
    /// A table of rows.
    pub fn new<R: Into<Vec<Cell>>>(name: &'static str, columns: &[&str], rows: impl IntoIterator<Item = R>) -> Self {
        let columns = columns.iter().map(|column| (*column).to_owned()).collect();
        Self { name, columns, rows: rows.into_iter().map(Into::into).collect(), printed: None }
    }

    /// Formats CSV; the unit of a number stands in a column behind it.
    pub fn csv(&self) -> Vec<u8> {
        let mut lines = vec![Vec::new(); 1 + self.rows.len()];
        for (i, column) in self.columns.iter().enumerate() {
            let key = column.to_lowercase().replace([' ', '-'], "_").replace(['%', '²'], "");
            let pair = |row: &Vec<Cell>| match row.get(i) {
                Some(Cell::Amount(amount)) => [rounded(amount.value).to_string(), amount.unit.spelled().to_owned()],
                cell => [cell.map_or_else(String::new, Cell::to_string), String::new()],
            };
            let has_unit = self.rows.iter().any(|row| matches!(row.get(i), Some(Cell::Amount(_))));
            let pairs = [[key.clone(), key + "_unit"]].into_iter().chain(self.rows.iter().map(pair));
            for (line, pair) in lines.iter_mut().zip(pairs) {
                line.extend(pair.into_iter().take(1 + usize::from(has_unit)));
            }
        }
        records(&lines)
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

impl<T: AsRef<str>> From<T> for Cell {
    fn from(text: T) -> Self {
        Self::Text(text.as_ref().to_owned())
    }
}

impl From<Amount> for Cell {
    fn from(amount: Amount) -> Self {
        Self::Amount(amount)
    }
}
