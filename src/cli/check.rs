//! `stampflow check`: what a case means and, with `--run`, what comes of it.

use super::answer::answered;
use super::code::{BadRequest, Code};
use super::job;
use super::options::{ErrorBars, Json, Overrides};
use super::progress::{Progress, Records};
use super::screen::{Cell, ScreenText, print, print_json, table, wrapped};
use serde_json::json;
use stampflow::assess::check::{self, Check};
use stampflow::assess::{Finding, Kind, Light, advice, headline, judgements, sentences};
use stampflow::results::verdict;
use std::path::PathBuf;

pub const HELP: &str = "\
With --run the case is solved and a verdict is printed, a line for each finding: its number \
with error bar, the limit, the limit's source and what to change. Green is within the limit, \
amber near it or a guess that matters, red beyond it. Nothing is written.

Examples:
  stampflow check cases/quickstart.toml --set tools.punch.friction=0.1
  stampflow check cases/quickstart.toml --run
  stampflow check cases/quickstart.toml --run --set tools.holder.force=\"40 kN\" --json

Exit codes: 0 done, 2 bad input, 3 with --run: stopped early, 4 with --run --strict: red, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    case: PathBuf,
    /// Also solve it and give a verdict
    #[arg(long)]
    run: bool,
    /// With --run: also explain the case, as without
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
        return if args.json.json { print_json(&report) } else { print(wrapped(&report.to_string())) };
    }
    let progress = Progress::new(args.quiet || args.json.json);
    let (solution, _) = progress.watch(&case, Records::default()).solve(case);
    let verification = args.bars.of(&solution, &progress, true);
    let verification = verification.as_ref();
    let (answer, findings) = stampflow::results::error_bars::answered(&solution, verification);
    let complete = solution.is_complete();
    if args.json.json {
        let mut value = serde_json::to_value(&report)?;
        value["complete"] = json!(complete);
        value["verdict"] = verdict(&answer, &findings, verification);
        value["run_warnings"] = serde_json::to_value(sentences(&findings, Kind::Warning))?;
        print_json(&value)?;
    } else {
        let answered = answered(&solution.case, &answer, &findings, verification);
        print(answered + verdict_table(args.verbose.then_some(&report), &findings))?;
    }
    Ok(Code::of_run(args.strict, complete, &answer))
}

/// The meaning of the case if wanted, and every row of the verdict.
fn verdict_table(report: Option<&Check>, findings: &[Finding]) -> ScreenText {
    let rows = judgements(findings).map(|finding| {
        let limit = format!("{} ({})", finding.limit, finding.source);
        let light = Cell::Light(finding.light, String::new());
        [Cell::from(finding.label), light, Cell::from(finding.found()), Cell::from(limit)]
    });
    let mut text = format!("\n{}\n", headline(findings));
    let unchecked = advice(findings, |light| light == Light::Grey);
    if !unchecked.is_empty() {
        text += "\nNot checked\n";
    }
    unchecked.into_iter().for_each(|(labels, advice)| text += &format!("  - {labels}: {advice}\n"));
    let meaning = report.map_or_else(ScreenText::default, |report| wrapped(&format!("{report}\n")));
    let headers = ["Verdict", "Light", "Found", "Limit (source)"];
    ScreenText::from("\n") + meaning + table(&headers, rows) + wrapped(&text)
}
