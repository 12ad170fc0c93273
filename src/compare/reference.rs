//! Reference values: columns of a CSV file, units at the end of their names.

use super::error::CompareError;
use crate::table::{Column, Csv, Unit};
use std::path::Path;

/// A reference that is smaller is nothing \[mm, N, N/mm\]: no one measures so finely, and a difference over it overflows.
pub(super) const NOTHING: f64 = 1e-9;

/// A column of a reference file in solver units; `None` where a row has no value.
pub(super) struct Values {
    pub values: Vec<Option<f64>>,
    /// Factor from the file's unit to the solver's.
    pub factor: f64,
}

/// A reference file and where it is, for messages.
#[derive(Clone, Copy)]
pub(super) struct Reference<'s> {
    pub path: &'s Path,
    pub csv: &'s Csv,
}

impl Reference<'_> {
    /// The column of a header, in the unit of the computed column that it is compared with.
    pub fn column(&self, header: &str, computed: &Column) -> Result<Values, CompareError> {
        let path = || self.path.to_owned();
        let at = self.csv.column(header).ok_or_else(|| CompareError::Column {
            path: path(),
            column: header.to_owned(),
            found: self.csv.names(),
        })?;
        let (unit, factor) = match self.csv.unit(at) {
            // The name of a plain number ends in no unit.
            Err(_) if computed.unit == Unit::None => (Unit::None, 1.0),
            found => found.map_err(|error| CompareError::Unit { path: path(), error })?,
        };
        if unit != computed.unit {
            let (column, with) = (header.to_owned(), computed.axis().text().to_owned());
            return Err(CompareError::Dimension { path: path(), column, with });
        }
        let largest = unit.largest();
        let values = self.csv.rows.iter().map(|row| {
            let (line, column) = (row.line, || header.to_owned());
            let value =
                row.number(at).map_err(|error| CompareError::Number { path: path(), line, column: column(), error })?;
            let value = value.map(|value| value * factor);
            if value.is_none_or(|value| value.abs() <= largest) {
                return Ok(value);
            }
            let (found, unit) = (row.quoted(at), unit.symbol());
            Err(CompareError::Range { path: path(), line, column: column(), found, largest, unit })
        });
        Ok(Values { values: values.collect::<Result<_, _>>()?, factor })
    }
}
