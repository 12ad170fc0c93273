//! Comma-separated text of tables.

use crate::table::{Column, Table};
use crate::units::{parse, rounded};

/// Writes a header row (`punch_force_N`) and one row per value with nine significant digits; empty cells are not finite.
pub fn csv(table: &Table) -> Vec<u8> {
    csv_with_texts(table, &[])
}

pub(super) fn csv_with_texts(table: &Table, texts: &[(&str, Vec<String>)]) -> Vec<u8> {
    let cells = |c: &Column| std::iter::once(c.header()).chain(c.values.iter().map(|v| number(*v))).collect();
    let mut columns: Vec<Vec<String>> = table.columns.iter().map(cells).collect();
    let texts = texts.iter().map(|(header, entries)| [&[(*header).to_owned()], &entries[..]].concat());
    let first = columns.len().min(1);
    columns.splice(first..first, texts);
    records((0..=table.rows()).map(|i| columns.iter().map(|column| &column[i]).collect::<Vec<_>>()))
}

/// Writes rows of cells; an apostrophe stands before text that a spreadsheet would run (OWASP, CSV Injection).
pub(crate) fn records<R: IntoIterator<Item = C>, C: AsRef<str>>(rows: impl IntoIterator<Item = R>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let is_formula = |cell: &str| cell.starts_with(['=', '@', '+', '-', '\t', '\'']) && parse(cell).is_err();
    let inert = |cell: C| [if is_formula(cell.as_ref()) { "'" } else { "" }, cell.as_ref()].concat();
    rows.into_iter().for_each(|row| writer.write_record(row.into_iter().map(inert)).expect("memory takes every row"));
    writer.into_inner().expect("memory takes every row")
}

pub(crate) fn number(value: f64) -> String {
    let value = rounded(value);
    match value.abs() {
        size if !size.is_finite() => String::new(),
        size if size == 0.0 || (1e-4..1e9).contains(&size) => format!("{value}"),
        _ => format!("{value:e}"),
    }
}
