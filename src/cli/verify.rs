//! `stampflow verify`: how much of every number is mesh, step, points and contact.

use super::code::Code;
use super::interrupt;
use super::job::{complained, load_all};
use super::json;
use super::options::{Json, Overrides, Threads};
use super::place;
use super::progress::{Progress, Records};
use super::screen::{Cell, print, print_json, table, wrapped};
use serde_json::{Value, json};
use stampflow::assess;
use stampflow::case::Case;
use stampflow::results::error_bars::{Number, Origin};
use stampflow::results::write;
use stampflow::study::verify::{self, BEGINNING, FILE};
use stampflow::units::Amount;
use std::path::PathBuf;
use std::time::Instant;

pub const HELP: &str = "\
Each of these is refined on its own, twice and four times, all runs side by side: \
elements, points through the thickness, steps, contact stiffness, contact smoothing, \
slip speed, cut-off strain. A bar is what Richardson's extrapolation gives with the \
observed order, where that is near the formal one (1.25 times), else three times the \
spread; the bar is the sum over all of them. \
Runs that end otherwise, numbers that jump and elements below what a shell resolves \
are told. What the model has wrong, laws, friction, tools, is no part of a bar.

Examples:
  stampflow verify cases/quickstart.toml
  stampflow verify cases/quickstart.toml --out out/quickstart

Exit codes: 0 done, 2 bad input, 3 the run as it is stopped early, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files
    #[arg(required = true, value_name = "CASE.toml")]
    cases: Vec<PathBuf>,
    /// Also write verification.csv there, with every run's numbers; with several cases to DIR/<case>
    #[arg(long, alias = "output", value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    json: Json,
}

pub fn verify(args: &Args) -> anyhow::Result<Code> {
    let (cases, mut failed) = load_all(&args.cases, &args.overrides.all());
    args.threads.apply()?;
    let progress = Progress::new(args.quiet || args.json.json);
    let (mut code, mut values) = (Code::Done, Vec::new());
    for case in cases.into_iter().take_while(|_| !interrupt::is_wanted()) {
        match one(args, &progress, case) {
            Ok((of_case, value)) => {
                code = code.max(of_case);
                values.push(value);
            }
            Err(error) => failed.push(error),
        }
    }
    let printed = match values.as_slice() {
        [value] if args.json.json && args.cases.len() == 1 => print_json(value),
        [_, ..] if args.json.json => print_json(&values),
        _ => Ok(code),
    };
    failed.extend(printed.err());
    Ok(complained(&failed, code))
}

/// Verifies a case, writes its file, and prints it or returns its JSON.
fn one(args: &Args, progress: &Progress, case: Case) -> anyhow::Result<(Code, Value)> {
    let path = match &args.out {
        Some(dir) if args.cases.len() > 1 => Some(place::folder(dir, &case)?.join(FILE)),
        dir => dir.as_ref().map(|dir| dir.join(FILE)),
    };
    if let Some(path) = &path {
        place::file(path, &case.inputs, "--out")?;
        place::replaced(path, BEGINNING.as_bytes(), "--out")?;
    }
    let start = Instant::now();
    let count = progress.count(format!("{}, finer", case.name));
    let (solution, _) = progress.watch(&case, Records::default()).solve(case);
    let verification = verify::verify(&solution, &count);
    let seconds = start.elapsed().as_secs_f64();
    if let Some(path) = &path {
        write(path, &verification.csv())?;
    }
    let findings = assess::after_one_of_many(&solution.case, &solution.stages);
    let moved = verification.bars.moved(&findings);
    let code = if solution.is_complete() { Code::Done } else { Code::StoppedEarly };
    if args.json.json {
        let mut value = json::verification(&verification);
        value["case"] = json!(solution.case.name);
        value["seconds"] = json!(seconds);
        value["lights"] = json!(moved);
        value["file"] = json!(path);
        return Ok((code, value));
    }
    // Of the verdict's numbers only the forming limit's is in no other list.
    let is_printed = |own: &&Number| own.origin != Origin::Verdict || own.quantity.key == "forming_limit";
    let row = |own: &Number| [own.quantity.label.to_owned(), own.quantity.to_string(), own.made_of()].map(Cell::from);
    let rows = verification.bars.numbers.iter().filter(is_printed).map(row);
    let title = format!("{}: {} finer runs, ", solution.case.name, verification.outcomes.len() - 1);
    let notes: String = verification.bars.notes.iter().chain(&moved).map(|note| format!("- {note}\n")).collect();
    print(
        wrapped(&format!("{title}{}\n\n", Amount::time(seconds)))
            + table(&["Quantity", "Value", "Made of (observed order)"], rows)
            + wrapped(&format!("\n{notes}")),
    )?;
    if let Some(path) = path {
        print(format!("{} is written", path.display()))?;
    }
    Ok((code, Value::Null))
}
