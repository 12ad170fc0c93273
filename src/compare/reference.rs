//! Reference curves from CSV: `#` comments, a header row with units at the end of each key, rows of numbers.

use super::{CompareError, Spec};
use crate::table::{Column, Unit};
use std::fs::File;
use std::io;

/// The largest curve \[bytes\]: a hundred thousand points.
const LARGEST: u64 = 10_000_000;

/// A row of the reference curve in solver units.
pub(super) struct Row {
    pub x: f64,
    pub y: f64,
    /// Whether it lies inside the spec's range.
    pub judged: bool,
}

/// The curve of a spec, the rows that have both values.
pub(super) fn read(spec: &Spec, x: &Column, y: &Column) -> Result<Vec<Row>, CompareError> {
    let path = &spec.reference;
    let file = File::open(path).map_err(|source| CompareError::Read { path: path.clone(), source })?;
    if file.metadata().is_ok_and(|about| about.len() > LARGEST) {
        let source =
            io::Error::new(io::ErrorKind::FileTooLarge, format!("it is larger than {} MB", LARGEST / 1_000_000));
        return Err(CompareError::Read { path: path.clone(), source });
    }
    let in_file = |source| CompareError::Csv { path: path.clone(), source };
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(file);
    let headers = reader.headers().map_err(in_file)?.clone();
    if let (1, Some(found)) = (headers.len(), headers[0].chars().find(|c| matches!(c, ';' | '\t'))) {
        return Err(CompareError::Separator { path: path.clone(), found });
    }
    let find = |name: &str| {
        headers.iter().position(|h| h == name).ok_or_else(|| CompareError::Column {
            path: path.clone(),
            column: name.to_owned(),
            found: headers.iter().collect::<Vec<_>>().join(", "),
        })
    };
    let (x_column, y_column) = (find(&spec.x)?, find(&spec.y)?);
    let (x_factor, y_factor) = (factor(spec, &spec.x, x)?, factor(spec, &spec.y, y)?);
    let (low, high) = spec.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));

    let mut points = Vec::new();
    for (i, row) in reader.records().enumerate() {
        let row = row.map_err(in_file)?;
        let value = |column: usize| -> Result<Option<f64>, CompareError> {
            match row.get(column).unwrap_or("") {
                "" => Ok(None),
                text => text.parse().map(Some).map_err(|_| CompareError::Number {
                    path: path.clone(),
                    row: i + 1,
                    column: headers[column].to_owned(),
                    text: text.to_owned(),
                }),
            }
        };
        if let (Some(x), Some(y)) = (value(x_column)?, value(y_column)?) {
            points.push(Row { x: x * x_factor, y: y * y_factor, judged: (low..=high).contains(&x) });
        }
    }
    if !points.iter().any(|row| row.judged) {
        return Err(CompareError::Empty { path: path.clone(), x: spec.x.clone(), y: spec.y.clone() });
    }
    Ok(points)
}

/// What converts a column of the file to the unit of the computed column.
fn factor(spec: &Spec, header: &str, computed: &Column) -> Result<f64, CompareError> {
    let path = || spec.reference.clone();
    let (unit, factor) = Unit::of_header(header).map_err(|error| CompareError::Unit { path: path(), error })?;
    if unit == computed.unit {
        Ok(factor)
    } else {
        Err(CompareError::Dimension {
            path: path(),
            column: header.to_owned(),
            with: computed.axis().text().to_owned(),
        })
    }
}
