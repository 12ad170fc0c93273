//! `stampflow fit`.

use super::code::{BadRequest, Code};
use super::place;
use super::study::{StudyOptions, request};
use serde::Serialize;
use stampflow::study::fit::{
    CaseFitRequest, Estimate, HardeningKind, RateKind, Reduction, Tests, fit_case, fit_laws, material_text,
};
use stampflow::units::parse;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
CSV files are tension tests; headers name the columns and end in the unit: \
engineering_strain_percent, engineering_stress_MPa, true_strain, true_stress_MPa, \
plastic_strain, width_strain, standard_deviation_MPa, or elongation_mm and force_kN \
with --gauge and --section. Columns without `true` in their name are engineering. \
Points count from the yield offset to the largest force. Without --law all laws are \
compared. Tests with --rate give a rate law, tests with --direction r-values.

A case file, or a study file with [vary], is fitted to measured curves: travel and \
force, travel and draw-in, s0 or radius and thickness; without --to those of its \
[[compare]].

Examples:
  stampflow fit test.csv
  stampflow fit test.csv --law swift --young \"210 GPa\"
  stampflow fit slow.csv fast.csv --rate 0.001,1
  stampflow fit rd.csv dd.csv td.csv --direction 0,45,90
  stampflow fit cup.toml --vary \"friction=0.1 in 0.01..0.3\" --to curve.csv

Exit codes: 0 done, 2 bad input, 130 interrupted (the best so far is kept)";

const STRAIN: &str = "a plain number";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Tension tests, or one case or study file
    #[arg(required = true, value_name = "TEST.csv|CASE.toml")]
    files: Vec<PathBuf>,
    /// Fit only this law to tension tests
    #[arg(long, value_name = "LAW")]
    law: Option<HardeningKind>,
    /// Young's modulus [default: the slope at the beginning]
    #[arg(long, value_name = "STRESS", value_parser = |text: &str| measured(text, "a stress", "210 GPa"))]
    young: Option<f64>,
    /// Plastic strain at yield
    #[arg(long, value_name = "STRAIN", default_value = "0.2 %", value_parser = strain)]
    offset: f64,
    /// Plastic strain where the fit begins [default: the offset]
    #[arg(long, value_name = "STRAIN", value_parser = strain)]
    from: Option<f64>,
    /// Plastic strain where the fit ends [default: at the largest force]
    #[arg(long, value_name = "STRAIN", value_parser = strain)]
    until: Option<f64>,
    /// Section of the specimen, for forces: "20 mm^2"
    #[arg(long, value_name = "AREA", value_parser = |text: &str| measured(text, "an area", "20 mm^2"))]
    section: Option<f64>,
    /// Gauge length, for elongations: "80 mm"
    #[arg(long, value_name = "LENGTH", value_parser = |text: &str| measured(text, "a length", "80 mm"))]
    gauge: Option<f64>,
    /// Strain rate of each test in 1/s, in their order: 0.001,1
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    rate: Vec<f64>,
    /// Rate law: power, johnson-cook or cowper-symonds
    #[arg(long, value_name = "LAW", default_value = "power")]
    rate_law: RateKind,
    /// Direction of each test to the rolling direction in degrees: 0,45,90
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    direction: Vec<f64>,
    /// A key of the case: KEY=START in LOW..HIGH UNIT; as often as needed
    #[arg(long, value_name = "KEY=RANGE")]
    vary: Vec<String>,
    /// A measured curve, as often as needed [default: those of the case's [[compare]]]
    #[arg(long, value_name = "CURVE.csv")]
    to: Vec<PathBuf>,
    #[command(flatten)]
    options: StudyOptions,
}

#[derive(Serialize)]
struct Parameters<'a> {
    law: Option<String>,
    parameters: &'a [Estimate],
}

pub fn fit(args: &Args) -> anyhow::Result<Code> {
    let is_test = |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    let dir = args.options.folder(&args.files[0], "fit");
    place::file(&dir.join("fit.csv"), &[args.files.as_slice(), &args.to].concat(), "--out")?;
    match args.files.as_slice() {
        tests if tests.iter().all(is_test) => laws(args, &dir),
        [file] => keys(args, file, &dir),
        _ => Err(BadRequest("give tension tests, or one case or study file".into()).into()),
    }
}

fn laws(args: &Args, dir: &Path) -> anyhow::Result<Code> {
    if !args.vary.is_empty() || !args.to.is_empty() {
        return Err(BadRequest("--vary and --to are of a case: name its file in place of a test".into()).into());
    }
    let tests = Tests {
        tests: args.files.clone(),
        reduction: Reduction { young: args.young, offset: args.offset, from: args.from, to: args.until },
        section: args.section,
        gauge: args.gauge,
        rate: args.rate.clone(),
        direction: args.direction.clone(),
    };
    let fits = fit_laws(tests.curves().map_err(request)?, args.law, args.rate_law).map_err(request)?;
    let best = fits.best();
    let files = vec![("material.toml".to_owned(), material_text(&fits, best).into_bytes())];
    let parameters = Parameters { law: Some(best.kind.name()), parameters: &best.estimates };
    args.options.present(&fits.report(), dir, files, &parameters)
}

fn keys(args: &Args, file: &Path, dir: &Path) -> anyhow::Result<Code> {
    let fit = CaseFitRequest::load(file, args.options.overrides.all(), &args.vary, &args.to).map_err(request)?;
    let fit = match fit_case(&fit, args.options.threads(), &args.options.count(file, "fit")) {
        Err(_) if super::interrupt::is_wanted() => return Ok(Code::Interrupted),
        fit => fit.map_err(request)?,
    };
    let files = vec![("fitted.toml".to_owned(), fit.text.clone().into_bytes())];
    args.options.present(&fit.report(), dir, files, &Parameters { law: None, parameters: &fit.estimates })
}

/// A quantity above 0 of a dimension; a plain number may be 0.
fn measured(text: &str, dimension: &str, example: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    let is_large = parsed.value > 0.0 || dimension == STRAIN && parsed.value == 0.0;
    let fits = parsed.dimension.describe() == dimension && is_large;
    fits.then_some(parsed.value).ok_or_else(|| format!("{text} is not {dimension}: write \"{example}\""))
}

fn strain(text: &str) -> Result<f64, String> {
    measured(text, STRAIN, "0.2 %")
}
