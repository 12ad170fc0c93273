//! Why a comparison cannot be made.

use crate::table::{CsvError, UnitError};
use std::path::PathBuf;

/// Why a comparison cannot be made: the reference file does not fit what is asked of it.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs, reason = "the fields are named in the messages")]
pub enum CompareError {
    /// No such file, and it is not optional.
    #[error("{} is not there", path.display())]
    Missing { path: PathBuf },
    /// No column of this name.
    #[error("{} has no column `{column}`; it has {found}", path.display())]
    Column { path: PathBuf, column: String, found: String },
    /// A header without a unit that is understood.
    #[error("{}: {error}", path.display())]
    Unit { path: PathBuf, error: UnitError },
    /// A column of another dimension than what is computed.
    #[error("{}: column `{column}` cannot be compared with the computed {with}", path.display())]
    Dimension { path: PathBuf, column: String, with: String },
    /// A cell that is no number.
    #[error("{}, line {line}, column `{column}`: {error}", path.display())]
    Number { path: PathBuf, line: usize, column: String, error: CsvError },
    /// A value that nothing measured can have.
    #[error("{}, line {line}, column `{column}`: {found} is out of range, its magnitude must be at most {largest:e} {unit}: check the number and the unit at the end of the header", path.display())]
    Range { path: PathBuf, line: usize, column: String, found: String, largest: f64, unit: &'static str },
    /// No point of a curve within the range.
    #[error("{} has no rows in columns `{x}` and `{y}` within the range asked for", path.display())]
    Empty { path: PathBuf, x: String, y: String },
    /// No value that a band could span.
    #[error("{} has no values in {columns}, which the band should span", path.display())]
    NoBand { path: PathBuf, columns: String },
    /// An error of measurement below zero.
    #[error("{}, line {line}: the error of measurement in column `{column}` is negative", path.display())]
    NegativeError { path: PathBuf, line: usize, column: String },
    /// A reference of 0, or so near to it that no relative difference can be taken.
    #[error("{}, line {line}: the reference value is {value} at {x}, which no relative difference can be taken from; narrow `range`", path.display())]
    Zero { path: PathBuf, line: usize, value: String, x: f64 },
}
