//! Exports of testing machines: separators, decimal commas, lines above the table, units, names in three languages.

use crate::table::{Csv, CsvError, Record};
use csv::StringRecord;

/// Names of columns with words of the trade, the more special first.
const NAMES: [(&str, &[&str]); 7] = [
    ("rate", &["rate", "geschw", "vitesse"]),
    ("width_strain", &["quer", "breite", "width", "transvers", "largeur"]),
    ("force", &["kraft", "force", "load", "charge"]),
    ("engineering_stress", &["spannung", "contrainte", "stress"]),
    ("engineering_strain", &["dehnung", "formation", "strain"]),
    ("crosshead", &["traverse", "crosshead"]),
    ("elongation", &["weg", "änderung", "längerung", "formung", "longement", "placement", "longation", "extension"]),
];
/// Spellings in lower case, each with its unit.
const UNITS: &str = "% percent, n/mm² MPa, n/mm2 MPa, n/mm^2 MPa, mpa MPa, gpa GPa, kn kN, n N, mm mm";

/// Text of a file in UTF-8 or Windows-1252, whose letters beyond ASCII are those of Unicode's first 256.
pub fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| error.into_bytes().into_iter().map(char::from).collect())
}

/// Reads a test as this program has it, or as a testing machine exports it; messages end with `example`, a correct header.
pub fn read(text: &str, example: &str) -> Result<Csv, CsvError> {
    let text = text.trim_start_matches('\u{feff}');
    Csv::read(text, "the test", example).or_else(|error| export(text).ok_or(error))
}

fn export(text: &str) -> Option<Csv> {
    let delimiter = *[b';', b'\t', b','].iter().find(|one| text.as_bytes().contains(one))?;
    let mut reader = csv::ReaderBuilder::new();
    reader.delimiter(delimiter).trim(csv::Trim::All).flexible(true).has_headers(false);
    let lines: Vec<StringRecord> = reader.from_reader(text.as_bytes()).into_records().collect::<Result<_, _>>().ok()?;
    let point = |cell: &str| match delimiter {
        b',' => cell.to_owned(),
        _ if cell.contains(',') => cell.replace(['.', ' ', '\u{a0}'], "").replace(',', "."),
        _ => cell.to_owned(),
    };
    let is_row = |row: &StringRecord| {
        row.len() > 1 && row.iter().all(|cell| cell.is_empty() || point(cell).parse::<f64>().is_ok())
    };
    let first = lines.windows(2).position(|pair| pair.iter().all(is_row))?;
    let units = lines.get(first.checked_sub(1)?)?;
    let has_units =
        units.iter().filter(|cell| unit(cell).is_some()).count() > 1 && !units.iter().any(|cell| kind(cell).is_some());
    let names = if has_units { lines.get(first.checked_sub(2)?)? } else { units };
    let kinds: Vec<Option<&str>> = names.iter().map(kind).collect();
    let header = names.iter().zip(&kinds).enumerate().map(|(i, (name, kind))| {
        let unit = if has_units { unit(units.get(i).unwrap_or("")) } else { unit(name) };
        let name = match (*kind, unit) {
            (Some("crosshead"), _) if !kinds.contains(&Some("elongation")) => "elongation",
            (Some("engineering_strain"), Some("mm")) => "elongation",
            (Some("elongation"), Some("percent")) => "engineering_strain",
            (Some(kind), _) => kind,
            (None, _) => name,
        };
        [name, unit.unwrap_or("")].join("_").trim_end_matches('_').to_owned()
    });
    let line = |row: &StringRecord| row.position().map_or(1, |position| position.line() as usize);
    let header = Record { line: line(names), fields: header.collect() };
    let rows = lines[first..].iter().map(|row| Record { line: line(row), fields: row.iter().map(point).collect() });
    Some(Csv { header, rows: rows.collect() })
}

fn kind(name: &str) -> Option<&'static str> {
    let name = name.to_lowercase();
    let is_true = ["wahr", "vrai", "true"].iter().any(|word| name.contains(word));
    let (kind, _) = NAMES.iter().find(|(_, words)| words.iter().any(|word| name.contains(word)))?;
    Some(match *kind {
        "engineering_stress" if is_true => "true_stress",
        "engineering_strain" if is_true => "true_strain",
        kind => kind,
    })
}

/// Unit at the end of a cell: `Kraft [kN]`, `Weg in mm`, `(%)`.
fn unit(cell: &str) -> Option<&'static str> {
    let words = cell.to_lowercase();
    let last = words.split(|c: char| c.is_whitespace() || "[]()_,".contains(c)).rfind(|word| !word.is_empty())?;
    UNITS.split(", ").filter_map(|unit| unit.split_once(' ')).find(|(own, _)| *own == last).map(|(_, unit)| unit)
}
