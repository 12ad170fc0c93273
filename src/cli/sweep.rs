//! `stampflow sweep` and `stampflow merge`: one case with many settings, in one table.

use super::code::{BadRequest, Code};
use super::many::{Many, asked};
use super::say::{say, say_json, warn};
use super::table::wrapped;
use anyhow::Context;
use serde_json::json;
use stampflow::assess::Light;
use stampflow::study::{self, Begun, Columns, Designs, Earlier, Journal, Plan, Row, Shard, StudyError, Vary};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Every combination of the values is one run; the last key varies fastest. A value is \
a range, FROM..TO UNIT/N, or a list, A,B,C UNIT; keys joined by & go together. \
`friction` is that of every tool. A study file holds the same: case, set, [vary] and \
[[together]]. DIR/study.csv has one row a run, in order; what cannot be built is a row \
that says why.

Examples:
  stampflow sweep cup.toml --vary \"tools.die.shoulder=4..10 mm/7\"
  stampflow sweep cup.toml --vary friction=0.04,0.08,0.12 --vary \"tools.holder.force=5..30 kN/6\"
  stampflow sweep study.toml --resume
  stampflow sweep study.toml --shard 7/64 --out shards
  stampflow sweep study.toml --shards 64 --print slurm

Exit codes: 0 done, 2 bad input, 130 interrupted (rows are kept, --resume goes on)";

pub const MERGE_HELP: &str = "\
Every shard of one study once, in any order; what is missing, there twice or of another study is refused, and nothing is \
written then.

Example:
  stampflow merge shards/study-*-of-64.csv --out study.csv";

/// So many runs are begun without a word.
const MANY: u64 = 100_000;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file, or a study file
    #[arg(value_name = "CASE.toml|STUDY.toml")]
    file: PathBuf,
    /// A key and its values: KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT; as often as needed
    #[arg(long, value_name = "KEY=VALUES")]
    vary: Vec<String>,
    /// Go on with the rows that an earlier run has left, once no other run is at it
    #[arg(long)]
    resume: bool,
    /// Remove the rows that an earlier run has left
    #[arg(long, conflicts_with = "resume")]
    restart: bool,
    /// Run one part of so many, such as 7/64, into a table of its own
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
    /// With --print: how many parts
    #[arg(long, value_name = "N", requires = "print", value_parser = clap::value_parser!(u32).range(1..))]
    shards: Option<u32>,
    /// Print the lines that run all parts: on HyperQueue, as a Slurm job array, or on this machine
    #[arg(long, value_name = "hq|slurm|xargs", requires = "shards")]
    print: Option<Scheduler>,
    /// Begin more than 100 000 runs without asking
    #[arg(long)]
    yes: bool,
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

/// What runs shards.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Scheduler {
    Hq,
    Slurm,
    Xargs,
}

pub fn sweep(args: &Args) -> anyhow::Result<Code> {
    let plan = args.plan().map_err(asked)?;
    let dir = args.many.folder(&args.file, "sweep");
    if let (Some(scheduler), Some(shards)) = (args.print, args.shards) {
        return say(args.lines(scheduler, shards, &dir));
    }
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    let runs = shard.count(plan.count());
    if runs > MANY && !args.yes {
        let what = format!("{runs} runs are asked for, more than {MANY}");
        return Err(BadRequest(format!("{what}: give --yes if that is meant, or fewer values, or --shard")).into());
    }
    let indices = shard.indices(plan.count());
    let count = args.many.count(&args.file, "designs");
    let base = study::base(plan.subject(), &count).map_err(asked)?;
    let columns = Columns::of(&plan, &base);
    let path = dir.join(shard.file("study"));
    let earlier = match (args.resume, args.restart) {
        (true, _) => Earlier::Resume,
        (_, true) => Earlier::Restart,
        _ => Earlier::Refuse,
    };
    let begun = Journal::open(&path, &columns.header(), &indices, earlier).map_err(asked)?;
    let Begun::Open(mut journal) = begun else {
        return say(format!("{} is complete: {} designs", path.display(), indices.len()));
    };
    let kept = journal.done();
    let mut tally = Tally::default();
    let ended = study::run(&plan, &indices[kept..], args.many.threads(), &count, |row| {
        tally.add(&row);
        journal.add(&columns.line(&plan, &row))
    });
    ended.with_context(|| format!("cannot write {}", journal.part().display()))?;
    let done = journal.done();
    if done < indices.len() {
        warn(format!(
            "{done} of {} designs are in {}; --resume goes on with the others",
            indices.len(),
            journal.part().display()
        ));
        return Ok(Code::Done);
    }
    journal.finish().with_context(|| format!("cannot write {}", path.display()))?;
    if args.many.json.json {
        return say_json(
            &json!({ "file": path, "designs": done, "kept": kept, "lights": tally.lights, "red": tally.red }),
        );
    }
    say(wrapped(&format!("{}\n{} designs in {}", tally.told(), done, path.display())))
}

pub fn merge(args: &MergeArgs) -> anyhow::Result<Code> {
    let count = study::merge(&args.shards, &args.out).map_err(asked)?;
    say(format!("{count} designs of {} shards in {}", args.shards.len(), args.out.display()))
}

impl Args {
    fn plan(&self) -> Result<Plan, StudyError> {
        let overrides = self.many.overrides.all();
        let axes = self.vary.iter().map(|text| Vary::together(text)).collect::<Result<Vec<_>, _>>()?;
        match axes.is_empty() {
            true => study::file::load(&self.file, overrides),
            false => Plan::new(&self.file, overrides, axes),
        }
    }

    /// What to paste.
    fn lines(&self, scheduler: Scheduler, shards: u32, dir: &Path) -> String {
        let mut command = format!("stampflow sweep {}", quoted(&self.file.to_string_lossy()));
        for vary in &self.vary {
            let _ = write!(command, " --vary {}", quoted(vary));
        }
        for set in self.many.overrides.all() {
            let _ = write!(command, " --set {}", quoted(&set));
        }
        let folder = quoted(&dir.to_string_lossy());
        let _ = write!(command, " --out {folder} --quiet --resume --threads 1");
        let tables = format!("{folder}/study-*-of-{shards}.csv");
        let run = match scheduler {
            Scheduler::Hq => format!(
                "hq submit --array 1-{shards} --cpus 1 --crash-limit 5 --wait -- \\\n  bash -c {}",
                quoted(&format!("exec {command} --shard $HQ_TASK_ID/{shards}"))
            ),
            Scheduler::Slurm => format!(
                "sbatch --array=1-{shards} --cpus-per-task=1 --requeue --wait --wrap {}",
                quoted(&format!("{command} --shard $SLURM_ARRAY_TASK_ID/{shards}"))
            ),
            Scheduler::Xargs => {
                format!("seq 1 {shards} | xargs -P \"$(nproc)\" -I SHARD \\\n  {command} --shard SHARD/{shards}")
            }
        };
        format!("{run}\nstampflow merge {tables} --out {folder}/study.csv\n")
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

/// For a shell.
fn quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,".contains(c);
    if text.chars().all(is_plain) && !text.is_empty() {
        text.into()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}
