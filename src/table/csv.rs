//! CSV files that are read: `#` comments, a line of column names that end in their units, rows of numbers. And columns that a
//! program holds, under the same names and checks.

use super::{Unit, UnitError};
use csv::StringRecord;

/// The most rows a file may have: a hundred times what a curve that is drawn needs.
const MOST: usize = 100_000;

/// The longest line \[bytes\]: hundreds of columns. What a reader keeps of a line is many times its length.
const LONGEST_LINE: usize = 10_000;

/// Longest quotation from a file, in characters.
const LONGEST: usize = 40;

/// A file's column names and rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Csv {
    /// At least one name.
    pub header: Record,
    /// The lines below the header.
    pub rows: Vec<Record>,
    /// What their numbers count: `line` of a text from 1, `row` of columns from 0.
    pub counted: &'static str,
}

/// The fields of one line.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Of a text from 1, of columns from 0.
    pub line: usize,
    /// The texts between the commas.
    pub fields: StringRecord,
}

/// Why a text is no table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct CsvError {
    /// Line of the text, from 1; `None` where the text is something else altogether, and no line of it says more.
    pub line: Option<usize>,
    /// What is wrong.
    pub what: String,
    /// What to write instead.
    pub help: String,
}

impl CsvError {
    fn at(line: usize, what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line: Some(line), what: what.into(), help: help.into() }
    }
}

impl Csv {
    /// Reads a text, once from its first line to its last; messages call it by `name`, as in "the profile file", and end
    /// with `example`, what to write.
    ///
    /// # Errors
    /// When there is nothing but comments, the first line does not name columns, a row is longer than it, there are more
    /// than a hundred thousand rows, or a line has more than ten thousand bytes.
    pub fn read(text: &str, name: &str, example: &str) -> Result<Self, CsvError> {
        if let Some(i) = text.lines().position(|line| line.len() > LONGEST_LINE && !line.starts_with('#')) {
            let what = format!("{name} is no table of numbers: line {} is longer than {LONGEST_LINE} bytes", i + 1);
            return Err(CsvError { line: None, what, help: example.to_owned() });
        }
        let reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .flexible(true)
            .has_headers(false)
            .from_reader(text.as_bytes());
        let mut records = reader.into_records().map(|fields| {
            fields.map(|fields| Record { line: line_of(&fields, text), fields }).map_err(|error| {
                let line = error.position().map_or(1, |p| p.line() as usize);
                CsvError::at(line, format!("this is not CSV: {error}"), example)
            })
        });
        let header = records.next().ok_or_else(|| CsvError::at(1, format!("{name} is empty"), example))??;
        let first = records.next().transpose()?;
        header.names_columns(first.as_ref(), name, example)?;
        let mut rows = Vec::new();
        for row in first.into_iter().map(Ok).chain(records) {
            let row = row?;
            if row.fields.len() > header.fields.len() {
                let what = format!("{} numbers stand under {} columns", row.fields.len(), header.fields.len());
                return Err(CsvError::at(row.line, what, "write decimals with a point, not a comma: 30.5"));
            }
            if rows.len() == MOST {
                return Err(CsvError::at(row.line, format!("there are more than {MOST} rows"), "thin them out"));
            }
            rows.push(row);
        }
        Ok(Self { header, rows, counted: "line" })
    }

    /// Of columns by their names; what is no number is not there. As [`read`](Self::read).
    ///
    /// # Errors
    /// When there is no column, they are not equally long, have more than a hundred thousand rows, or a number is not finite.
    pub fn of_columns(columns: &[(String, Vec<f64>)], name: &str, example: &str) -> Result<Self, CsvError> {
        let wrong = |what: String, help: &str| CsvError { line: None, what, help: help.to_owned() };
        let Some((first, values)) = columns.first() else {
            return Err(wrong(format!("{name} has no columns"), example));
        };
        if let Some((other, few)) = columns.iter().find(|(_, other)| other.len() != values.len()) {
            let what = format!("`{first}` has {} rows, but `{other}` has {}", values.len(), few.len());
            return Err(wrong(what, "give columns of one length"));
        }
        if values.len() > MOST {
            return Err(wrong(format!("there are more than {MOST} rows"), "thin them out"));
        }
        for (header, values) in columns {
            if let Some(row) = values.iter().position(|value| value.is_infinite()) {
                return Err(wrong(format!("row {row} of `{header}` is infinite"), "leave it out, or make it NaN"));
            }
        }
        let header = Record { line: 0, fields: columns.iter().map(|(header, _)| header.as_str()).collect() };
        let cell = |value: f64| if value.is_nan() { String::new() } else { value.to_string() };
        let row = |i: usize| Record { line: i, fields: columns.iter().map(|(_, values)| cell(values[i])).collect() };
        let rows: Vec<Record> = (0..values.len()).map(row).collect();
        header.names_columns(rows.first(), name, example).map_err(|error| CsvError { line: None, ..error })?;
        Ok(Self { header, rows, counted: "row" })
    }

    /// The column of that name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.fields.iter().position(|field| field == name)
    }

    /// The names of all columns.
    pub fn found(&self) -> String {
        quoted(&self.header.fields.iter().collect::<Vec<_>>().join(", "), 10 * LONGEST)
    }

    /// The unit that a column's name ends in, and the factor to it from the numbers below.
    ///
    /// # Errors
    /// When it ends in no known unit.
    pub fn unit(&self, column: usize) -> Result<(Unit, f64), UnitError> {
        Unit::of_header(self.header.fields.get(column).unwrap_or(""))
    }
}

impl Record {
    /// The number in a column, as it is written; `None` when it is empty.
    ///
    /// # Errors
    /// When something else stands there, nan and inf too.
    pub fn number(&self, column: usize) -> Result<Option<f64>, CsvError> {
        let field = self.fields.get(column).unwrap_or("");
        if field.is_empty() {
            return Ok(None);
        }
        let help = match field.contains(',') {
            true => "write decimals with a point, not a comma: 30.5",
            false => "write a plain number; its unit stands in the header",
        };
        let refused = |is: &str| CsvError::at(self.line, format!("\"{}\" is {is}", self.quoted(column)), help);
        match field.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number)),
            Ok(_) => Err(refused("no finite number")),
            Err(_) => Err(refused("not a number")),
        }
    }

    /// The beginning of what stands in a column, for a message.
    pub fn quoted(&self, column: usize) -> String {
        quoted(self.fields.get(column).unwrap_or(""), LONGEST)
    }

    /// Whether this is a line of column names, with `first` below it.
    fn names_columns(&self, first: Option<&Self>, name: &str, example: &str) -> Result<(), CsvError> {
        let fields = || self.fields.iter();
        let is_number = |field: &str| field.parse::<f64>().is_ok();
        if fields().all(is_number) {
            return Err(CsvError::at(self.line, "the first line must name the columns, found numbers", example));
        }
        let separators = [';', '\t'];
        let names = || fields().flat_map(|field| field.split(separators)).map(str::trim);
        let is_name = |text: &str| text.chars().all(|c| c.is_alphanumeric() || c == '_');
        let has_unit = |text: &str| Unit::of_header(text).is_ok();
        let holds_numbers =
            || first.is_some_and(|row| row.fields.iter().flat_map(|f| f.split(separators)).any(is_number));
        if !names().all(is_name) || !names().any(has_unit) && !holds_numbers() {
            // Nothing of a file that is something else is shown but its first word.
            let text: String = fields().collect();
            let word: String = text.chars().take_while(|c| c.is_alphanumeric()).take(LONGEST / 2).collect();
            let what =
                format!("{name} is no table of numbers: its first line names no columns, it begins with \"{word}\"");
            return Err(CsvError { line: None, what, help: example.to_owned() });
        }
        if let Some(separator) = fields().flat_map(str::chars).find(|c| separators.contains(c)) {
            let separator = if separator == ';' { "semicolons" } else { "tabs" };
            let help = format!("separate columns by commas and write decimals with a point; {example}");
            return Err(CsvError::at(self.line, format!("the columns are separated by {separator}"), help));
        }
        Ok(())
    }
}

/// The line that a record stands in: its position is that of the comments before it.
fn line_of(fields: &StringRecord, text: &str) -> usize {
    let Some(position) = fields.position() else { return 1 };
    let skipped = |line: &str| line.trim().is_empty() || line.starts_with('#');
    let before = text.get(position.byte() as usize..).unwrap_or("");
    position.line().max(1) as usize + before.lines().take_while(|line| skipped(line)).count()
}

/// The beginning of a text.
fn quoted(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}
