//! `stampflow sweep` and `stampflow merge`: one case with many settings, in one table.

use super::code::Code;
use super::many::{Many, asked};
use super::parts::{Parts, options, quoted};
use super::rows::{Rows, all_there};
use super::say::{say, say_json};
use super::studied::Studied;
use super::table::wrapped;
use anyhow::Context;
use serde_json::json;
use stampflow::assess::Light;
use stampflow::output::study::keep;
use stampflow::study::{
    self, Begun, Columns, Designs, How, Journal, Plan, Results, Row, Shard, StudyError, Times, Vary,
};
use stampflow::units::Amount;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Instant;

pub const HELP: &str = "\
Every combination of the values is one run; the last key varies fastest. A value is \
a range, FROM..TO UNIT/N, or a list, A,B,C UNIT; keys joined by & go together. \
`friction` is that of every tool. A study file holds the same: case, set, \
one_at_a_time, [vary] and [[together]]. DIR/study.csv has one row a run, in order, the \
same bytes on any machine; what cannot be built is a row that says why. \
DIR/study_times.csv has what each run took.

The picture beside it: over one key curves with error bands, over two a process window \
(where it tears, wrinkles, asks too much of the press), over three a window for each \
value of the third; with --one-at-a-time a tornado. After a merge, --resume draws it.

Examples:
  stampflow sweep cup.toml --vary \"tools.die.shoulder=4..10 mm/7\"
  stampflow sweep cup.toml --vary friction=0.04,0.08,0.12 --vary \"tools.holder.force=5..30 kN/6\"
  stampflow sweep cup.toml --one-at-a-time --vary friction=0.04,0.12 --vary \
\"tools.die.shoulder=4,8 mm\"
  stampflow sweep study.toml --resume
  stampflow sweep study.toml --shard 7/64 --out shards
  stampflow sweep study.toml --shards 64 --print slurm

Exit codes: 0 done, 2 bad input, 130 interrupted (rows are kept, --resume goes on)";

pub const MERGE_HELP: &str = "\
Every shard of one study once, in any order; what is missing, there twice or of another study is refused, and nothing is \
written then. Curves that --keep wrote, and times, stay where the shards wrote them.

Example:
  stampflow merge shards/study-*-of-64.csv --out study.csv";

/// So many designs at most are read back to be drawn: that takes some 50 MB.
const PICTURED: u64 = 10_000;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file, or a study file
    #[arg(value_name = "CASE.toml|STUDY.toml")]
    file: PathBuf,
    /// A key and its values: KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT; as often as needed
    #[arg(long, value_name = "KEY=VALUES")]
    vary: Vec<String>,
    /// Each key by itself at each of its values, all else as it stands, instead of every combination
    #[arg(long)]
    one_at_a_time: bool,
    /// An error bar beside every number, from one coarser run of each design, a third of its time: as usual over one key
    #[arg(long)]
    error_bars: bool,
    /// No error bars over one key either
    #[arg(long, conflicts_with = "error_bars")]
    no_error_bars: bool,
    /// Keep more of each design than its row: curves, its load curve and its thickness, two CSV files by index in DIR/curves
    #[arg(long, value_name = "curves")]
    keep: Option<Keep>,
    #[command(flatten)]
    rows: Rows,
    #[command(flatten)]
    parts: Parts,
    #[command(flatten)]
    many: Many,
}

#[derive(Debug, clap::Args)]
pub struct MergeArgs {
    /// Tables of all shards of one study
    #[arg(required = true, value_name = "SHARD.csv")]
    shards: Vec<PathBuf>,
    /// The table to write
    #[arg(long, alias = "output", value_name = "FILE.csv")]
    out: PathBuf,
}

/// What is kept of each design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Keep {
    Curves,
}

pub fn sweep(args: &Args) -> anyhow::Result<Code> {
    let plan = args.plan().map_err(asked)?;
    let dir = args.many.folder(&args.file, "sweep");
    if let Some(lines) = args.parts.lines(&args.command(), "study", &dir) {
        return say(lines);
    }
    let (shard, indices) = (args.rows.shard(), args.rows.indices(plan.count(), "fewer values")?);
    let bars = plan.bars(args.bars());
    let count = args.many.count(&args.file, "designs");
    let base = study::base(plan.subject(), bars, &count).map_err(asked)?;
    let columns = Columns::of(&plan, &base);
    let path = dir.join(shard.file("study"));
    let mut tally = Tally::default();
    let mut kept = indices.len();
    let begin = Instant::now();
    if let Begun::Open(mut journal) =
        Journal::open(&path, plan.key(), &columns.header(), &indices, args.rows.earlier()).map_err(asked)?
    {
        kept = journal.done();
        let mut times = Times::open(&dir.join(shard.file("study_times")), kept > 0).map_err(asked)?;
        let ended = study::run(&plan, &indices[kept..], args.many.threads(), bars, &count, |row| {
            tally.add(&row);
            if args.keep == Some(Keep::Curves) {
                keep(&dir, &row).map_err(|error| io::Error::new(error.source.kind(), error))?;
            }
            times.add(row.design.index, row.seconds)?;
            journal.add(&columns.line(&plan, &row))
        });
        ended.with_context(|| format!("cannot write {}", journal.part().display()))?;
        if !all_there(&journal, indices.len()) {
            return Ok(Code::Done);
        }
        journal.finish().with_context(|| format!("cannot write {}", path.display()))?;
    }
    let ran = Ran { designs: indices.len(), kept, seconds: begin.elapsed().as_secs_f64() };
    // A part shows nothing by itself, and of so many there is nothing to see.
    if shard != Shard::WHOLE || plan.count() > PICTURED {
        let lights = json!({ "file": path, "designs": ran.designs, "kept": kept, "wall_s": ran.seconds,
                             "lights": tally.lights, "red": tally.red });
        return match args.many.json.json {
            true => say_json(&lights),
            false => say(wrapped(&format!("{}\n{}", tally.told(), ran.told(&path)))),
        };
    }
    let results = Results::read(&path, &plan, &base).map_err(asked)?;
    let studied = Studied::of(&results, &args.many, &dir, args.keep.is_some())?;
    match args.many.json.json {
        true => say_json(&studied.json(&results, &path, (ran.kept, ran.seconds))),
        false => say(wrapped(&format!("{}\n{}", studied.told(&results), ran.told(&path)))),
    }
}

/// How much was run, and how fast.
struct Ran {
    designs: usize,
    /// Of an earlier run.
    kept: usize,
    seconds: f64,
}

impl Ran {
    /// `400 designs (12 s, 2000 a minute) in out/cup-sweep/study.csv`
    fn told(&self, path: &Path) -> String {
        let Self { designs, kept, seconds } = *self;
        let n = study::designs(designs);
        let file = path.display().to_string();
        if kept == designs {
            return format!("{n}, all of an earlier run, in {file}");
        }
        let (time, rate) = (Amount::time(seconds), (60.0 * (designs - kept) as f64 / seconds).round() as usize);
        let said = match kept {
            0 => {
                format!("{n} ({time}, {rate} a minute) in {file}")
            }
            _ => format!("{n} ({time}, {rate} a minute, {kept} of an earlier run) in {file}"),
        };
        said.to_string()
    }
}

pub fn merge(args: &MergeArgs) -> anyhow::Result<Code> {
    let count = study::merge(&args.shards, &args.out).map_err(asked)?;
    let told = format!("{count} designs of {} shards in {}", args.shards.len(), args.out.display());
    say(wrapped(&format!("{told}; the same command with --resume and that folder as --out answers and draws")))
}

impl Args {
    fn plan(&self) -> Result<Plan, StudyError> {
        let overrides = self.many.overrides.all();
        let axes = self.vary.iter().map(|text| Vary::together(text)).collect::<Result<Vec<_>, _>>()?;
        let plan = match axes.is_empty() {
            true => study::file::load(&self.file, overrides),
            false => Plan::new(&self.file, overrides, axes),
        }?;
        Ok(if self.one_at_a_time { plan.made(How::OneAtATime) } else { plan })
    }

    /// Whether error bars are wanted, where it is said.
    fn bars(&self) -> Option<bool> {
        (self.error_bars || self.no_error_bars).then_some(self.error_bars)
    }

    /// What runs the same study, without its folder.
    fn command(&self) -> String {
        let flags = [
            (self.one_at_a_time, " --one-at-a-time"),
            (self.error_bars, " --error-bars"),
            (self.no_error_bars, " --no-error-bars"),
            (self.keep == Some(Keep::Curves), " --keep curves"),
        ];
        let flags = flags.into_iter().filter_map(|(is_given, flag)| is_given.then_some(flag));
        let options = options("--vary", &self.vary) + &options("--set", &self.many.overrides.all());
        format!("sweep {}{options}{}", quoted(&self.file.to_string_lossy()), flags.collect::<String>())
    }
}

/// How many designs have which light, and what is red.
#[derive(Default)]
struct Tally {
    lights: BTreeMap<&'static str, usize>,
    red: BTreeMap<&'static str, usize>,
}

/// What is counted of a design that is no case.
const NOT_RUN: &str = "not run";

impl Tally {
    fn add(&mut self, row: &Row) {
        let light = row.result.as_ref().map_or(NOT_RUN, |solved| solved.light.name());
        *self.lights.entry(light).or_default() += 1;
        for key in row.result.iter().flat_map(|solved| &solved.red) {
            *self.red.entry(key).or_default() += 1;
        }
    }

    /// `12 green, 3 amber, 5 red (thinning 5, wrinkling 1)`
    fn told(&self) -> String {
        let order = [Light::Green, Light::Amber, Light::Red, Light::Grey].map(Light::name).into_iter().chain([NOT_RUN]);
        let lights = order.filter_map(|light| Some(format!("{} {light}", self.lights.get(light)?)));
        let red: Vec<String> =
            self.red.iter().map(|(key, count)| format!("{} {count}", key.replace('_', " "))).collect();
        let why = if red.is_empty() { String::new() } else { format!(" ({})", red.join(", ")) };
        lights.collect::<Vec<_>>().join(", ") + &why
    }
}
