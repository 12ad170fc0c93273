//! What a fit is asked for.

use super::super::many::Many;
use stampflow::study::fit::{Kind, RateKind, Reduction, Tests, specimens};
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
    #[arg(long, value_name = "LAW")]
    pub law: Option<Kind>,
    /// Young's modulus [default: the slope at the beginning]
    #[arg(long, value_name = "STRESS", value_parser = specimens::stress)]
    pub young: Option<f64>,
    /// Plastic strain at yield, where the law begins
    #[arg(long, value_name = "STRAIN", default_value = "0.2 %", value_parser = specimens::strain)]
    pub offset: f64,
    /// Plastic strain where the fit begins, such as that behind a yield plateau [default: the offset]
    #[arg(long, value_name = "STRAIN", value_parser = specimens::strain)]
    pub from: Option<f64>,
    /// Plastic strain where the fit ends [default: at the largest force]
    #[arg(long, value_name = "STRAIN", value_parser = specimens::strain)]
    pub until: Option<f64>,
    /// Section of the specimen, for forces: "20 mm^2"
    #[arg(long, value_name = "AREA", value_parser = specimens::section)]
    pub section: Option<f64>,
    /// Gauge length, for elongations: "80 mm"
    #[arg(long, value_name = "LENGTH", value_parser = specimens::gauge)]
    pub gauge: Option<f64>,
    /// Strain rate of each test in 1/s, in their order: 0.001,1
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    pub rate: Vec<f64>,
    /// Law of the rate: power, johnson-cook or cowper-symonds
    #[arg(long, value_name = "LAW", default_value = "power")]
    pub rate_law: RateKind,
    /// Direction of each test to that of rolling in degrees: 0,45,90
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    pub direction: Vec<f64>,
}

impl Args {
    /// The tension tests.
    pub fn tests(&self) -> Tests {
        let of = &self.of_law;
        Tests {
            tests: self.files.iter().cloned().map(Into::into).collect(),
            reduction: Reduction { young: of.young, offset: of.offset, from: of.from, to: of.until },
            section: of.section,
            gauge: of.gauge,
            rate: of.rate.clone(),
            direction: of.direction.clone(),
        }
    }
}
