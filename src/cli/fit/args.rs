//! What a fit is asked for.

use super::super::many::Many;
use stampflow::study::fit::{Kind, RateKind};
use stampflow::units::{Positive, Quantity, Stress, parse};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Tension tests, or one case or study file
    #[arg(required = true, value_name = "TEST.csv|CASE.toml")]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub of_law: Options,
    /// A key of the case: KEY=START in LOW..HIGH UNIT; as often as needed
    #[arg(long, value_name = "KEY=RANGE")]
    pub vary: Vec<String>,
    /// A measured curve, as often as needed [default: those of the case's [[compare]]]
    #[arg(long, value_name = "CURVE.csv")]
    pub to: Vec<PathBuf>,
    #[command(flatten)]
    pub many: Many,
}

/// The options of tension tests.
#[derive(Debug, clap::Args)]
pub struct Options {
    /// Of tension tests: fit this law only
    #[arg(long, value_name = "LAW", value_parser = kind)]
    pub law: Option<Kind>,
    /// Young's modulus [default: the slope at the beginning]
    #[arg(long, value_name = "STRESS", value_parser = stress)]
    pub young: Option<f64>,
    /// Plastic strain at yield, where the law begins
    #[arg(long, value_name = "STRAIN", default_value = "0.2 %", value_parser = share)]
    pub offset: f64,
    /// Plastic strain where the fit begins, such as that behind a yield plateau [default: the offset]
    #[arg(long, value_name = "STRAIN", value_parser = share)]
    pub from: Option<f64>,
    /// Plastic strain where the fit ends [default: at the largest force]
    #[arg(long, value_name = "STRAIN", value_parser = share)]
    pub until: Option<f64>,
    /// Section of the specimen, for forces: "20 mm^2"
    #[arg(long, value_name = "AREA", value_parser = section)]
    pub section: Option<f64>,
    /// Gauge length, for elongations: "80 mm"
    #[arg(long, value_name = "LENGTH", value_parser = gauge)]
    pub gauge: Option<f64>,
    /// Strain rate of each test in 1/s, in their order: 0.001,1
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    pub rate: Vec<f64>,
    /// Law of the rate: power, johnson-cook or cowper-symonds
    #[arg(long, value_name = "LAW", default_value = "power", value_parser = rate_kind)]
    pub rate_law: RateKind,
    /// Direction of each test to that of rolling in degrees: 0,45,90
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    pub direction: Vec<f64>,
}

fn kind(name: &str) -> Result<Kind, String> {
    let names = || Kind::ALL.map(Kind::name).join(", ");
    Kind::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| format!("the laws are {}", names()))
}

fn rate_kind(name: &str) -> Result<RateKind, String> {
    match name {
        "power" => Ok(RateKind::Power),
        "johnson-cook" => Ok(RateKind::JohnsonCook),
        "cowper-symonds" => Ok(RateKind::CowperSymonds),
        _ => Err("the laws are power, johnson-cook and cowper-symonds".to_owned()),
    }
}

fn section(text: &str) -> Result<f64, String> {
    measured(text, "an area", "20 mm^2")
}

fn gauge(text: &str) -> Result<f64, String> {
    measured(text, "a length", "80 mm")
}

fn measured(text: &str, what: &str, example: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    let fits = parsed.dimension.describe() == what && parsed.value > 0.0;
    fits.then_some(parsed.value).ok_or_else(|| format!("{text} is not {what}: write \"{example}\""))
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
