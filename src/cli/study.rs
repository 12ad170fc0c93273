//! Options and output that all studies share.

use super::code::{BadRequest, Code};
use super::options::{Json, Overrides, PictureOptions, Threads};
use super::place;
use super::progress::{Count, Progress};
use super::screen::{ScreenText, print, print_json, table, warn, wrapped};
use anyhow::Context;
use serde::Serialize;
use stampflow::results::ResultFolder;
use stampflow::study::Watch;
use stampflow::study::{
    Evaluated, Evaluation, ReportTable, Shard, Study, StudyError, StudyReport, TableFile, begin, evaluate,
};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;
use std::time::Instant;

/// Designs that are begun without --yes.
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
        #[derive(Serialize)]
        struct ReportJson<'a, T> {
            #[serde(flatten)]
            report: &'a StudyReport,
            #[serde(flatten)]
            extra: &'a T,
            files: &'a [PathBuf],
        }
        let pictures = self.pictures.pictures();
        let charts = report.charts.iter().flat_map(|(name, chart)| pictures.files(name, chart));
        let tables = || report.tables.iter().filter(|table| !table.rows.is_empty());
        let mut folder = ResultFolder::open(dir, |_, _| false)?;
        for (name, bytes) in
            files.into_iter().chain(tables().map(|t| (format!("{}.csv", t.name), t.csv()))).chain(charts)
        {
            folder.write(name, &bytes)?;
        }
        let files = &folder.commit()?;
        if self.json.json {
            print_json(&ReportJson { report, extra, files })?;
        } else {
            let notes: String = report.notes.iter().map(|note| format!("\n- {note}")).collect();
            let text = wrapped(&format!("{}{notes}", report.headline));
            let text = tables().fold(text, |text, table| text + "\n".into() + screen_table(table));
            print(text + wrapped(&format!("\n{}", dir.display())))?;
        }
        Ok(if report.found { Code::Done } else { Code::Failed })
    }
}

/// Evaluates a study into its table and presents it; `each` sees every new run.
pub fn run(
    study: &mut dyn Study,
    (file, verb, name): (&Path, &str, &str),
    (options, rows, shard): (&StudyOptions, &TableOptions, Option<&ShardOptions>),
    errors: bool,
    each: &mut dyn FnMut(&Evaluated) -> anyhow::Result<()>,
) -> anyhow::Result<Code> {
    /// Numbers of a run table, for JSON.
    #[derive(Serialize)]
    struct Summary {
        designs: usize,
        lights: BTreeMap<&'static str, usize>,
        file: PathBuf,
        wall_s: f64,
    }
    let dir = options.folder(file, verb);
    let own = shard.and_then(|shard| shard.shard).unwrap_or(Shard::WHOLE);
    let count = own.len(study.plan().designs);
    if count > MANY && shard.is_some_and(|shard| !shard.yes) {
        let what = format!("{count} runs are asked for, more than {MANY}: give --yes if that is meant, or --shard");
        return Err(BadRequest(what).into());
    }
    let path = dir.join(own.file(name));
    place::file(&path, &[file.to_owned()], "--out")?;
    let start = Instant::now();
    let watch = options.count(file, "runs");
    let settings = Evaluation { threads: options.threads(), errors, shard: own, watch: &watch };
    let runs = begin(study, &settings).map_err(request)?;
    let mut table = TableFile::open(&path, &runs, rows.resume, rows.restart).map_err(request)?;
    let kept = std::mem::take(&mut table.earlier);
    let mut failed = Ok(());
    let runs = evaluate(study, &settings, runs, &kept, &mut |runs, evaluated| {
        let added = table.add(runs, &evaluated.run).with_context(|| format!("cannot write {}", path.display()));
        failed = added.and_then(|()| each(evaluated));
        if failed.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    failed?;
    if watch.wants_to_stop() && (study.plan().designs == 0 || (runs.runs.len() as u64) < count) {
        let part = table.part.display();
        warn(format!("{} runs are in {part}; --resume goes on with the others", runs.runs.len()));
        return Ok(Code::Done);
    }
    if own != Shard::WHOLE {
        table.finish().with_context(|| format!("cannot write {}", path.display()))?;
        let (n, path) = (runs.runs.len(), path.display());
        return print(wrapped(&format!("{n} runs in {path}; `stampflow merge` joins the shards")));
    }
    let rows = std::fs::read(&table.part).with_context(|| format!("cannot read {}", table.part.display()))?;
    let wall_s = start.elapsed().as_secs_f64();
    let summary = Summary { designs: runs.runs.len(), lights: runs.lights(), file: path, wall_s };
    let code = options.present(&study.report(&runs), &dir, vec![(own.file(name), rows)], &summary)?;
    table.discard();
    Ok(code)
}

/// A wrong study as bad input.
pub fn request(error: StudyError) -> anyhow::Error {
    match error {
        StudyError::Case(error) => error.into(),
        error @ StudyError::Request { .. } => BadRequest(error.to_string()).into(),
    }
}

/// A table of results on the screen.
pub fn screen_table(table: &ReportTable) -> ScreenText {
    self::table(&table.columns.iter().map(String::as_str).collect::<Vec<_>>(), table.rows.clone())
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "study".into(), |stem| stem.to_string_lossy().into_owned())
}
