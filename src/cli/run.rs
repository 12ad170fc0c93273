//! `stampflow run`: from case files to folders of results.

use super::answer;
use super::code::{BadRequest, Code};
use super::error_bars::ErrorBars;
use super::job::{complained, load_all, prepared, solve_all};
use super::json;
use super::options::{Json, Overrides, PictureOptions, Threads};
use super::place;
use super::progress::{Progress, Records};
use super::say::{Shown, say, say_json};
use super::table::{Cell, table, wrapped};
use serde_json::{Value, json};
use stampflow::assess::{Answer, Finding};
use stampflow::case::Case;
use stampflow::plot::{Extra, FrameRecorder};
use stampflow::report::Report;
use stampflow::results::{
    OUTPUTS, ResultFolder, Results, WriteError, csv, is_report, result_folder, trace, verdict, write,
};
use std::ops::Add;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Case files; several run side by side
    #[arg(required = true, value_name = "CASE.toml")]
    cases: Vec<PathBuf>,
    /// Folder for the results [default: out/<case>]
    ///
    /// With several cases each has a folder of its own in it.
    #[arg(long, alias = "output", value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overrides: Overrides,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    /// Also write every iteration of the solver there
    #[arg(long, value_name = "FILE.csv", hide_short_help = true)]
    trace: Option<PathBuf>,
    /// Also write the moving section for ParaView
    #[arg(long)]
    vtu: bool,
    /// Also write shapes.gif, the moving section
    #[arg(long)]
    animate: bool,
    /// Also write report.html
    #[arg(long)]
    report: bool,
    /// Also print mesh, steps, norms and works
    #[arg(long, short)]
    verbose: bool,
    /// End with exit code 4 if the verdict is red
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

/// Page that --report writes.
const PAGE: &str = "report.html";

const HELP: &str = "\
With several stages each has a folder of its own, 1-draw, 2-retract, ..., and stages.csv sums them up. Results of an
earlier run are replaced in one step, so that you never have a mixture; other files stay.

Examples:
  stampflow run cases/quickstart.toml
  stampflow run cases/quickstart.toml --set tools.punch.friction=0.1 --out out/friction-0.1
  stampflow run cases/quickstart.toml --error-bars
  stampflow run cases/*.toml --out results --quiet

If one of several cases fails, the others still run. Exit codes: 0 done, 2 bad input or a place that cannot be written
to, 3 stopped early, 4 with --strict: the verdict is red, 130 interrupted by Ctrl-C (in these three cases results are kept),
1 anything else";

/// Long help, with the list of outputs.
pub fn help() -> String {
    let files = OUTPUTS.iter().map(|output| format!("  {:<18} {}\n", output.file, output.about));
    format!("Written files:\n{}{HELP}", files.collect::<String>())
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
    let extras = [(args.vtu, Extra::Vtu), (args.animate, Extra::Animation)].into_iter();
    let extras: Vec<Extra> = extras.filter_map(|(is_wanted, extra)| is_wanted.then_some(extra)).collect();
    let reports = solve_all(
        jobs,
        |case| {
            let trace = args.trace.as_ref().map(|_| Vec::new());
            progress.watch(case, Records { trace, recorder: FrameRecorder::new(extras.clone()) })
        },
        |solution, records, folder| {
            let dir = self::folder(args, several, &solution.case)?;
            let verification = args.bars.of(&solution, &progress, args.report);
            let verification = verification.as_ref();
            let (answer, findings) = stampflow::verification::answered(&solution, verification);
            let results = Results::of(&solution)?.verified(verification).answered(&answer, &findings);
            let results = results.with_pictures(&args.pictures.pictures());
            // Each is tried and told whatever became of the others.
            let pages = args.report.then(|| {
                let report = Report::answered(&solution, verification, (answer.clone(), findings.clone()));
                (PAGE, report.html())
            });
            let written = results.write(&records.recorder, pages, folder);
            let traced = match (&args.trace, &records.trace) {
                (Some(path), Some(iterations)) => write(path, &csv(&trace::table(iterations))),
                _ => Ok(()),
            };
            let files = written.as_deref().ok();
            let verdict = (&answer, &findings[..]);
            let (shown, value) = match args.json.json {
                true => (None, Some(as_json(&results, verdict, &dir, files)?)),
                false => (Some(args.screen(&results, verdict, &dir, files)), None),
            };
            let failures: Vec<WriteError> = [written.err(), traced.err()].into_iter().flatten().collect();
            Ok((shown, value, Code::of_run(args.strict, solution.is_complete(), &answer), failures))
        },
    );
    let (mut code, mut screen, mut values) = (Code::Done, None, Vec::new());
    for report in reports {
        match report {
            Ok((shown, value, of_case, unwritten)) => {
                screen = [screen, shown].into_iter().flatten().reduce(Shown::add);
                values.extend(value);
                code = code.max(of_case);
                failed.extend(unwritten.into_iter().map(anyhow::Error::from));
            }
            Err(error) => failed.push(error),
        }
    }
    let printed = match values.as_slice() {
        [] => screen.map_or(Ok(code), say),
        [value] if !several => say_json(value),
        values => say_json(&values),
    };
    failed.extend(printed.err());
    Ok(complained(&failed, code))
}

/// Folder of a case's results, once all places to write to are known to be free.
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

/// Refuses two cases of one name, which would share a folder.
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
    /// The answer, with several cases in one line each; with --verbose also the solver's part.
    fn screen(
        &self,
        results: &Results,
        (answer, findings): (&Answer, &[Finding]),
        dir: &Path,
        files: Option<&[PathBuf]>,
    ) -> Shown {
        let case = &results.solution.case;
        let written = files.map_or(String::new(), |files| format!("{} files in {}", files.len(), dir.display()));
        if self.cases.len() > 1 && !self.verbose {
            return answer::sentence(&case.name, answer, &written);
        }
        let mut shown = answer::answered(case, answer, findings, results.verification);
        let summary = results.summary();
        if !summary.lines.is_empty() {
            shown = shown + wrapped(&format!("\n{}", summary.lines));
        }
        for stage in summary.stages.iter().filter(|_| self.verbose) {
            shown = shown + "\n".into() + table(None, stage.rows().map(|row| row.map(Cell::from)).collect());
        }
        let comparisons = results.comparisons.iter().map(|comparison| comparison.sentence() + "\n");
        shown + wrapped(&format!("\n{}{written}\n", comparisons.collect::<String>()))
    }
}

/// The contents of `summary.json`, the verdict, comparisons and files.
fn as_json(
    results: &Results,
    (answer, findings): (&Answer, &[Finding]),
    dir: &Path,
    files: Option<&[PathBuf]>,
) -> anyhow::Result<Value> {
    let mut value = serde_json::to_value(results.summary())?;
    value["verdict"] = verdict(answer, findings, results.verification)?;
    let case = &results.solution.case.name;
    value["comparisons"] = results.comparisons.iter().map(|comparison| json::comparison(case, comparison)).collect();
    value["folder"] = json!(dir);
    value["files"] = json!(files.unwrap_or_default());
    Ok(value)
}
