//! Reference values: columns of a CSV file, units at the end of their names.

use super::error::CompareError;
use crate::table::{Column, Csv};
use std::path::Path;

/// A column of a reference file in solver units; `None` where a row has no value.
pub(super) struct Values {
    pub values: Vec<Option<f64>>,
    /// What converts the file's unit to the solver's.
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
            found: self.csv.found(),
        })?;
        let (unit, factor) = self.csv.unit(at).map_err(|error| CompareError::Unit { path: path(), error })?;
        if unit != computed.unit {
            let (column, with) = (header.to_owned(), computed.axis().text().to_owned());
            return Err(CompareError::Dimension { path: path(), column, with });
        }
        let values = self.csv.rows.iter().map(|row| {
            let value = row.number(at).map_err(|error| CompareError::Number {
                path: path(),
                line: row.line,
                column: header.to_owned(),
                error,
            });
            Ok(value?.map(|value| value * factor))
        });
        Ok(Values { values: values.collect::<Result<_, _>>()?, factor })
    }
}
