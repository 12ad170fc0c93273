//! `stampflow check`: what a case means and, with `--run`, what comes of it.

use super::code::Code;
use super::job;
use super::options::{Json, Overrides};
use super::progress::{Kept, Progress};
use super::say::{Shown, say, say_json};
use super::table::{Tone, table, wrapped};
use serde_json::json;
use stampflow::assess::check::{self, Check};
use stampflow::assess::{self, Finding, Kind, Light, advice, headline, judgements, sentences};
use std::fmt::Write;
use std::path::PathBuf;

pub const HELP: &str = "\
With --run the case is solved, all stages, and a verdict is printed: what tears, wrinkles, what press and tools must
bear, and how far the result can be trusted, each line with its number, the limit, where that comes from and what to
change. green is within the limit, amber near it or a guess that matters, red beyond it. Nothing is written.

Examples:
  stampflow check cases/quickstart.toml --set tools.punch.friction=0.1
  stampflow check cases/quickstart.toml --run
  stampflow check cases/quickstart.toml --run --set tools.holder.force=\"40 kN\" --json

Exit codes: 0 done, whatever the lights, 2 bad input, 3 with --run: stopped early, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case file
    case: PathBuf,
    /// Also solve it and give a verdict
    #[arg(long)]
    run: bool,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    json: Json,
}

pub fn check(args: &Args) -> anyhow::Result<Code> {
    let case = job::load(&args.case, &args.overrides.set)?;
    let report = check::report(&case);
    if !args.run {
        return if args.json.json { say_json(&report) } else { say(wrapped(&report.to_string())) };
    }
    let watch = Progress::new(args.quiet || args.json.json).watch(&case, Kept::default());
    let (solution, _) = watch.solve(case);
    let findings = assess::after(&solution.case, &solution.stages);
    let complete = solution.is_complete();
    if args.json.json {
        let mut value = serde_json::to_value(&report)?;
        value["complete"] = json!(complete);
        value["findings"] = judgements(&findings).map(serde_json::to_value).collect::<Result<_, _>>()?;
        value["run_warnings"] = serde_json::to_value(sentences(&findings, Kind::Warning))?;
        say_json(&value)?;
    } else {
        say(printed(&report, &findings))?;
    }
    Ok(if complete { Code::Done } else { Code::StoppedEarly })
}

fn printed(report: &Check, findings: &[Finding]) -> Shown {
    let rows = judgements(findings).map(row).collect();
    let headers = ["verdict", "light", "found", "limit (source)"];
    let mut text = format!("\nverdict: {}\n", headline(findings));
    let told =
        |is: fn(Light) -> bool| advice(findings, is).into_iter().map(|(labels, advice)| format!("{labels}: {advice}"));
    list(&mut text, "what to change", told(|light| light != Light::Grey));
    list(&mut text, "not judged", told(|light| light == Light::Grey));
    list(
        &mut text,
        "warnings of the run",
        sentences(findings, Kind::Warning).into_iter().map(|message| message.to_string()),
    );
    wrapped(&format!("{report}\n")) + table(Some(headers), rows, 1) + wrapped(&text)
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

fn row(finding: &Finding) -> ([String; 4], Tone) {
    let tone = match finding.light {
        Light::Grey => Tone::Plain,
        Light::Green => Tone::Good,
        Light::Amber => Tone::Warning,
        Light::Red => Tone::Bad,
    };
    let limit = format!("{} ({})", finding.limit, finding.source);
    ([finding.label.to_owned(), finding.light.name().to_owned(), finding.found.to_string(), limit], tone)
}
