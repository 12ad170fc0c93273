//! A CSV file that a case names: its lines, and errors that show them.

use crate::case::{CaseError, source::Source};
use csv::StringRecord;
use miette::NamedSource;
use std::path::Path;
use std::sync::Arc;

/// The text of a file, and the key that names it.
pub(super) struct Lines {
    shown: Arc<NamedSource<String>>,
    key: String,
    /// What it holds, as in "the profile file".
    what: &'static str,
}

impl Lines {
    /// Reads `file`, named at the key `key`, from the case file's folder.
    pub fn open(file: &str, what: &'static str, key: &str, folder: &Path, source: &Source) -> Result<Self, CaseError> {
        let path = folder.join(file);
        if !path.is_file() {
            let what = format!("the {what} file \"{file}\" is not there");
            return Err(source.error(key, what, format!("put it at {}", path.display())));
        }
        let text = std::fs::read_to_string(&path).map_err(|error| {
            let what = format!("the {what} file \"{file}\" cannot be read: {error}");
            source.error(key, what, "save it as CSV in UTF-8")
        })?;
        let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
        let shown = Arc::new(NamedSource::new(path.display().to_string(), text));
        Ok(Self { shown, key: key.to_owned(), what })
    }

    /// An error at a line, from 1.
    pub fn error(&self, line: usize, what: String, help: impl Into<String>) -> CaseError {
        let inner = self.shown.inner();
        let start = inner.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        let length = inner[start..].lines().next().map_or(0, str::len);
        let label = format!("line {line} of {}", self.key);
        CaseError::at(self.shown.clone(), start..start + length, what, label, help.into())
    }

    /// The header and the rows, each with its line; `example` is what such a file looks like.
    pub fn records(&self, example: &str) -> Result<(Record, Vec<Record>), CaseError> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .flexible(true)
            .has_headers(false)
            .from_reader(self.shown.inner().as_bytes());
        let mut records = Vec::new();
        for fields in reader.records() {
            let fields = fields.map_err(|error| {
                let line = error.position().map_or(1, |p| p.line() as usize);
                self.error(line, format!("this is not CSV: {error}"), example)
            })?;
            let line = self.line_of(&fields);
            records.push(Record { line, fields });
        }
        if records.is_empty() {
            return Err(self.error(1, format!("the {} file is empty", self.what), example));
        }
        let header = records.remove(0);
        if let Some(separator) = header.fields.iter().flat_map(str::chars).find(|c| matches!(c, ';' | '\t')) {
            let name = if separator == ';' { "semicolons" } else { "tabs" };
            let help = format!("separate columns by commas and write decimals with a point; {example}");
            return Err(self.error(header.line, format!("the columns are separated by {name}"), help));
        }
        if header.fields.iter().all(|field| field.parse::<f64>().is_ok()) {
            let what = "the first line must name the columns, found numbers".into();
            return Err(self.error(header.line, what, example));
        }
        if let Some(row) = records.iter().find(|row| row.fields.len() > header.fields.len()) {
            let what = format!("{} numbers stand under {} columns", row.fields.len(), header.fields.len());
            return Err(self.error(row.line, what, "write decimals with a point, not a comma: 30.5"));
        }
        Ok((header, records))
    }

    /// The line that a record stands in: its position is that of the comments before it.
    fn line_of(&self, record: &StringRecord) -> usize {
        let from = record.position().map_or(1, |p| p.line() as usize).max(1);
        let skipped = |line: &str| line.trim().is_empty() || line.starts_with('#');
        from + self.shown.inner().lines().skip(from - 1).take_while(|line| skipped(line)).count()
    }

    /// The number in a column of a row; `None` when it is empty.
    pub fn number(&self, row: &Record, column: usize) -> Result<Option<f64>, CaseError> {
        let field = row.fields.get(column).unwrap_or("");
        if field.is_empty() {
            return Ok(None);
        }
        let help = match field.contains(',') {
            true => "write decimals with a point, not a comma: 30.5",
            false => "write a plain number; its unit stands in the header",
        };
        let number = field.parse().map_err(|_| self.error(row.line, format!("\"{field}\" is not a number"), help))?;
        Ok(Some(number))
    }
}

/// One line's fields.
pub(super) struct Record {
    /// From 1.
    pub line: usize,
    pub fields: StringRecord,
}
