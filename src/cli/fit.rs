//! `stampflow fit`: a hardening law from tension tests, or keys of a case from measured curves.

mod args;
mod case;
mod law;
mod shown;

pub use args::Args;

use super::code::Code;
use super::place;
use std::path::PathBuf;

/// What every fit writes first, by which its place is found usable before anything is fitted.
const WRITTEN: [&str; 2] = ["fit.csv", "fit.json"];

pub const HELP: &str = "\
CSV files are tension tests; headers say what is in them and end in the unit: \
engineering_strain_percent, engineering_stress_MPa, true_strain, true_stress_MPa, \
plastic_strain, width_strain, standard_deviation_MPa, or elongation_mm and force_kN \
with --gauge and --section. A column that does not say `true` is engineering. Points \
count from the yield offset to the largest force. Without --law all laws are compared. \
Tests with --rate give a rate law, tests with --direction r-values.

A case file, or a study file with [fit], is run until it meets measured curves: travel \
and force, travel and draw-in, s0 or radius and thickness; without --to those of its \
[[compare]].

Examples:
  stampflow fit test.csv
  stampflow fit test.csv --law swift --young \"210 GPa\"
  stampflow fit slow.csv fast.csv --rate 0.001,1
  stampflow fit rd.csv dd.csv td.csv --direction 0,45,90
  stampflow fit cup.toml --vary \"friction=0.1 in 0.01..0.3\" --to curve.csv
  stampflow fit cup.toml --vary \"tools.punch.friction=0.1 in 0.01..0.3\" \\
    --vary \"material.hardening.swift.k=500 in 300..800 MPa\" --to curve.csv

Exit codes: 0 done, 2 bad input, 130 interrupted (the best so far is kept)";

pub fn fit(args: &Args) -> anyhow::Result<Code> {
    let is_test = |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    let dir = args.many.folder(&args.files[0], "fit");
    let inputs = [args.files.as_slice(), &args.to].concat();
    for name in WRITTEN {
        place::file(&dir.join(name), &inputs, "--out")?;
    }
    if args.files.iter().all(is_test) { law::law(args) } else { case::case(args) }
}
