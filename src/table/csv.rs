//! CSV files that are read: `#` comments, a line of column names that end in their units, rows of numbers.

use super::Unit;
use csv::StringRecord;

const MOST: usize = 100_000;
/// Longest quotation from a file \[characters\].
const LONGEST: usize = 40;
const DECIMALS: &str = "write decimals with a point, not a comma: 30.5";

/// Column names and rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Csv {
    /// At least one name.
    pub header: Record,
    /// Lines below the header.
    pub rows: Vec<Record>,
}

/// Fields of one line.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Number, from 1.
    pub line: usize,
    /// Texts between the commas.
    pub fields: StringRecord,
}

/// Reason why a text is no table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct CsvError {
    /// Line, from 1; `None` where the text as a whole is no table.
    pub line: Option<usize>,
    /// Mistake.
    pub what: String,
    /// Remedy.
    pub help: String,
}

fn refused<T>(line: impl Into<Option<usize>>, what: impl Into<String>, help: &str) -> Result<T, CsvError> {
    Err(CsvError { line: line.into(), what: what.into(), help: help.to_owned() })
}

impl Csv {
    /// Reads a text. Messages call it by `name`, as in "the profile file", and end with `example`, a correct header.
    /// Fails if there are only comments, the first line names no columns, a row is longer than it, or the size limits are exceeded.
    pub fn read(text: &str, name: &str, example: &str) -> Result<Self, CsvError> {
        let mut reader = csv::ReaderBuilder::new();
        reader.comment(Some(b'#')).trim(csv::Trim::All).flexible(true).has_headers(false);
        let records = reader.from_reader(text.as_bytes()).into_records().take(MOST + 2);
        let rows = records.map(|fields| fields.map(|fields| Record { line: line_of(&fields, text), fields }));
        let mut rows = rows.collect::<Result<Vec<_>, _>>().or_else(|error| {
            let line = error.position().map_or(1, |position| position.line() as usize);
            refused(line, format!("this is not CSV: {error}"), example)
        })?;
        if let Some(row) = rows.get(MOST + 1) {
            return refused(row.line, format!("there are more than {MOST} rows"), "thin them out");
        }
        if rows.is_empty() {
            return refused(1, format!("{name} is empty"), example);
        }
        let header = rows.remove(0);
        header.names_columns(rows.first(), name, example)?;
        let columns = header.fields.len();
        if let Some(row) = rows.iter().find(|row| row.fields.len() > columns) {
            return refused(row.line, format!("{} numbers stand under {columns} columns", row.fields.len()), DECIMALS);
        }
        Ok(Self { header, rows })
    }

    /// Number of the column of that name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.fields.iter().position(|field| field == name)
    }

    /// Names of all columns, for a message.
    pub fn names(&self) -> String {
        self.header.fields.iter().collect::<Vec<_>>().join(", ").chars().take(10 * LONGEST).collect()
    }

    /// Unit that a column's name ends in, and the factor to it. Fails if it ends in no known unit.
    pub fn unit(&self, column: usize) -> Result<(Unit, f64), String> {
        Unit::of_header(self.header.fields.get(column).unwrap_or(""))
    }
}

impl Record {
    /// Number in a column; `None` if it is empty. Fails if it is no finite number.
    pub fn number(&self, column: usize) -> Result<Option<f64>, CsvError> {
        let field = self.fields.get(column).unwrap_or("");
        let is = match field.parse::<f64>() {
            _ if field.is_empty() => return Ok(None),
            Ok(number) if number.is_finite() => return Ok(Some(number)),
            Ok(_) => "no finite number",
            Err(_) => "not a number",
        };
        let help = if field.contains(',') { DECIMALS } else { "write a plain number; its unit stands in the header" };
        refused(self.line, format!("\"{}\" is {is}", self.quoted(column)), help)
    }

    /// Beginning of a column's text, for a message.
    pub fn quoted(&self, column: usize) -> String {
        self.fields.get(column).unwrap_or("").chars().take(LONGEST).collect()
    }

    fn names_columns(&self, first: Option<&Self>, name: &str, example: &str) -> Result<(), CsvError> {
        let is_number = |field: &str| field.parse::<f64>().is_ok();
        if self.fields.iter().all(is_number) {
            return refused(self.line, "the first line must name the columns, found numbers", example);
        }
        let cells = |row: &Self| row.fields.iter().collect::<Vec<_>>().join(";").replace('\t', ";");
        let (names, below) = (cells(self), first.map_or(String::new(), cells));
        let is_name = |text: &str| text.trim().chars().all(|c| c.is_alphanumeric() || c == '_');
        let has_unit = names.split(';').any(|name| Unit::of_header(name.trim()).is_ok());
        if !names.split(';').all(is_name) || !has_unit && !below.split(';').any(is_number) {
            // A message quotes nothing of a file that is something else.
            return refused(None, format!("{name} is no table of numbers: its first line names no columns"), example);
        }
        let is_separated = |(c, _): &(char, _)| self.fields.iter().any(|field| field.contains(*c));
        let mut separators = [(';', "semicolons"), ('\t', "tabs")].into_iter();
        let Some((_, separator)) = separators.find(is_separated) else { return Ok(()) };
        let help = format!("separate columns by commas and write decimals with a point; {example}");
        refused(self.line, format!("the columns are separated by {separator}"), &help)
    }
}

/// Line of a record, whose position is that of the comments before it.
fn line_of(fields: &StringRecord, text: &str) -> usize {
    let Some(position) = fields.position() else { return 1 };
    let skipped = |line: &str| line.trim().is_empty() || line.starts_with('#');
    let before = text.get(position.byte() as usize..).unwrap_or("");
    position.line().max(1) as usize + before.lines().take_while(|line| skipped(line)).count()
}
