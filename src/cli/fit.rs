//! `stampflow fit`: a hardening law from tension tests, or keys of a case from measured curves.

mod case;
mod law;

use super::code::Code;
use super::many::Many;
use super::options::{PictureOptions, Told};
use serde_json::{Value, json};
use stampflow::message::Form;
use stampflow::numerics::profile::End;
use stampflow::study::fit::Estimate;
use stampflow::units::{Positive, Quantity, Stress, parse};
use std::fmt::Write;
use std::path::PathBuf;

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

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Tension tests, or one case or study file
    #[arg(required = true, value_name = "TEST.csv|CASE.toml")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    of_law: law::Options,
    /// A key of the case: KEY=START in LOW..HIGH UNIT; as often as needed
    #[arg(long, value_name = "KEY=RANGE")]
    vary: Vec<String>,
    /// A measured curve, as often as needed [default: those of the case's [[compare]]]
    #[arg(long, value_name = "CURVE.csv")]
    to: Vec<PathBuf>,
    #[command(flatten)]
    told: Told,
    #[command(flatten)]
    pictures: PictureOptions,
    #[command(flatten)]
    many: Many,
}

pub fn fit(args: &Args) -> anyhow::Result<Code> {
    let is_test = |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    if args.files.iter().all(is_test) { law::law(args) } else { case::case(args) }
}

fn stress(text: &str) -> Result<f64, String> {
    text.parse::<Positive<Stress>>().map(|stress| stress.value()).map_err(|error| error.to_string())
}

/// A plain number or one in per cent.
fn share(text: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    (parsed.dimension.describe() == "a plain number" && parsed.value >= 0.0)
        .then_some(parsed.value)
        .ok_or_else(|| format!("{text} is no strain: write 0.002 or \"0.2 %\""))
}

/// A row of `fit.csv` for each number.
fn csv<'a>(estimates: impl Iterator<Item = (&'a str, &'a Estimate)>) -> String {
    let mut text = String::from("of,parameter,unit,value,standard_error,low_95,high_95,at_bound\n");
    let plain = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for (of, e) in estimates {
        let [low, high] = e.ends.map(at);
        let (key, unit, pushed) = (&e.key, &e.unit, if e.pushed.is_some() { "yes" } else { "" });
        let _ =
            writeln!(text, "{of},{key},{unit},{},{},{},{},{pushed}", e.value, plain(e.error), plain(low), plain(high));
    }
    text
}

fn at(end: End) -> Option<f64> {
    match end {
        End::At(value) => Some(value),
        End::Open | End::Unknown => None,
    }
}

fn json_of(e: &Estimate) -> Value {
    let [low, high] = e.ends.map(at);
    json!({
        "parameter": e.key, "unit": e.unit, "value": e.value, "standard_error": e.error, "low_95": low, "high_95": high,
        "bounds": e.bounds, "at_bound": e.pushed.is_some(),
    })
}

/// Value with its unit, standard error and interval, as a table has them.
fn cells(e: &Estimate, form: Form) -> [String; 3] {
    let number = |text: String| form.language.number(&text);
    let interval = e.interval().map_or_else(|| "–".to_owned(), |text| number(text));
    [
        format!("{} {}", number(e.told()), e.unit).trim_end().to_owned(),
        e.told_error().map_or_else(|| "–".to_owned(), number),
        interval,
    ]
}
