//! `stampflow compare`: runs and measured curves side by side; cases against their references.

use super::code::{BadRequest, Code};
use super::screen::{print, print_json, warn, wrapped};
use super::study::{StudyOptions, request, screen_table};
use super::{interrupt, job, json, place};
use stampflow::case::comparison::KINDS;
use stampflow::results::comparison::{Comparison, Verdict};
use stampflow::results::{Results, comparison_folder};
use stampflow::study::Watch;
use stampflow::study::compare::{Candidate, SideBySide, check, variant};
use stampflow::study::{BaseCase, MeasuredCurve, ReportTable, parallel_map};
use std::convert::Infallible;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Several cases are solved as they stand, with what --set says; each --also is one more \
run, the first case with overrides of its own, joined by semicolons. A FILE.csv is laid \
over the runs: travel_mm,punch_force_kN or s0_mm,thickness_mm, or a run's \
load_travel.csv or profile.csv. Differences are from the first run; one within both \
error bars together says nothing. DIR has differences.csv and the pictures.

A folder, or one case alone, is compared with the references of its [[compare]] tables: \
one line per comparison, with the value that misses most. A reference that is optional \
and missing counts as no data; the difference of a demonstration is shown and is no \
failure. Without files: the folder `cases`.

Examples:
  stampflow compare cup.toml --also friction=0.12
  stampflow compare cup.toml --also \"tools.die.shoulder=4 mm; friction=0.12\" measured.csv
  stampflow compare cup.toml cup-2.toml --out out/two
  stampflow compare cases

Exit codes: 0 done, 1 a comparison is out of its tolerance, 2 bad input, 130 interrupted";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files and CSV files of measured curves; or one case or folder, to compare with its references
    #[arg(value_name = "CASE.toml|CURVE.csv|DIR", default_value = "cases")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    variants: Variants,
    #[command(flatten)]
    options: StudyOptions,
}

/// Variants of the first case.
#[derive(Debug, clap::Args)]
pub struct Variants {
    /// One more run: the first case with these overrides, KEY=VALUE joined by semicolons; as often as needed
    #[arg(long, value_name = "KEY=VALUE; ...")]
    pub also: Vec<String>,
}

pub fn compare(args: &Args) -> anyhow::Result<Code> {
    let first = &args.files[0];
    if args.files.len() == 1 && args.variants.also.is_empty() && !is_curve(first) {
        return references(args, first);
    }
    let (candidates, curves) = to_compare(&args.files, &args.variants, &args.options.overrides.all())?;
    let first = args.files.iter().find(|file| !is_curve(file)).unwrap_or(first);
    let dir = args.options.folder(first, "compare");
    place::file(&dir.join("differences.csv"), &args.files, "--out")?;
    let count = args.options.count(first, "compared");
    let all = SideBySide::solve(&candidates, curves, None, args.options.threads(), &count).map_err(request)?;
    if all.members.len() < candidates.len() {
        warn(format!("{} of {} runs had ended", all.members.len(), candidates.len()));
    }
    if all.members.is_empty() && interrupt::is_wanted() {
        return Ok(Code::Done);
    }
    args.options.present(&all.report(), &dir, Vec::new(), &())
}

/// Cases with variants of the first, and measured curves.
pub fn to_compare(
    files: &[PathBuf],
    variants: &Variants,
    overrides: &[String],
) -> anyhow::Result<(Vec<Candidate>, Vec<MeasuredCurve>)> {
    let (curves, cases): (Vec<&PathBuf>, Vec<&PathBuf>) = files.iter().partition(|file| is_curve(file));
    let mut changes = vec![Vec::new()];
    for text in &variants.also {
        changes.push(variant(text).map_err(request)?);
    }
    let mut candidates = Vec::new();
    for (i, path) in cases.into_iter().enumerate() {
        for own in changes.iter().take(if i == 0 { changes.len() } else { 1 }) {
            candidates.push(Candidate { case: job::load(path, &[overrides, own].concat())?, overrides: own.clone() });
        }
    }
    let curves = curves.into_iter().map(|path| MeasuredCurve::load(path));
    let curves = curves.collect::<Result<Vec<_>, _>>().map_err(request)?;
    check(&candidates, &curves).map_err(request)?;
    Ok((candidates, curves))
}

fn is_curve(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// Compares every case of a folder, or one case, with its references.
fn references(args: &Args, path: &Path) -> anyhow::Result<Code> {
    let files = if path.is_dir() { case_files(path)? } else { vec![path.to_owned()] };
    let (mut cases, mut failed) = job::load_all(&files, &args.options.overrides.all());
    cases.retain(|case| !case.compare.is_empty());
    if cases.is_empty() && failed.is_empty() {
        return Err(BadRequest(format!("no case in {} has a [[compare]] table", path.display())).into());
    }
    let dir = args.options.folder(path, "compare");
    let mut compared: Vec<(String, Comparison)> = Vec::new();
    let watch = args.options.count(path, "compared");
    let one = |case: &stampflow::Case| -> anyhow::Result<_> {
        let folder = place::results(case, &place::folder(&dir, case)?, comparison_folder)?;
        let solution = BaseCase::solve(case.clone(), &watch).map_err(BadRequest)?;
        let results = Results::of(&solution)?.with_pictures(&args.options.pictures.pictures());
        results.write_comparisons(folder)?;
        Ok((case.name.clone(), results.comparisons))
    };
    let mut done = 0;
    let Ok(()) = parallel_map(&cases, args.options.threads(), &watch, one, |outcome| {
        match outcome {
            Ok((name, all)) => compared.extend(all.into_iter().map(|comparison| (name.clone(), comparison))),
            Err(error) => failed.push(error),
        }
        done += 1;
        watch.ran(done, cases.len());
        Ok::<_, Infallible>(())
    });
    if args.options.json.json {
        print_json(&compared.iter().map(|(case, one)| json::comparison(case, one)).collect::<Vec<_>>())?;
    } else {
        print(screen_table(&table(&compared)) + wrapped(&format!("\n{}\n{}", reasons(&compared), counts(&compared))))?;
    }
    let is_out = compared.iter().any(|(_, comparison)| comparison.is_failure()) && !watch.wants_to_stop();
    Ok(job::complained(&failed, if is_out { Code::Failed } else { Code::Done }))
}

fn table(all: &[(String, Comparison)]) -> ReportTable {
    let columns = ["Case", "Kind", "Quantity", "Computed", "Reference", "Verdict"];
    let mut table = ReportTable::new("comparisons", &columns);
    for (case, comparison) in all {
        let kind = comparison.source().map_or("–", |source| source.kind());
        let quantity = comparison.spec.against.quantity().label();
        let [computed, target] = [comparison.farthest().map(|amount| amount.to_string()), comparison.target()]
            .map(|text| text.unwrap_or_else(|| "–".to_owned()).into());
        let outcome = comparison.outcome().into();
        table.rows.push(vec![case.clone().into(), kind.into(), quantity.into(), computed, target, outcome]);
    }
    table
}

/// Reasons of comparisons that are not inside, each once.
fn reasons(all: &[(String, Comparison)]) -> String {
    let mut lines: Vec<String> = Vec::new();
    for (case, comparison) in all.iter().filter(|(_, comparison)| comparison.verdict != Verdict::In) {
        let reason = comparison.spec.reason.trim_end_matches('.');
        let (quantity, miss) = (comparison.spec.against.quantity().label(), comparison.worst().unwrap_or_default());
        let line = format!("{case}, {quantity} {miss}: {reason}.");
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines.join("\n")
}

/// Comparisons inside, by kind of reference: `experiment: 1 of 3 inside`.
fn counts(all: &[(String, Comparison)]) -> String {
    let line = |name: &&str| {
        let is_kind = |c: &&Comparison| c.source().is_some_and(|source| source.kind() == *name);
        let known = all.iter().map(|(_, c)| c).filter(|c| c.verdict != Verdict::NoData).filter(is_kind);
        let own: Vec<&Comparison> = known.collect();
        let inside = own.iter().filter(|c| c.verdict == Verdict::In).count();
        (!own.is_empty()).then(|| format!("{name}: {inside} of {} inside", own.len()))
    };
    KINDS.iter().filter_map(line).collect::<Vec<_>>().join("\n")
}

/// Case files of a folder, sorted.
fn case_files(dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(dir)
        .map_err(|error| BadRequest(format!("cannot read the folder {}: {error}", dir.display())))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    files.sort();
    Ok(files)
}
