//! `stampflow validate`: every case against its published curves.

use super::code::{BadRequest, Code};
use super::job::{load_all, prepared, solve_all, told};
use super::json;
use super::options::{Json, PictureOptions, Threads};
use super::place;
use super::progress::{Kept, Progress};
use super::say::{say, say_json};
use super::table::{Cell, Tone, table, wrapped};
use anyhow::Context;
use stampflow::compare::{Comparison, Verdict};
use stampflow::output::{Results, comparison_folder};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Every case of the folder that has [[compare]] tables is solved. Overlay plots and their numbers go to DIR/<case>; one
table is printed. A curve that is optional and missing counts as \"no data\", not as a failure; the difference of a
demonstration is shown and is none either.

Examples:
  stampflow validate
  stampflow validate --cases my/cases --out /tmp/validate

Exit codes: 0 every comparison is in its tolerance, 1 one is not or was not reached, 2 bad input, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Folder of case files
    #[arg(long, value_name = "DIR", default_value = "cases")]
    cases: PathBuf,
    /// Folder for the overlay plots
    #[arg(long, alias = "output", value_name = "DIR", default_value = "out/validate")]
    out: PathBuf,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    pictures: PictureOptions,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    json: Json,
}

const HEADERS: [&str; 5] = ["case", "quantity", "kind", "worst", "verdict"];

pub fn validate(args: &Args) -> anyhow::Result<Code> {
    let (mut cases, mut failed) = load_all(&case_files(&args.cases)?, &[]);
    cases.retain(|case| !case.compare.is_empty());
    if cases.is_empty() && failed.is_empty() {
        return Err(BadRequest(format!("no case in {} has a [[compare]] table", args.cases.display())).into());
    }
    let jobs = prepared(cases, &mut failed, |case| {
        Ok(place::results(case, &place::folder(&args.out, case)?, comparison_folder)?)
    });
    args.threads.apply()?;
    let progress = Progress::new(args.quiet || args.json.json);
    let outcomes = solve_all(
        jobs,
        |case| progress.watch(case, Kept::default()),
        |solution, _, folder| {
            let results = Results::of(&solution)?.with_pictures(&args.pictures.pictures());
            let failure = results.write_comparisons(folder).err();
            Ok((solution.case.name.clone(), results.comparisons, failure))
        },
    );
    let mut compared = Vec::new();
    for outcome in outcomes {
        match outcome {
            Ok((case, comparisons, failure)) => {
                compared.push((case, comparisons));
                failed.extend(failure.map(anyhow::Error::from));
            }
            Err(error) => failed.push(error),
        }
    }
    let all = || compared.iter().flat_map(|(case, list)| list.iter().map(move |comparison| (case, comparison)));
    let said = if args.json.json {
        say_json(&all().map(|(case, comparison)| json::comparison(case, comparison)).collect::<Vec<_>>())
    } else {
        let rows = all().map(|(case, comparison)| row(case, comparison)).collect();
        say(table(Some(HEADERS), rows) + wrapped(&reasons(all())))
    };
    failed.extend(said.err());
    let code = if all().any(|(_, comparison)| comparison.is_failure()) { Code::Failed } else { Code::Done };
    Ok(told(&failed, code))
}

/// What each comparison is held against, why it is accepted as it is, and how many there are of each kind.
fn reasons<'a>(all: impl Iterator<Item = (&'a String, &'a Comparison)>) -> String {
    let (mut text, mut kinds) = ("\n".to_owned(), BTreeMap::<&str, [usize; 2]>::new());
    for (case, comparison) in all {
        let Comparison { spec, source, .. } = comparison;
        let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
        let grade = source.as_ref().map_or(String::new(), |source| format!(", grade {}", source.grade));
        let accepted = comparison.accepted();
        let _ =
            writeln!(text, "- {case}, {}: {file}{grade}, accepted {accepted}: {}", spec.against.name(), spec.reason);
        let [inside, of] = kinds.entry(source.as_ref().map_or("not stated", |source| &source.kind)).or_default();
        *of += 1;
        *inside += usize::from(comparison.verdict == Verdict::In);
    }
    let counts = kinds.into_iter().map(|(kind, [inside, of])| format!("{kind}: {inside} of {of} inside"));
    let _ = writeln!(text, "\n{}", counts.collect::<Vec<_>>().join(", "));
    text
}

/// The case files of a folder in alphabetical order.
fn case_files(dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(dir).map_err(|error| {
        let why = if dir.is_file() { "is a file, not a folder of case files" } else { "cannot be read" };
        BadRequest(match error.kind() {
            ErrorKind::NotFound => format!(
                "there is no folder {}: give the folder of the case files with --cases DIR (the project's own are in its \
                 folder `cases`)",
                dir.display()
            ),
            _ => format!("{} {why}: {error}; give a folder with --cases DIR", dir.display()),
        })
    })?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.with_context(|| format!("cannot read {}", dir.display()))?.path();
        if path.extension().is_some_and(|e| e == "toml") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// One line a comparison.
fn row(case: &str, comparison: &Comparison) -> [Cell; 5] {
    let Comparison { spec, source, .. } = comparison;
    let tone = match comparison.verdict {
        _ if comparison.is_failure() => Tone::Bad,
        Verdict::In => Tone::Good,
        _ => Tone::Warning,
    };
    [
        Cell::plain(case),
        Cell::plain(spec.against.name()),
        Cell::plain(source.as_ref().map_or("not stated".to_owned(), |s| s.kind.to_string())),
        Cell::plain(comparison.worst().unwrap_or_else(|| "–".to_owned())),
        Cell { text: comparison.outcome(), tone },
    ]
}
