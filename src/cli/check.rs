//! `stampflow check`: what a case means and, with `--run`, what comes of it.

use super::answer::answered;
use super::code::{BadRequest, Code};
use super::error_bars::ErrorBars;
use super::job;
use super::options::{Json, Overrides};
use super::progress::{Kept, Progress};
use super::say::{Shown, say, say_json};
use super::table::{Cell, Tone, table, wrapped};
use serde_json::json;
use stampflow::assess::check::{self, Check};
use stampflow::assess::{Finding, Kind, Light, advice, headline, judgements, sentences};
use stampflow::results::verdict;
use std::fmt::Write;
use std::path::PathBuf;

pub const HELP: &str = "\
With --run the case is solved, all stages, and a verdict is printed: what tears, \
wrinkles, what press and tools must bear, and how far the result can be trusted, \
each line with its number, the limit, where that comes from and what to change. \
green is within the limit, amber near it or a guess that matters, red beyond it. \
Each number has its error bar, estimated from one coarser run; a light is green only \
where the whole bar is. Nothing is written.

Examples:
  stampflow check cases/quickstart.toml --set tools.punch.friction=0.1
  stampflow check cases/quickstart.toml --run
  stampflow check cases/quickstart.toml --run --error-bars
  stampflow check cases/quickstart.toml --run --set tools.holder.force=\"40 kN\" --json

Exit codes: 0 done, 2 bad input, 3 with --run: stopped early, 4 with --run --strict: red, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    case: PathBuf,
    /// Also solve it and give a verdict
    #[arg(long)]
    run: bool,
    /// With --run: say also what the case means, as without
    #[arg(long, short)]
    verbose: bool,
    /// With --run: end with exit code 4 where the verdict is red
    #[arg(long)]
    strict: bool,
    #[command(flatten)]
    bars: ErrorBars,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    json: Json,
}

pub fn check(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.all())?;
    let report = check::report(&case);
    if !args.run && args.bars.error_bars {
        return Err(BadRequest("error bars are of a run: write --run --error-bars".to_owned()).into());
    }
    if !args.run {
        return if args.json.json { say_json(&report) } else { say(wrapped(&report.to_string())) };
    }
    let progress = Progress::new(args.quiet || args.json.json);
    let (solution, _) = progress.watch(&case, Kept::default()).solve(case);
    let verification = args.bars.of(&solution, &progress, true);
    let verification = verification.as_ref();
    let (answer, findings) = stampflow::study::verify::answered(&solution, verification);
    let complete = solution.is_complete();
    if args.json.json {
        let mut value = serde_json::to_value(&report)?;
        value["complete"] = json!(complete);
        value["verdict"] = verdict(&answer, &findings, verification)?;
        value["run_warnings"] = serde_json::to_value(sentences(&findings, Kind::Warning))?;
        say_json(&value)?;
    } else {
        let answered = answered(&solution.case, &answer, &findings, verification);
        say(answered + printed(args.verbose.then_some(&report), &findings))?;
    }
    Ok(Code::of_run(args.strict, complete, &answer))
}

/// What the case means where it is given, and every row of the verdict.
fn printed(report: Option<&Check>, findings: &[Finding]) -> Shown {
    let rows = judgements(findings).map(|finding| row(finding)).collect();
    let headers = ["Verdict", "Light", "Found", "Limit (source)"].map(|header| String::from(header));
    let mut text = format!("\n{}\n", headline(findings).to_string());
    let advised = advice(findings, |light| light == Light::Grey).into_iter();
    list(
        &mut text,
        &String::from("Not judged"),
        advised.map(|(labels, advice)| format!("{}: {}", labels.to_string(), advice.to_string())),
    );
    let meaning = report.map_or_else(Shown::default, |report| wrapped(&format!("{}\n", report.to_string())));
    Shown::from("\n") + meaning + table(Some(headers.each_ref().map(String::as_str)), rows) + wrapped(&text)
}

/// Entries under a heading; nothing where there are none.
fn list(text: &mut String, heading: &str, entries: impl Iterator<Item = String>) {
    let mut entries = entries.peekable();
    if entries.peek().is_some() {
        let _ = writeln!(text, "\n{heading}");
    }
    for entry in entries {
        let _ = writeln!(text, "  - {entry}");
    }
}

fn row(finding: &Finding) -> [Cell; 4] {
    let limit = format!("{limit} ({source})", limit = finding.limit, source = finding.source);
    [
        Cell::plain(String::from(finding.label)),
        Cell { text: String::from(finding.light.name()), tone: Tone::of(finding.light) },
        Cell::plain(finding.found()),
        Cell::plain(limit.to_string()),
    ]
}
