//! Whether the error bars hold what they promise: random dies, each verified, against a truth that is eight times finer.
//!
//! `cargo bench --bench coverage -- --count 300 --seed 7`; `--raw` also prints every number on every level.
//!
//! # Truth
//! Each direction on its own is refined eight times, and the deviations from the run as it is are summed: to the first
//! order that is a run that is finer in all directions at once, which would cost five hundred times as much.

#[path = "../tests/suite/common/coverage.rs"]
mod coverage;
#[allow(dead_code, reason = "the campaign prints the process and the description")]
#[path = "../tests/suite/common/random_die.rs"]
mod random_die;

use coverage::{Checked, Tally, case_of, check};
use rayon::prelude::*;
use std::time::Instant;

fn main() {
    let (count, seed) = (argument("--count", 300), argument("--seed", 7));
    let start = Instant::now();
    let seeds: Vec<u64> = (0..count).map(|i| seed * 1_000_003 + i).collect();
    let checked: Vec<Checked> =
        seeds.par_iter().map(|seed| check(case_of(random_die::random_die(*seed).model))).collect();
    if std::env::args().any(|a| a == "--raw") {
        for (seed, checked) in seeds.iter().zip(&checked) {
            checked.print_raw(*seed);
        }
    }
    println!("{count} random dies, seed {seed}, {:.0} s\n", start.elapsed().as_secs_f64());
    println!("{}", Tally::of(&checked).markdown());
}

/// A number given on the command line.
fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}
