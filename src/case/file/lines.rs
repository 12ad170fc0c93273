//! CSV file that a case names: its rows, and errors that show their lines.

use crate::case::files;
use crate::case::{CaseError, source::Source};
use crate::table::{Csv, CsvError, Record};
use miette::NamedSource;
use std::io::ErrorKind;
use std::path::Path;
use std::sync::Arc;

pub struct Named<'a> {
    pub file: &'a str,
    /// Content, as in "the profile file".
    pub what: &'static str,
    /// Example of its lines.
    pub example: &'static str,
    pub key: &'a str,
}

pub struct Lines {
    shown: Arc<NamedSource<String>>,
    key: String,
}

impl Named<'_> {
    pub fn open(&self, source: &Source) -> Result<(Lines, Csv), CaseError> {
        let path = source.folder.path.join(self.file);
        self.first(&[&path], source)?.map(|(_, lines, csv)| (lines, csv)).ok_or_else(|| {
            let what = format!("the {} file \"{}\" is not there", self.what, self.file);
            source.error(self.key, what, format!("put it at {}", path.display()))
        })
    }

    /// Reads the first of some files that exists.
    pub fn first<'p>(&self, paths: &[&'p Path], source: &Source) -> Result<Option<(&'p Path, Lines, Csv)>, CaseError> {
        for &path in paths {
            let text = match source.folder.files.text(path, files::CSV) {
                Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::IsADirectory) => continue,
                text => text.map_err(|error| {
                    let what = format!("the {} file \"{}\" cannot be read: {error}", self.what, self.file);
                    source.error(self.key, what, "save it as CSV in UTF-8")
                })?,
            };
            let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
            let shown = Arc::new(NamedSource::new(path.display().to_string(), text));
            let lines = Lines { shown: shown.clone(), key: self.key.to_owned() };
            return match Csv::read(shown.inner(), &format!("the {} file", self.what), self.example) {
                Ok(csv) => Ok(Some((path, lines, csv))),
                Err(CsvError { line: None, what, help }) => Err(source.error(self.key, what, help)),
                Err(CsvError { line: Some(line), what, help }) => Err(lines.error(line, what, help)),
            };
        }
        Ok(None)
    }
}

impl Lines {
    /// Error at a line, from 1.
    pub fn error(&self, line: usize, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        let inner = self.shown.inner();
        let start = inner.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        let length = inner[start..].lines().next().map_or(0, str::len);
        let label = format!("line {line} of {}", self.key);
        CaseError::at(self.shown.clone(), start..start + length, what.into(), label, help.into())
    }

    /// Number in a column of a row; `None` if it is empty.
    pub fn number(&self, row: &Record, column: usize) -> Result<Option<f64>, CaseError> {
        row.number(column).map_err(|CsvError { line, what, help }| self.error(line.unwrap_or(1), what, help))
    }
}
