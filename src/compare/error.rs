//! Why a comparison cannot be made.

use crate::table::UnitError;
use std::path::PathBuf;

/// Why a comparison cannot be made: the reference file does not fit what is asked of it.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    #[error("cannot read {}", path.display())]
    Read { path: PathBuf, source: std::io::Error },
    #[error("cannot read {} as CSV", path.display())]
    Csv { path: PathBuf, source: csv::Error },
    #[error("cannot read {}: one table per reference file with citation, kind, grade and, if known, scatter", path.display())]
    Sources { path: PathBuf, source: toml::de::Error },
    #[error("{} has no column `{column}`; it has {found}", path.display())]
    Column { path: PathBuf, column: String, found: String },
    #[error("{} separates its columns by {found:?}: write commas between columns, and points in numbers", path.display())]
    Separator { path: PathBuf, found: char },
    #[error("{}: {error}", path.display())]
    Unit { path: PathBuf, error: UnitError },
    #[error("{}: column `{column}` cannot be compared with the computed {with}", path.display())]
    Dimension { path: PathBuf, column: String, with: String },
    #[error("{}, data row {row}: `{text}` in column `{column}` is not a number", path.display())]
    Number { path: PathBuf, row: usize, column: String, text: String },
    #[error("{} has no rows in columns `{x}` and `{y}` within the range asked for", path.display())]
    Empty { path: PathBuf, x: String, y: String },
    #[error("{} has no values in {columns}, which the band should span", path.display())]
    NoBand { path: PathBuf, columns: String },
    #[error("{}, data row {row}: the error of measurement in column `{column}` is negative", path.display())]
    NegativeError { path: PathBuf, row: usize, column: String },
    #[error("{}: the reference value is 0 at {x}, which no relative difference can be taken from; narrow `range`", path.display())]
    Zero { path: PathBuf, x: f64 },
}
