//! Options and output that all studies share.

use super::code::{BadRequest, Code};
use super::options::{Json, Overrides, PictureOptions, Threads};
use super::place;
use super::progress::{Count, Progress};
use super::say::{Shown, say, say_json, warn};
use super::table::{Cell, Tone, table_of, wrapped};
use anyhow::Context;
use serde::Serialize;
use stampflow::results::ResultFolder;
use stampflow::study::{
    self, Earlier, Evaluated, Evaluation, ReportTable, RunTable, Shard, Study, StudyError, StudyReport, TableFile,
    begin, evaluate,
};
use stampflow::verification::Watch;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;
use std::time::Instant;

/// Designs that are begun without --yes, and rows that are drawn.
const MANY: u64 = 100_000;

/// Options of every study.
#[derive(Debug, clap::Args)]
pub struct StudyOptions {
    #[command(flatten)]
    pub overrides: Overrides,
    /// Folder for the results [default: out/<file>-<verb>]
    #[arg(long, alias = "output", value_name = "DIR")]
    out: Option<PathBuf>,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    pub pictures: PictureOptions,
    #[command(flatten)]
    pub json: Json,
}

/// Options of studies with a run table.
#[derive(Debug, clap::Args)]
pub struct TableOptions {
    /// Keep the rows that an earlier run has left, and run what is missing
    #[arg(long)]
    resume: bool,
    /// Remove the rows that an earlier run has left
    #[arg(long, conflicts_with = "resume")]
    restart: bool,
}

/// Options of studies whose designs are known in advance.
#[derive(Debug, clap::Args)]
pub struct ShardOptions {
    /// Run one share of so many, such as 7/64, into a table of its own
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
    /// Begin more than 100 000 runs without asking
    #[arg(long)]
    yes: bool,
}

impl StudyOptions {
    /// Folder of the results.
    pub fn folder(&self, file: &Path, verb: &str) -> PathBuf {
        self.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{}-{verb}", stem(file))))
    }

    /// Progress of the runs of a file.
    pub fn count(&self, file: &Path, what: &str) -> Count {
        Progress::new(self.quiet || self.json.json).count(format!("{}, {what}", stem(file)))
    }

    /// Runs at the same time: one per core by default.
    pub fn threads(&self) -> usize {
        self.threads.count().or_else(|| available_parallelism().ok().map(usize::from)).unwrap_or(1)
    }

    /// Writes charts, tables and other files as one set; prints the report.
    pub fn present<T: Serialize>(
        &self,
        report: &StudyReport,
        dir: &Path,
        files: Vec<(String, Vec<u8>)>,
        extra: &T,
    ) -> anyhow::Result<Code> {
        let written = self.write(report, dir, files)?;
        self.print(report, dir, &written, extra)
    }

    fn write(&self, report: &StudyReport, dir: &Path, files: Vec<(String, Vec<u8>)>) -> anyhow::Result<Vec<PathBuf>> {
        let pictures = self.pictures.pictures();
        let charts = report.charts.iter().flat_map(|(name, chart)| pictures.files(name, chart));
        let tables = report.tables.iter().filter(|table| !table.rows.is_empty());
        let tables = tables.map(|table| (format!("{}.csv", table.name), table.csv()));
        let mut folder = ResultFolder::open(dir, |_, _| false)?;
        for (name, bytes) in files.into_iter().chain(tables).chain(charts) {
            folder.write(name, &bytes)?;
        }
        Ok(folder.commit()?)
    }

    fn print<T: Serialize>(
        &self,
        report: &StudyReport,
        dir: &Path,
        files: &[PathBuf],
        extra: &T,
    ) -> anyhow::Result<Code> {
        if self.json.json {
            say_json(&ReportJson { report, extra, files })?;
        } else {
            say(screen(report) + wrapped(&format!("\n{}", dir.display())))?;
        }
        Ok(if report.found { Code::Done } else { Code::Failed })
    }
}

#[derive(Serialize)]
struct ReportJson<'a, T> {
    #[serde(flatten)]
    report: &'a StudyReport,
    #[serde(flatten)]
    extra: &'a T,
    files: &'a [PathBuf],
}

/// Numbers of a run table, for JSON.
#[derive(Serialize)]
struct Summary {
    designs: usize,
    lights: study::LightCounts,
    file: PathBuf,
    wall_s: f64,
}

/// Evaluates a study into its table and presents it.
pub fn run(
    study: &mut dyn Study,
    (file, verb, stem): (&Path, &str, &str),
    options: &StudyOptions,
    rows: &TableOptions,
    shard: Option<&ShardOptions>,
    errors: bool,
    each: &mut dyn FnMut(&Evaluated) -> anyhow::Result<()>,
) -> anyhow::Result<Option<(RunTable, StudyReport, PathBuf, Code)>> {
    let dir = options.folder(file, verb);
    let own = shard.and_then(|shard| shard.shard).unwrap_or(Shard::WHOLE);
    let count = own.len(study.designs());
    if count > MANY && shard.is_some_and(|shard| !shard.yes) {
        let what = format!("{count} runs are asked for, more than {MANY}: give --yes if that is meant, or --shard");
        return Err(BadRequest(what).into());
    }
    let path = dir.join(own.file(stem));
    place::file(&path, &[file.to_owned()], "--out")?;
    let start = Instant::now();
    let watch = options.count(file, "runs");
    let settings = Evaluation { threads: options.threads(), errors, shard: own, watch: &watch };
    let runs = begin(study, &settings).map_err(request)?;
    let earlier = match (rows.resume, rows.restart) {
        (true, _) => Earlier::Resume,
        (_, true) => Earlier::Restart,
        _ => Earlier::Refuse,
    };
    let mut table = TableFile::open(&path, &runs, earlier).map_err(request)?;
    let kept = std::mem::take(&mut table.earlier);
    let mut failed = None;
    let runs = evaluate(study, &settings, runs, &kept, &mut |runs, evaluated| {
        let added = table.add(runs, &evaluated.run).with_context(|| format!("cannot write {}", path.display()));
        match added.and_then(|()| each(evaluated)) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                failed = Some(error);
                ControlFlow::Break(())
            }
        }
    });
    if let Some(error) = failed {
        return Err(error);
    }
    if watch.wants_to_stop() && (study.designs() == 0 || (runs.runs.len() as u64) < count) {
        let part = table.part().display();
        warn(format!("{} runs are in {part}; --resume goes on with the others", runs.runs.len()));
        return Ok(None);
    }
    if own != Shard::WHOLE {
        table.finish().with_context(|| format!("cannot write {}", path.display()))?;
        let told = format!("{} runs in {}; `stampflow merge` joins the shards", runs.runs.len(), path.display());
        say(wrapped(&told))?;
        return Ok(None);
    }
    let report = study.report(&runs);
    let wall_s = start.elapsed().as_secs_f64();
    let summary = Summary { designs: runs.runs.len(), lights: runs.lights(), file: path, wall_s };
    let rows = std::fs::read(table.part()).with_context(|| format!("cannot read {}", table.part().display()))?;
    let written = options.write(&report, &dir, vec![(own.file(stem), rows)])?;
    table.discard();
    let code = options.print(&report, &dir, &written, &summary)?;
    Ok(Some((runs, report, dir, code)))
}

/// A wrong study as bad input.
pub fn request(error: StudyError) -> anyhow::Error {
    match error {
        StudyError::Case(error) => error.into(),
        error @ StudyError::Request { .. } => BadRequest(error.to_string()).into(),
    }
}

fn screen(report: &StudyReport) -> Shown {
    let mut shown = wrapped(&report.headline);
    for note in &report.notes {
        shown = shown + wrapped(&format!("- {note}"));
    }
    let tables = report.tables.iter().filter(|table| !table.rows.is_empty());
    tables.fold(shown, |shown, table| shown + "\n".into() + screen_table(table))
}

/// A table of results on the screen.
pub fn screen_table(of: &ReportTable) -> Shown {
    let cell = |cell: &study::Cell| Cell {
        text: cell.to_string(),
        tone: if let study::Cell::Light(light, _) = cell { Tone::of(*light) } else { Tone::Plain },
    };
    let rows = of.rows.iter().map(|row| row.iter().map(cell).collect()).collect();
    table_of(Some(of.columns.iter().map(String::as_str).collect()), rows)
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "study".into(), |stem| stem.to_string_lossy().into_owned())
}
