//! `stampflow report`: a case solved and written as one HTML page.

use super::code::{BadRequest, Code};
use super::compare::{Variants, to_compare};
use super::error_bars::ErrorBars;
use super::job;
use super::options::{Json, Overrides};
use super::place;
use super::progress::{Progress, Records};
use super::say::{say, say_json};
use super::study::request;
use serde_json::json;
use stampflow::case::Case;
use stampflow::report::Report;
use stampflow::results::{is_report, write};
use stampflow::study::MeasuredCurve;
use stampflow::study::compare::{Candidate, SideBySide};
use stampflow::verification::quick;
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
    if !args.force {
        refuse_others(&path)?;
    }
    place::file(&path, &case.inputs, "--output")?;
    let beside = args.beside()?;

    let progress = Progress::new(args.quiet || args.json.json);
    let (solution, _) = progress.watch(&case, Records::default()).solve(case);
    let verification = args.bars.of(&solution, &progress, true);
    let versus = beside.map(|(candidates, curves)| {
        let bars = verification.clone().unwrap_or_else(|| quick(&solution, &()));
        let threads = available_parallelism().map_or(1, usize::from);
        let count = progress.count(format!("{}, compared", solution.case.name));
        SideBySide::solve(&candidates, curves, Some((solution.clone(), bars)), threads, &count)
    });
    let versus = versus.transpose().map_err(request)?;
    let report = Report::verified(&solution, verification.as_ref());
    let report = versus.iter().fold(report, Report::against);
    let saved = write(&path, report.html().as_bytes());
    let said = match (&saved, args.json.json) {
        (_, true) => {
            let mut value = report.json();
            value["files"] = json!(saved.iter().map(|()| &path).collect::<Vec<_>>());
            say_json(&value)
        }
        (Ok(_), false) => say(format!("{file} is written", file = path.display())),
        // What was computed is told at least.
        (Err(_), false) => say(solution.summary().to_string()),
    };
    saved?;
    said?;
    Ok(if solution.is_complete() { Code::Done } else { Code::StoppedEarly })
}

/// Refuses to replace a file that is no report.
fn refuse_others(path: &Path) -> Result<(), BadRequest> {
    if path.symlink_metadata().is_err() || path.is_dir() || is_report(path) {
        return Ok(());
    }
    let what = path.display();
    Err(BadRequest(format!(
        "{what} is there and is no report of ours: choose another name with -o, or replace it with --force"
    )))
}

impl Args {
    /// The case with all that it is compared with, where it is.
    fn beside(&self) -> anyhow::Result<Option<(Vec<Candidate>, Vec<MeasuredCurve>)>> {
        if self.against.is_empty() && self.variants.also.is_empty() {
            return Ok(None);
        }
        let files: Vec<PathBuf> = std::iter::once(&self.case).chain(&self.against).cloned().collect();
        to_compare(&files, &self.variants, &self.overrides.all()).map(Some)
    }

    /// The file to write, an HTML page.
    fn page(&self, case: &Case) -> Result<PathBuf, BadRequest> {
        let Some(path) = &self.output else {
            return Ok(place::folder(Path::new("out"), case)?.join("report.html"));
        };
        match path.extension().and_then(|ending| ending.to_str()) {
            None | Some("html" | "htm") => Ok(path.clone()),
            Some(other) => Err(BadRequest(format!(
                "a report is an HTML page and no .{other} file: write -o NAME.html; a browser prints it as PDF"
            ))),
        }
    }
}
