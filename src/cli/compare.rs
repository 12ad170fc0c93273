//! `stampflow compare`: several cases, variants and measurements in one picture and one table.

use super::code::{BadRequest, Code};
use super::many::{Many, asked, write_all};
use super::place;
use super::say::{Shown, say, say_json, warn};
use super::table::{Cell, Tone, table, wrapped};
use super::{interrupt, job};
use stampflow::output::study::json;
use stampflow::output::study::versus::{BEGINNING, TABLE, csv, pictures};
use stampflow::study::versus::{Asked, COLUMNS, Candidate, Measured, Versus};
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Cases are solved as they stand, with what --set says; each --also is one more run, the \
first case with overrides of its own, several joined by semicolons. A FILE.csv is laid \
over the runs: travel_mm,punch_force_kN or s0_mm,thickness_mm, or a run's load_travel.csv \
or profile.csv. Differences are against the first; one that is smaller than both error \
bars together is told so: (within the error). DIR has differences.csv and the pictures \
compare_load, compare_thickness, compare_strains (with a forming limit), compare_sections.

Examples:
  stampflow compare cup.toml --also friction=0.12
  stampflow compare cup.toml --also \"tools.die.shoulder=4 mm; friction=0.12\" measured.csv
  stampflow compare cup.toml cup-2.toml --out out/two --format svg --width \"85 mm\"
  stampflow report cup.toml --against cup-2.toml

Exit codes: 0 done, 2 bad input, 130 interrupted (the runs that have ended are compared)";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files, and CSV files of measured curves; differences are against the first case
    #[arg(required = true, value_name = "CASE.toml|CURVE.csv")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    variants: Variants,
    #[command(flatten)]
    many: Many,
}

/// The option of every verb that compares.
#[derive(Debug, clap::Args)]
pub struct Variants {
    /// One more run: the first case with these overrides, KEY=VALUE joined by semicolons; as often as needed
    #[arg(long, value_name = "KEY=VALUE; ...")]
    pub also: Vec<String>,
}

pub fn compare(args: &Args) -> anyhow::Result<Code> {
    let all = to_compare(&args.files, &args.variants, &args.many.overrides.all())?;
    let first = args.files.iter().find(|file| !is_curve(file)).unwrap_or(&args.files[0]);
    let dir = args.many.folder(first, "compare");
    place::file(&dir.join(TABLE), &all.inputs(), "--out")?;
    place::replaced(&dir.join(TABLE), BEGINNING.as_bytes(), "--out")?;
    let asked_for = all.count();
    let versus = all.solve(None, args.many.threads(), &args.many.count(first, "compared")).map_err(asked)?;
    if versus.members.len() < asked_for {
        warn(format!("{} of {asked_for} runs had ended", versus.members.len()));
    }
    if versus.members.is_empty() && interrupt::is_wanted() {
        return Ok(Code::Done);
    }
    let files = written(args, &versus, &dir)?;
    if args.many.json.json {
        let mut value = json::versus(&versus);
        value["files"] = serde_json::json!(files);
        return say_json(&value);
    }
    say(screen(&versus) + told_files(&files))
}

/// Cases with overrides and measured curves, as they are named; variants are of the first case.
pub fn to_compare(files: &[PathBuf], variants: &Variants, overrides: &[String]) -> anyhow::Result<Asked> {
    let (curves, cases): (Vec<&PathBuf>, Vec<&PathBuf>) = files.iter().partition(|file| is_curve(file));
    let mut candidates = Vec::new();
    let own: Vec<Vec<String>> =
        variants.also.iter().map(|text| Candidate::overrides(text)).collect::<Result<_, _>>().map_err(asked)?;
    for (i, path) in cases.iter().enumerate() {
        let of_first = if i == 0 { &own[..] } else { &[] };
        for own in [Vec::new()].iter().chain(of_first) {
            let all: Vec<String> = overrides.iter().chain(own).cloned().collect();
            candidates.push(Candidate { case: job::load(path, &all)?, own: own.clone() });
        }
    }
    if candidates.is_empty() {
        return Err(BadRequest("there is no case to compare with: give a CASE.toml too".into()).into());
    }
    let measured = curves.into_iter().map(|path| Measured::read(&path.as_path().into())).collect::<Result<_, _>>();
    let measured = measured.map_err(asked)?;
    Asked::new(candidates, measured).map_err(asked)
}

fn is_curve(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// The table and all pictures.
fn written(args: &Args, versus: &Versus, dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let made = args.many.pictures.pictures();
    let mut files = vec![(TABLE.to_owned(), csv(versus))];
    for drawn in pictures(versus, made.engineering_strain) {
        files.extend(made.files(drawn.stem, &drawn.chart));
    }
    Ok(write_all(dir, files)?)
}

fn told_files(files: &[PathBuf]) -> Shown {
    let folder = files.first().and_then(|file| file.parent()).unwrap_or(Path::new("."));
    let names = files.iter().filter_map(|file| Some(file.file_name()?.to_string_lossy().into_owned()));
    let names: Vec<String> = names.collect();
    let told = format!("\nin {folder}: {files}", folder = folder.display(), files = names.join(", "));
    wrapped(&String::from(told))
}

/// Each number with a line for every run, the differences behind.
fn screen(versus: &Versus) -> Shown {
    let mut rows = Vec::new();
    for line in versus.lines() {
        let mut label = String::from(line.label);
        for (said, member) in line.of_runs.into_iter().zip(&versus.members) {
            let tone = said.light.map_or(Tone::Plain, Tone::of);
            let value = Cell { text: String::from(said.value), tone };
            let cells = [std::mem::take(&mut label), member.mark.clone(), String::from(said.change)];
            let [label, mark, change] = cells.map(Cell::plain);
            rows.push([label, mark, value, change]);
        }
    }
    let headers = COLUMNS.map(|header| String::from(header));
    let legend: Vec<String> = versus.legend().into_iter().map(|entry| String::from(entry)).collect();
    wrapped(&(legend.join("\n") + "\n\n")) + table(Some(headers.each_ref().map(String::as_str)), rows)
}
