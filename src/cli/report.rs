//! `stampflow report`: a case solved and written as one HTML page.

use super::code::{BadRequest, Code};
use super::compare::{Variants, to_compare};
use super::job;
use super::options::{ErrorBars, Json, Overrides};
use super::place;
use super::progress::{Progress, Records};
use super::screen::{print, print_json};
use super::study::request;
use serde_json::json;
use stampflow::case::Case;
use stampflow::report::Report;
use stampflow::results::{is_report, write};
use stampflow::study::compare::SideBySide;
use stampflow::study::verify::quick;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

pub const HELP: &str = "\
One HTML file with its pictures inside. A browser prints it on A4 pages, or as PDF. Each number has its error bar, estimated
from one coarser run. A report of an earlier run is replaced; any other file is left alone.

Examples:
  stampflow report cases/quickstart.toml
  stampflow report cup.toml -o cup_report.html --set 'report={part=\"Cup\", number=\"4711\"}'
  stampflow report cases/quickstart.toml --also friction=0.12

Exit codes: 0 done, 2 bad input (nothing is written), 3 stopped early, 130 interrupted, 1 anything else";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    case: PathBuf,
    #[command(flatten)]
    overrides: Overrides,
    /// The file to write [default: out/<case>/report.html]
    #[arg(long, short, alias = "out", value_name = "FILE")]
    output: Option<PathBuf>,
    /// Compare with another case or with measured curves; as often as needed
    #[arg(long, value_name = "CASE.toml|CURVE.csv")]
    against: Vec<PathBuf>,
    #[command(flatten)]
    variants: Variants,
    /// Replace a file that is no report, too
    #[arg(long)]
    force: bool,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    json: Json,
    #[command(flatten)]
    bars: ErrorBars,
}

pub fn report(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.all())?;
    let path = args.page(&case)?;
    place::file(&path, &case.inputs, "--output")?;
    let compared = if args.against.is_empty() && args.variants.also.is_empty() {
        None
    } else {
        let files: Vec<PathBuf> = std::iter::once(&args.case).chain(&args.against).cloned().collect();
        Some(to_compare(&files, &args.variants, &args.overrides.all())?)
    };
    let progress = Progress::new(args.quiet || args.json.json);
    let (solution, _) = progress.watch(&case, Records::default()).solve(case);
    let verification = args.bars.of(&solution, &progress, true);
    let versus = compared.map(|(candidates, curves)| {
        let bars = verification.clone().unwrap_or_else(|| quick(&solution, &()).bars);
        let threads = available_parallelism().map_or(1, usize::from);
        let count = progress.count(format!("{}, compared", solution.case.name));
        SideBySide::solve(&candidates, curves, Some((solution.clone(), bars)), threads, &count)
    });
    let versus = versus.transpose().map_err(request)?;
    let report = Report::verified(&solution, verification.as_ref());
    let report = versus.iter().fold(report, Report::against);
    let written = write(&path, report.html().as_bytes());
    let printed = if args.json.json {
        let mut value = report.json();
        value["files"] = json!(written.iter().map(|()| &path).collect::<Vec<_>>());
        print_json(&value)
    } else if written.is_ok() {
        print(format!("{file} is written", file = path.display()))
    } else {
        print(solution.summary().to_string())
    };
    written?;
    printed?;
    Ok(if solution.is_complete() { Code::Done } else { Code::StoppedEarly })
}

impl Args {
    /// The file to write, an HTML page.
    fn page(&self, case: &Case) -> Result<PathBuf, BadRequest> {
        let path = match &self.output {
            None => place::folder(Path::new("out"), case)?.join("report.html"),
            Some(path) => path.clone(),
        };
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("html");
        if !matches!(ending, "html" | "htm") {
            return Err(BadRequest(format!(
                "a report is an HTML page and no .{ending} file: write -o NAME.html; a browser prints it as PDF"
            )));
        }
        if self.force || path.symlink_metadata().is_err() || path.is_dir() || is_report(&path) {
            return Ok(path);
        }
        let what = path.display();
        Err(BadRequest(format!(
            "{what} is there and is no report of ours: choose another name with -o, or replace it with --force"
        )))
    }
}
