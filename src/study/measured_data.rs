//! Measured data: columns of a CSV file, or of a program, whose names end with their units.

use super::StudyError;
use crate::case::files::{self, Disk, Files};
use crate::table::{Csv, CsvError};
use std::fmt;
use std::path::{Path, PathBuf};

/// A table of measured numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasuredData {
    /// A CSV file.
    File(PathBuf),
    /// Columns of a program, and their name.
    Columns(String, Csv),
}

impl MeasuredData {
    /// Takes columns by their names.
    ///
    /// # Errors
    /// When there is none, or they differ in length.
    pub fn columns(name: &str, columns: &[(String, Vec<f64>)]) -> Result<Self, StudyError> {
        let help = "give columns by names that end with their units: travel_mm, force_kN";
        let csv = Csv::of_columns(columns, name, help).map_err(|error| csv_error(name, &error))?;
        Ok(Self::Columns(name.to_owned(), csv))
    }

    /// Reads the table; messages end with `example`.
    ///
    /// # Errors
    /// When it cannot be read or is no table of numbers.
    pub(super) fn table(&self, example: &str) -> Result<Csv, StudyError> {
        match self {
            Self::Columns(_, csv) => Ok(csv.clone()),
            Self::File(path) => {
                let disk: &dyn Files = &Disk;
                let text = disk.text(path, files::CSV).map_err(|error| {
                    let help = error.remedy("give the path of a CSV file");
                    StudyError::new(format!("cannot read {self}: {error}"), help)
                })?;
                Csv::read(&text, "the file", example).map_err(|error| csv_error(&self.to_string(), &error))
            }
        }
    }

    /// The file, or the name as a path.
    pub fn path(&self) -> &Path {
        match self {
            Self::File(path) => path,
            Self::Columns(name, _) => Path::new(name),
        }
    }
}

pub(super) fn csv_error(name: &str, error: &CsvError) -> StudyError {
    let line = error.line.map_or_else(String::new, |line| format!(", line {line}"));
    StudyError::new(format!("{name}{line}: {}", error.what), error.help.clone())
}

impl From<PathBuf> for MeasuredData {
    fn from(path: PathBuf) -> Self {
        Self::File(path)
    }
}

impl fmt::Display for MeasuredData {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.path().display().fmt(f)
    }
}
