//! What was measured: columns with their units, of a file or of what a program holds.

use super::StudyError;
use crate::case::files::{self, Disk, Files};
use crate::table::{Csv, CsvError};
use std::fmt;
use std::path::{Path, PathBuf};

/// Columns of numbers, the names of which end with their units.
#[derive(Clone, Debug, PartialEq)]
pub enum Readings {
    /// A CSV file.
    File(PathBuf),
    /// What a program holds, and what it is called.
    Held(String, Csv),
}

impl Readings {
    /// Columns of numbers by their names, of what is called so; what is not a number is not there.
    ///
    /// # Errors
    /// When there is no column, they are not equally long, or no table of numbers.
    pub fn held(called: &str, columns: &[(String, Vec<f64>)]) -> Result<Self, StudyError> {
        let csv =
            Csv::of_columns(columns, called, "give columns by names that end with their units: travel_mm, force_kN");
        csv.map(|csv| Self::Held(called.to_owned(), csv)).map_err(|error| refused(called, &error))
    }

    /// Reads the table; messages end with `example`.
    ///
    /// # Errors
    /// When it cannot be read, with what to give in its place, or is no table of numbers.
    pub(super) fn table(&self, give: &str, example: &str) -> Result<Csv, StudyError> {
        match self {
            Self::Held(_, csv) => Ok(csv.clone()),
            Self::File(path) => {
                let disk: &dyn Files = &Disk;
                let text = disk
                    .text(path, files::CSV)
                    .map_err(|error| StudyError::new(format!("cannot read {self}: {error}"), error.remedy(give)))?;
                Csv::read(&text, "the file", example).map_err(|error| refused(&self.to_string(), &error))
            }
        }
    }

    /// The file; what a program holds by what it is called.
    pub fn path(&self) -> &Path {
        match self {
            Self::File(path) => path,
            Self::Held(called, _) => Path::new(called),
        }
    }
}

/// What is no table of numbers.
pub(super) fn refused(called: &str, error: &CsvError) -> StudyError {
    let line = error.line.map_or_else(String::new, |line| format!(", line {line}"));
    StudyError::new(format!("{called}{line}: {}", error.what), error.help.clone())
}

impl From<PathBuf> for Readings {
    fn from(path: PathBuf) -> Self {
        Self::File(path)
    }
}

impl From<&Path> for Readings {
    fn from(path: &Path) -> Self {
        Self::File(path.to_owned())
    }
}

impl fmt::Display for Readings {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.path().display().fmt(f)
    }
}
