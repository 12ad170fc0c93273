//! Digits that a run prints of each kind of number, held against fully verified error bars of all shipped cases.
//!
//! `benches/measured.sh digits`

#[allow(dead_code, reason = "this bench needs no truth")]
#[path = "../tests/suite/common/coverage.rs"]
mod coverage;

use coverage::last_digits;
use std::collections::BTreeMap;

/// Units of the last digit within which it counts as sure \[–\].
const SURE: f64 = 2.0;

fn main() {
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/cases")).expect("the shipped cases").flatten();
    let mut files: Vec<_> = files.map(|file| file.path()).filter(|path| path.extension().is_some()).collect();
    files.sort();
    let mut rows: BTreeMap<&str, Vec<(f64, String)>> = BTreeMap::new();
    for path in files {
        for (label, text, units) in last_digits(stampflow::case::load(path, &[]).expect("valid")) {
            rows.entry(label).or_default().push((units, text));
        }
    }
    println!("| number | cases | printed, such as | bar in units of the last digit, median | sure within two |");
    println!("|---|---:|---|---:|---:|");
    for (label, mut found) in rows {
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let sure = found.iter().filter(|(units, _)| *units <= SURE).count();
        let (units, text) = &found[found.len() / 2];
        println!("| {label} | {} | {text} | {units:.1} | {sure} |", found.len());
    }
}
