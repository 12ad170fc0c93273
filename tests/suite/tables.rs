//! Tables in memory, and CSV files that are read.

use crate::common::prelude::*;
use stampflow::table::{Column, CsvError, Unit};

fn column(key: &'static str, label: &'static str, unit: Unit) -> Column {
    Column::new(key, label, unit, vec![1.0, 2.0])
}

#[test]
fn header_and_axis_name_the_same_quantity_and_unit() {
    for (unit, header, axis) in [
        (Unit::N, "punch_force_N", "Punch force [N]"),
        (Unit::NPerMm, "punch_force_N_per_mm", "Punch force [N/mm]"),
        (Unit::None, "punch_force", "Punch force [–]"),
        (Unit::MPa, "punch_force_MPa", "Punch force [MPa]"),
    ] {
        let c = column("punch_force", "Punch force", unit);
        assert_eq!(c.header(), header);
        assert_eq!(c.axis().text(), axis);
    }
}

fn read(text: &str) -> Result<Csv, CsvError> {
    Csv::read(text, "the file", "write r_mm,z_mm")
}

#[test]
fn rows_know_their_lines_between_comments_and_empty_lines() {
    let csv = read("# of a test\n\nr_mm , z_in\n0,1\n\n# between\n# two\n\"2\",\n  3 , 4\n").unwrap();
    assert_eq!(csv.header.line, 3);
    let rows: Vec<_> = csv.rows.iter().map(|row| (row.line, row.number(0), row.number(1))).collect();
    let number = |value: f64| Ok(Some(value));
    assert_eq!(rows, [(4, number(0.0), number(1.0)), (8, number(2.0), Ok(None)), (9, number(3.0), number(4.0))]);
    assert_eq!((csv.column("z_in"), csv.unit(1)), (Some(1), Ok((Unit::Mm, 25.4))));
}
