//! Reference values from CSV: `#` comments, a header row with units at the end of each key, rows of numbers.

use super::CompareError;
use crate::table::{Column, Unit};
use csv::StringRecord;
use std::fs::File;
use std::io;
use std::path::Path;

/// The largest file \[bytes\]: a hundred thousand points.
const LARGEST: u64 = 10_000_000;

/// A reference file: its headers and rows as text.
pub(super) struct Reference<'p> {
    path: &'p Path,
    headers: StringRecord,
    rows: Vec<StringRecord>,
}

/// A column of a reference file in solver units; `None` where a row has no value.
pub(super) struct Values {
    pub values: Vec<Option<f64>>,
    /// What converts the file's unit to the solver's.
    pub factor: f64,
}

impl<'p> Reference<'p> {
    /// Reads the file whole.
    pub fn read(path: &'p Path) -> Result<Self, CompareError> {
        let file = File::open(path).map_err(|source| CompareError::Read { path: path.to_owned(), source })?;
        if file.metadata().is_ok_and(|about| about.len() > LARGEST) {
            let text = format!("it is larger than {} MB", LARGEST / 1_000_000);
            let source = io::Error::new(io::ErrorKind::FileTooLarge, text);
            return Err(CompareError::Read { path: path.to_owned(), source });
        }
        let in_file = |source| CompareError::Csv { path: path.to_owned(), source };
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(file);
        let headers = reader.headers().map_err(in_file)?.clone();
        if let (1, Some(found)) = (headers.len(), headers[0].chars().find(|c| matches!(c, ';' | '\t'))) {
            return Err(CompareError::Separator { path: path.to_owned(), found });
        }
        let rows = reader.records().collect::<Result<_, _>>().map_err(in_file)?;
        Ok(Self { path, headers, rows })
    }

    /// The column of a header, in the unit of the computed column that it is compared with.
    pub fn column(&self, header: &str, computed: &Column) -> Result<Values, CompareError> {
        let path = || self.path.to_owned();
        let at = self.headers.iter().position(|h| h == header).ok_or_else(|| CompareError::Column {
            path: path(),
            column: header.to_owned(),
            found: self.headers.iter().collect::<Vec<_>>().join(", "),
        })?;
        let (unit, factor) = Unit::of_header(header).map_err(|error| CompareError::Unit { path: path(), error })?;
        if unit != computed.unit {
            let (column, with) = (header.to_owned(), computed.axis().text().to_owned());
            return Err(CompareError::Dimension { path: path(), column, with });
        }
        let value = |(i, row): (usize, &StringRecord)| match row.get(at).unwrap_or("") {
            "" => Ok(None),
            text => text.parse::<f64>().map(|v| Some(v * factor)).map_err(|_| CompareError::Number {
                path: path(),
                row: i + 1,
                column: header.to_owned(),
                text: text.to_owned(),
            }),
        };
        Ok(Values { values: self.rows.iter().enumerate().map(value).collect::<Result<_, _>>()?, factor })
    }
}
