//! Cases, variants and measurements side by side: differences against their errors, pictures, misfits, wrong input.

use crate::common::prelude::*;
use stampflow::study::{Cell, compare::Candidate, compare::SideBySide, compare::variant};

fn side_by_side(variants: &[&str]) -> SideBySide {
    let candidate =
        |own: Vec<String>| Candidate { case: case::parse(CUP, "cup.toml", &own).expect("a case"), overrides: own };
    let own = variants.iter().map(|text| variant(text).expect("overrides"));
    let all: Vec<Candidate> = std::iter::once(Vec::new()).chain(own).map(candidate).collect();
    SideBySide::solve(&all, Vec::new(), None, 2, &()).expect("solved")
}

/// Trust: friction raises the force by far more than bars of 2 % leave open, a millionth of it does not.
#[test]
fn a_difference_is_beyond_the_error_bars_or_within_them() {
    let all = side_by_side(&["friction=0.2", "friction=0.08001"]);
    let table = all.table();
    let rows: Vec<&Vec<Cell>> = table.rows.iter().filter(|row| row[0].to_string() == "Punch force").collect();
    let beyond: Vec<String> = rows.iter().map(|row| row[4].to_string()).collect();
    assert_eq!(beyond, ["", "yes", "no"]);
    let [a, b] = [0, 1].map(|i| peak(&all.members[i].solution.stages[0]));
    let Cell::Amount(by) = &rows[1][3] else { panic!("a number") };
    assert!((by.value - (b - a)).abs() < 1e-9 * b && b > 1.05 * a, "{a} {b}");
}

/// Trust: a run's own tables laid over it are what it computed, but for the digits that a table has.
#[test]
fn a_runs_own_tables_lie_on_its_curves() {
    let dir = folder(CUP);
    ends(&stampflow(dir.path(), &["run", "cases/cup.toml", "--quiet", "--out", "r"]), 0, "");
    let args = ["compare", "cases/cup.toml", "r/load_travel.csv", "r/profile.csv", "--json", "--out", "c"];
    let done = stampflow(dir.path(), &args);
    ends(&done, 0, "");
    let value: Value = serde_json::from_slice(&done.stdout).expect("JSON");
    let rows = value["tables"][0]["rows"].as_array().expect("rows");
    let misfits: Vec<f64> = rows
        .iter()
        .filter(|row| row[0].as_str().is_some_and(|label| label.starts_with("Misfit")))
        .map(|row| row[2]["value"].as_f64().expect("a number"))
        .collect();
    // Trust: nine digits are written of forces of 10 kN and of thicknesses of 1 mm.
    assert!(misfits.len() == 2 && misfits[0] < 1.0 && misfits[1] < 1e-6, "{misfits:?}");
    for file in value["files"].as_array().expect("files") {
        assert!(dir.path().join(file.as_str().expect("a path")).is_file(), "{file}");
    }
}
