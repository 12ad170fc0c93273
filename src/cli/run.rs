//! `stampflow run`: from case files to folders of results.

use super::answer;
use super::code::{BadRequest, Code};
use super::error_bars::ErrorBars;
use super::job::{load_all, prepared, solve_all, told};
use super::json;
use super::options::{Json, Overrides, PictureOptions, Threads};
use super::place;
use super::progress::{Kept, Progress};
use super::say::{Shown, say, say_json};
use super::table::{Cell, table, wrapped};
use serde_json::{Value, json};
use stampflow::assess::{Answer, Finding};
use stampflow::case::Case;
use stampflow::report::Report;
use stampflow::results::{
    CaseSummary, Extra, FrameRecorder, OUTPUTS, ResultFolder, Results, WriteError, csv, is_report, result_folder,
    trace, verdict, write,
};
use std::fmt::Write;
use std::ops::Add;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files; several run side by side
    #[arg(required = true, value_name = "CASE.toml")]
    cases: Vec<PathBuf>,
    /// Folder for the results [default: out/<case>]; with several cases DIR/<case>
    #[arg(long, alias = "output", value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    /// Also write every iteration of the solver to this file (one case only)
    #[arg(long, value_name = "FILE.csv")]
    trace: Option<PathBuf>,
    /// Also write the section as it moves for ParaView, some 25 states: section.pvd and tools.pvd
    #[arg(long)]
    vtu: bool,
    /// Also write shapes.gif, the section and the load as they move
    #[arg(long)]
    animate: bool,
    /// Also write report.html there, from the same run; with the quick error bars of `stampflow report`
    #[arg(long)]
    report: bool,
    /// Say also what the solver has to tell: mesh, steps, norms, works
    #[arg(long, short)]
    verbose: bool,
    /// End with exit code 4 where the verdict is red
    #[arg(long)]
    strict: bool,
    #[command(flatten)]
    bars: ErrorBars,
    #[command(flatten)]
    pictures: PictureOptions,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    json: Json,
}

/// The page that --report writes.
const PAGE: &str = "report.html";

/// What is written, from the list that writes it.
pub fn help() -> String {
    let mut help = String::from(
        "Written, all of it or nothing, in one step in the place of what an earlier run left in the folder; other files stay:\n",
    );
    for output in OUTPUTS {
        let _ = writeln!(help, "  {:<18} {}", output.file, output.about);
    }
    help + "Of a case with several stages each has a folder of its own, 1-draw, 2-retract, ..., and stages.csv sums them up\n\n\
            Examples:\n  \
            stampflow run cases/quickstart.toml\n  \
            stampflow run cases/quickstart.toml --set tools.punch.friction=0.1 --out out/friction-0.1\n  \
            stampflow run cases/quickstart.toml --error-bars\n  \
            stampflow run cases/*.toml --out results --quiet\n\n\
            Exit codes: 0 done (full travel or time, or the contact share asked for), 2 bad input, or a place that cannot be written to or that another run writes to (nothing is written of that case; the others are run), 3 stopped early (results are kept), 4 with --strict: the verdict is red (results are kept), 130 interrupted by Ctrl-C (results are kept; a second one ends at once), 1 anything else"
}

pub fn run(args: &Args) -> anyhow::Result<Code> {
    if args.trace.is_some() && args.cases.len() > 1 {
        return Err(BadRequest("--trace writes the iterations of one case: give one case".to_owned()).into());
    }
    let several = args.cases.len() > 1;
    let (cases, mut failed) = load_all(&args.cases, &args.overrides.all());
    share_no_folder(&cases)?;
    let jobs = prepared(cases, &mut failed, |case| prepare(args, several, case));
    args.threads.apply()?;
    let progress = Progress::new(args.quiet || args.json.json);
    let asked = [(args.vtu, Extra::Vtu), (args.animate, Extra::Animation)];
    let extras: Vec<Extra> = asked.into_iter().filter_map(|(is_asked, extra)| is_asked.then_some(extra)).collect();
    let reports = solve_all(
        jobs,
        |case| {
            let trace = args.trace.as_ref().map(|_| Vec::new());
            progress.watch(case, Kept { trace, recorder: FrameRecorder::new(extras.clone()) })
        },
        |solution, kept, folder| {
            let dir = self::folder(args, several, &solution.case)?;
            let verification = args.bars.of(&solution, &progress, args.report);
            let verification = verification.as_ref();
            let (answer, findings) = stampflow::study::verify::answered(&solution, verification);
            let results = Results::of(&solution)?.verified(verification).answered(&answer, &findings);
            let results = results.with_pictures(&args.pictures.pictures());
            // Each is tried and told whatever became of the others.
            let pages = args.report.then(|| {
                let report = Report::answered(&solution, verification, (answer.clone(), findings.clone()));
                (PAGE, report.html())
            });
            let written = results.write(&kept.recorder, pages, folder);
            let traced = match (&args.trace, &kept.trace) {
                (Some(path), Some(iterations)) => write(path, &csv(&trace::table(iterations))),
                _ => Ok(()),
            };
            let files = written.as_deref().ok();
            let told = match args.json.json {
                true => Told::Json(as_json(&results, (&answer, &findings), &dir, files)?),
                false => Told::Text(args.told(&results, (&answer, &findings), &dir, files)),
            };
            let failures: Vec<WriteError> = [written.err(), traced.err()].into_iter().flatten().collect();
            Ok((told, Code::of_run(args.strict, solution.is_complete(), &answer), failures))
        },
    );
    let mut code = Code::Done;
    let (mut texts, mut values) = (Vec::new(), Vec::new());
    for report in reports {
        match report {
            Ok((told, of_case, unwritten)) => {
                match told {
                    Told::Text(text) => texts.push(text),
                    Told::Json(value) => values.push(value),
                }
                code = code.max(of_case);
                failed.extend(unwritten.into_iter().map(anyhow::Error::from));
            }
            Err(error) => failed.push(error),
        }
    }
    let said = match values.as_slice() {
        [] => texts.into_iter().reduce(Shown::add).map_or(Ok(code), say),
        [value] if !several => say_json(value),
        values => say_json(&values),
    };
    failed.extend(said.err());
    Ok(told(&failed, code))
}

/// The folder of a case's results, once all places that are written to are known to be free.
fn prepare(args: &Args, several: bool, case: &Case) -> anyhow::Result<ResultFolder> {
    let dir = folder(args, several, case)?;
    if let Some(path) = &args.trace {
        place::outside(path, &dir, "--trace")?;
        place::replaced(path, &csv(&trace::table(&[])), "--trace")?;
        place::file(path, &case.inputs, "--trace")?;
    }
    let page = dir.join(PAGE);
    if args.report && page.symlink_metadata().is_ok() && !is_report(&page) {
        let what = format!("{} is there and is no report of ours: choose another folder with --out", page.display());
        return Err(BadRequest(what).into());
    }
    Ok(place::results(case, &dir, |dir| result_folder(case, dir))?)
}

/// What is printed of a case.
enum Told {
    Text(Shown),
    Json(Value),
}

/// Each case has a name, and so a folder, of its own.
fn share_no_folder(cases: &[Case]) -> Result<(), BadRequest> {
    for (i, case) in cases.iter().enumerate() {
        if let Some(other) = cases[..i].iter().find(|other| other.name == case.name) {
            let (one, other) = (other.path.display(), case.path.display());
            let what = format!("{one} and {other} would write into one folder: run them one by one with --out");
            return Err(BadRequest(what));
        }
    }
    Ok(())
}

fn folder(args: &Args, several: bool, case: &Case) -> Result<PathBuf, BadRequest> {
    match &args.out {
        Some(dir) if several => place::folder(dir, case),
        Some(dir) => Ok(dir.clone()),
        None => place::folder(Path::new("out"), case),
    }
}

impl Args {
    /// The answer, of several cases in one line each; with --verbose also the solver's part.
    fn told(
        &self,
        results: &Results,
        (answer, findings): (&Answer, &[Finding]),
        dir: &Path,
        files: Option<&[PathBuf]>,
    ) -> Shown {
        let case = &results.solution.case;
        if self.cases.len() > 1 && !self.verbose {
            let written = files.map(|files| String::from(written(files, dir)));
            return answer::sentence(&case.name, answer, &written.unwrap_or_default());
        }
        let mut shown = answer::answered(case, answer, findings, results.verification);
        let summary = results.summary();
        if !summary.lines.is_empty() {
            shown = shown + wrapped(&format!("\n{}", String::from(summary.lines.clone())));
        }
        if self.verbose {
            shown = shown + summed_up(&summary);
        }
        let mut end = String::new();
        for comparison in &results.comparisons {
            let _ = writeln!(end, "{}", comparison.sentence());
        }
        if let Some(files) = files {
            let _ = writeln!(end, "{}", String::from(written(files, dir)));
        }
        shown + wrapped(&format!("\n{end}"))
    }
}

fn written(files: &[PathBuf], dir: &Path) -> String {
    format!("{n} files in {folder}", n = files.len(), folder = dir.display())
}

/// The summary of every stage as a table.
fn summed_up(summary: &CaseSummary) -> Shown {
    let tables = summary.stages.iter().map(|stage| {
        let rows = stage.rows().map(|row| row.map(Cell::plain));
        Shown::from("\n") + table(None, rows.collect())
    });
    tables.reduce(Shown::add).unwrap_or_default()
}

/// What `summary.json` says of the case, or of each of its stages, and what was compared and written.
fn as_json(
    results: &Results,
    (answer, findings): (&Answer, &[Finding]),
    dir: &Path,
    files: Option<&[PathBuf]>,
) -> anyhow::Result<Value> {
    let mut value = serde_json::to_value(results.summary())?;
    value["verdict"] = verdict(answer, findings, results.verification)?;
    let case = &results.solution.case.name;
    let comparisons = results.comparisons.iter().map(|comparison| json::comparison(case, comparison));
    value["comparisons"] = comparisons.collect();
    value["folder"] = json!(dir);
    value["files"] = json!(files.unwrap_or_default());
    Ok(value)
}
