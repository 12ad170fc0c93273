//! Why a comparison cannot be made.

use crate::table::{CsvError, UnitError};
use std::path::PathBuf;

/// Why a comparison cannot be made: the reference file does not fit what is asked of it.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    #[error("{} is not there", path.display())]
    Missing { path: PathBuf },
    #[error("{} has no column `{column}`; it has {found}", path.display())]
    Column { path: PathBuf, column: String, found: String },
    #[error("{}: {error}", path.display())]
    Unit { path: PathBuf, error: UnitError },
    #[error("{}: column `{column}` cannot be compared with the computed {with}", path.display())]
    Dimension { path: PathBuf, column: String, with: String },
    #[error("{}, line {line}, column `{column}`: {error}", path.display())]
    Number { path: PathBuf, line: usize, column: String, error: CsvError },
    #[error("{} has no rows in columns `{x}` and `{y}` within the range asked for", path.display())]
    Empty { path: PathBuf, x: String, y: String },
    #[error("{} has no values in {columns}, which the band should span", path.display())]
    NoBand { path: PathBuf, columns: String },
    #[error("{}, line {line}: the error of measurement in column `{column}` is negative", path.display())]
    NegativeError { path: PathBuf, line: usize, column: String },
    #[error("{}: the reference value is 0 at {x}, which no relative difference can be taken from; narrow `range`", path.display())]
    Zero { path: PathBuf, x: f64 },
}
