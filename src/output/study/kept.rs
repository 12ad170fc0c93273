//! Curves of designs, kept beside the table of a study: two files for each, by its index.
//!
//! They are written whole before the design's row is, so that a row that is there has its curves after any end, and
//! shards that write into one folder have files of their own.

use crate::results::{WriteError, csv, write};
use crate::study::Row;
use crate::study::verify::Of;
use crate::table::{Column, Table, Unit};
use std::path::{Path, PathBuf};

/// The folder beside the table.
const FOLDER: &str = "curves";

/// The load curve of a design, beside a table in `dir`.
pub fn load_file(dir: &Path, index: u64) -> PathBuf {
    dir.join(FOLDER).join(format!("load_{index:06}.csv"))
}

/// The thickness of a design, likewise.
pub fn thickness_file(dir: &Path, index: u64) -> PathBuf {
    dir.join(FOLDER).join(format!("thickness_{index:06}.csv"))
}

/// Writes the curves of a design: the punch force over the travel, and the thickness over the initial distance from the
/// axis; files without rows where it has none.
///
/// # Errors
/// When a file cannot be written.
pub fn keep(dir: &Path, row: &Row) -> Result<(), WriteError> {
    let outcome = row.result.as_ref().ok().map(|solved| &solved.outcome);
    let numbers = outcome.into_iter().flat_map(|outcome| &outcome.numbers);
    let force = numbers.into_iter().find(|number| number.of == Of::Answer && number.key == "punch_force");
    let unit = force.map_or(Unit::N, |number| number.amount.unit);
    let [load, thickness] = outcome.map_or([&[][..], &[]], |outcome| [&outcome.load, &outcome.thickness]);
    let of = |points: &[(f64, f64)], x: (&'static str, Unit), y: (&'static str, Unit)| {
        let (along, up) = points.iter().copied().unzip();
        csv(&Table::new(vec![Column::new(x.0, x.0, x.1, along), Column::new(y.0, y.0, y.1, up)]))
    };
    write(&load_file(dir, row.design.index), &of(load, ("travel", Unit::Mm), ("punch_force", unit)))?;
    write(&thickness_file(dir, row.design.index), &of(thickness, ("s0", Unit::Mm), ("thickness", Unit::Mm)))
}

/// The load curves of so many designs, from the first; those that are not there are empty.
pub fn kept_loads(dir: &Path, designs: u64) -> Vec<Vec<(f64, f64)>> {
    (0..designs).map(|index| read(&load_file(dir, index)).unwrap_or_default()).collect()
}

fn read(path: &Path) -> Option<Vec<(f64, f64)>> {
    let text = std::fs::read_to_string(path).ok()?;
    let mut lines = text.lines();
    lines.next()?;
    let point = |line: &str| {
        let (x, y) = line.split_once(',')?;
        Some((x.parse().ok()?, y.parse().ok()?))
    };
    Some(lines.filter_map(point).collect())
}
