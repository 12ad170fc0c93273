//! `stampflow run`: from case files to folders of results.

use super::bug::caught;
use super::code::{BadRequest, Code};
use super::job::{complained, load_all, sound};
use super::options::{ErrorBars, Json, Overrides, PictureOptions, Threads};
use super::progress::{Progress, Records};
use super::screen::{Cell, ScreenText, print, print_json, table, wrapped};
use super::{answer, interrupt, json, place};
use rayon::prelude::*;
use serde_json::{Value, json};
use stampflow::case::Case;
use stampflow::plot::{Extra, FrameRecorder};
use stampflow::report::Report;
use stampflow::results::error_bars::answered;
use stampflow::results::{
    OUTPUTS, ResultFolder, Results, WriteError, is_report, result_folder, tables, verdict, write,
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
    let several = args.cases.len() > 1;
    if args.trace.is_some() && several {
        return Err(BadRequest("--trace writes the iterations of one case: give one case".to_owned()).into());
    }
    let (cases, mut failed) = load_all(&args.cases, &args.overrides.all());
    share_no_folder(&cases)?;
    let jobs = sound(cases.into_iter().map(|case| args.prepare(&case).map(|folder| (case, folder))), &mut failed);
    args.threads.apply()?;
    let progress = Progress::new(args.quiet || args.json.json);
    // After an interrupt no other case begins.
    let runs = jobs.into_par_iter().filter(|_| !interrupt::is_wanted());
    let runs =
        runs.map(|(case, folder)| caught(&format!("case {}", case.name), || args.solve(case, folder, &progress)));
    let runs = sound(runs.collect::<Vec<_>>(), &mut failed);
    let code = runs.iter().map(|run| run.code).fold(Code::Done, Code::max);
    let (mut screen, mut values) = (None, Vec::new());
    for run in runs {
        screen = [screen, run.screen].into_iter().flatten().reduce(ScreenText::add);
        values.extend(run.json);
        failed.extend(run.unwritten.into_iter().map(anyhow::Error::from));
    }
    let printed = match values.as_slice() {
        [] => screen.map_or(Ok(code), print),
        [value] if !several => print_json(value),
        values => print_json(&values),
    };
    failed.extend(printed.err());
    Ok(complained(&failed, code))
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

/// A case that was run: its output, as text or JSON, and files that could not be written.
struct Run {
    screen: Option<ScreenText>,
    json: Option<Value>,
    code: Code,
    unwritten: Vec<WriteError>,
}

impl Args {
    fn folder(&self, case: &Case) -> Result<PathBuf, BadRequest> {
        match &self.out {
            Some(dir) if self.cases.len() == 1 => Ok(dir.clone()),
            out => place::folder(out.as_deref().unwrap_or(Path::new("out")), case),
        }
    }

    /// Folder of a case's results, once all places to write to are known to be free.
    fn prepare(&self, case: &Case) -> anyhow::Result<ResultFolder> {
        let dir = self.folder(case)?;
        if let Some(path) = &self.trace {
            place::outside(path, &dir, "--trace")?;
            place::replaced(path, &tables::iterations(&[]), "--trace")?;
            place::file(path, &case.inputs, "--trace")?;
        }
        let page = dir.join(PAGE);
        if self.report && page.symlink_metadata().is_ok() && !is_report(&page) {
            let page = page.display();
            let what = format!("{page} is there and is no report of ours: choose another folder with --out");
            return Err(BadRequest(what).into());
        }
        Ok(place::results(case, &dir, |dir| result_folder(case, dir))?)
    }

    fn solve(&self, case: Case, folder: ResultFolder, progress: &Progress) -> anyhow::Result<Run> {
        let dir = self.folder(&case)?;
        let extras = [(self.vtu, Extra::Vtu), (self.animate, Extra::Animation)];
        let extras = extras.into_iter().filter_map(|(is_wanted, extra)| is_wanted.then_some(extra)).collect();
        let records = Records { trace: self.trace.as_ref().map(|_| Vec::new()), recorder: FrameRecorder::new(extras) };
        let (solution, records) = progress.watch(&case, records).solve(case);
        let verification = self.bars.of(&solution, progress, self.report);
        let verification = verification.as_ref();
        let (answer, findings) = answered(&solution, verification);
        let results = Results::of(&solution)?.verified(verification).answered(&answer, &findings);
        let results = results.with_pictures(&self.pictures.pictures());
        let page = || Report::answered(&solution, verification, (answer.clone(), findings.clone())).html();
        // Each is tried whatever became of the other.
        let written = results.write(&records.recorder, self.report.then(|| (PAGE, page())), folder);
        let traced = match (&self.trace, &records.trace) {
            (Some(path), Some(iterations)) => write(path, &tables::iterations(iterations)),
            _ => Ok(()),
        };
        let (case, files) = (&solution.case, written.as_deref());
        let (screen, json) = if self.json.json {
            let mut value = serde_json::to_value(results.summary())?;
            value["verdict"] = verdict(&answer, &findings, verification);
            value["comparisons"] = results.comparisons.iter().map(|one| json::comparison(&case.name, one)).collect();
            value["folder"] = json!(dir);
            value["files"] = json!(files.unwrap_or_default());
            (None, Some(value))
        } else {
            let files = files.map_or(String::new(), |files| format!("{} files in {}", files.len(), dir.display()));
            let is_short = self.cases.len() > 1 && !self.verbose;
            (
                Some(match is_short {
                    true => answer::sentence(&case.name, &answer, &files),
                    false => answer::answered(case, &answer, &findings, verification) + self.rest(&results, &files),
                }),
                None,
            )
        };
        let code = Code::of_run(self.strict, solution.is_complete(), &answer);
        Ok(Run { screen, json, code, unwritten: [written.err(), traced.err()].into_iter().flatten().collect() })
    }

    /// Printed text below the answer, with --verbose also the solver's part.
    fn rest(&self, results: &Results, files: &str) -> ScreenText {
        let (summary, mut text) = (results.summary(), ScreenText::default());
        if !summary.lines.is_empty() {
            text = wrapped(&format!("\n{}", summary.lines));
        }
        for stage in summary.stages.iter().filter(|_| self.verbose) {
            text = text + "\n".into() + table(&[], stage.rows().map(|row| row.map(Cell::from)));
        }
        let comparisons = results.comparisons.iter().map(|comparison| comparison.sentence() + "\n");
        text + wrapped(&format!("\n{}{files}\n", comparisons.collect::<String>()))
    }
}
