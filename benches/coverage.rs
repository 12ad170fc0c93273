//! Whether the error bars hold what they promise: random dies, each verified, against a truth that is eight times finer.
//!
//! `cargo bench --bench coverage -- --count 300 --seed 7`; `--raw` also prints every number on every level.
//!
//! # Truth
//! Each direction on its own is refined eight times, and the deviations from the run as it is are summed: to the first
//! order that is a run that is finer in all directions at once, which would cost five hundred times as much.

#[allow(dead_code, reason = "another bench and tests use the rest")]
#[path = "../tests/suite/common/coverage.rs"]
mod coverage;
#[allow(dead_code, reason = "the campaign prints the process and the description")]
#[path = "../tests/suite/common/random_die.rs"]
mod random_die;

use coverage::{Checked, case_of, check};
use rayon::prelude::*;
use stampflow::study::verify::Direction;

fn main() {
    let (count, seed) = (argument("--count", 300), argument("--seed", 7));
    let seeds: Vec<u64> = (0..count).map(|i| seed * 1_000_003 + i).collect();
    let checked: Vec<Checked> =
        seeds.par_iter().map(|seed| check(case_of(random_die::random_die(*seed).model))).collect();
    if std::env::args().any(|a| a == "--raw") {
        for (seed, checked) in seeds.iter().zip(&checked) {
            print_raw(checked, *seed);
        }
    }
    println!("{count} random dies, seed {seed}\n");
    println!("{}", markdown(&tally(&checked)));
}

/// A number given on the command line.
fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}

/// Every number with its levels, for a look at them.
fn print_raw(checked: &Checked, seed: u64) {
    let base = &checked.outcomes[0];
    for number in &base.numbers {
        let all = checked.outcomes.iter().chain(&checked.finest).skip(1);
        let runs = all.map(|run| {
            let direction = run.direction.map_or_else(String::new, Direction::key);
            let value = run.value(number).map_or_else(|| "none".to_owned(), |v| format!("{v:.10e}"));
            let alike = if run.end.is_like(&base.end) { "" } else { "!" };
            format!("{direction}:{}:{alike}{value}", run.times)
        });
        let runs: Vec<String> = runs.collect();
        println!(
            "raw {seed} {:?} {} {:.10e} {} {}",
            number.origin,
            number.quantity.key,
            number.quantity.amount.value,
            base.end.kind.replace(' ', "_"),
            runs.join(" ")
        );
    }
}

/// As a table of Markdown.
fn markdown(rows: &[Row]) -> String {
    let mut text = "| number | dies | inside | bar / true error | no bar |\n|---|---:|---:|---:|---:|\n".to_owned();
    for row in rows {
        let (dies, inside) = (row.ratios.len(), 100.0 * share(row));
        text += &format!("| {} | {dies} | {inside:.1} % | {:.1} | {} |\n", row.name, median(row), row.without);
    }
    text
}

/// Median of bar over true error \[–\].
fn median(row: &Row) -> f64 {
    row.ratios.get(row.ratios.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Share of the bars with the truth inside \[–\].
fn share(row: &Row) -> f64 {
    row.inside as f64 / row.ratios.len().max(1) as f64
}

/// How often the truth lies inside the bars of a number, and how long these are.
#[derive(Default)]
struct Row {
    name: String,
    without: usize,
    inside: usize,
    /// Bar over true error, of each die that has both.
    ratios: Vec<f64>,
}

/// A row for every number that has bars; places and travels have none.
fn tally(checked: &[Checked]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for (number, truth) in checked.iter().flat_map(Checked::with_truth) {
        let label = number.quantity.label;
        let i = rows.iter().position(|row| row.name == label).unwrap_or_else(|| {
            rows.push(Row { name: label.to_owned(), ..Row::default() });
            rows.len() - 1
        });
        let error = (truth - number.quantity.amount.value).abs();
        match number.half() {
            None => rows[i].without += 1,
            Some(half) => {
                rows[i].inside += usize::from(error <= half);
                // What nothing moves has no bar, and needs none.
                rows[i].ratios.push(if half == error { 1.0 } else { half / error });
            }
        }
    }
    rows.retain(|row| !row.ratios.is_empty());
    rows.iter_mut().for_each(|row| row.ratios.sort_by(f64::total_cmp));
    rows
}
