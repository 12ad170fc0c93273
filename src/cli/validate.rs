//! `stampflow validate`: every case against its published curves.

mod markdown;
mod screen;

use super::code::{BadRequest, Code};
use super::job::{complained, load_all, prepared, solve_all};
use super::json;
use super::options::{Json, PictureOptions, Threads};
use super::place;
use super::progress::{Progress, Records};
use super::say::{say, say_json};
use anyhow::Context;
use screen::Compared;
use stampflow::results::{Results, comparison_folder};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Every case of the folder that has [[compare]] tables is solved. Overlay plots and their numbers go to DIR/<case>. A
line is printed for each comparison, with the value that misses most and what it is held against; then why those that
are outside are so, by their numbers, and how many of each kind of reference are inside. A curve that is optional and
missing counts as \"no data\", not as a failure; the difference of a demonstration is shown and is none either.

Examples:
  stampflow validate
  stampflow validate --cases my/cases --out /tmp/validate
  stampflow validate --markdown > docs/comparisons.md      # with every citation and reason

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
    /// Print a Markdown table instead, with citations and reasons in full
    #[arg(long, conflicts_with = "json")]
    markdown: bool,
    #[command(flatten)]
    json: Json,
}

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
        |case| progress.watch(case, Records::default()),
        |solution, _, folder| {
            let results = Results::of(&solution)?.with_pictures(&args.pictures.pictures());
            let failure = results.write_comparisons(folder).err();
            Ok((solution.case.name.clone(), results.comparisons, failure))
        },
    );
    let mut compared: Vec<Compared> = Vec::new();
    for outcome in outcomes {
        match outcome {
            Ok((case, comparisons, failure)) => {
                compared.extend(comparisons.into_iter().map(|comparison| (case.clone(), comparison)));
                failed.extend(failure.map(anyhow::Error::from));
            }
            Err(error) => failed.push(error),
        }
    }
    let said = if args.json.json {
        say_json(&compared.iter().map(|(case, one)| json::comparison(case, one)).collect::<Vec<_>>())
    } else if args.markdown {
        say(markdown::markdown(&compared))
    } else {
        say(screen::screen(&compared))
    };
    failed.extend(said.err());
    let code = if compared.iter().any(|(_, comparison)| comparison.is_failure()) { Code::Failed } else { Code::Done };
    Ok(complained(&failed, code))
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
