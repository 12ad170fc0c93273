//! `stampflow scatter`: how sure a verdict is when coil, friction, thickness and press scatter.

use super::code::Code;
use super::many::{Many, asked, write_all};
use super::parts::{Parts, options, quoted};
use super::rows::{Rows, all_there};
use super::say::{Shown, say, say_json};
use super::table::{Cell, Tone, table, wrapped};
use anyhow::Context;
use stampflow::output::study::{json, scatter_pictures, scatter_tables};
use stampflow::study::scatter::{Asked, Base, Correlation, Estimate, Event, Factor, Found, Sample, Scatter, file};
use stampflow::study::{self, Bars, Begun, Designs, Journal, Shard, StudyError, Subject};
use stampflow::units::{Amount, joined};
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Each key has a distribution; the runs are a quasi-random sample of them (scrambled \
Sobol points, 16 scramblings that are independent of each other). `friction` is that \
of every tool, `strength` a factor on all stresses of the hardening law. Without \
--vary what is declared scatters: friction, and of a sheet of the library thickness \
and strength by its standard. DIR has the sample (scatter.csv), quantiles, lights, \
indices and bands as tables, and the pictures of them.

A distribution is one of
  uniform LOW..HIGH UNIT            normal MEAN ± DEVIATION UNIT
  uniform ± HALF UNIT               normal ± DEVIATION UNIT in LOW..HIGH UNIT
without a middle about the case's own value; % is of the middle, +- is ±.

Examples:
  stampflow scatter cup.toml
  stampflow scatter cup.toml --vary \"friction=uniform 0.05..0.12\" \\
    --vary \"blank.thickness=normal ± 0.02 mm in ± 0.05 mm\" --indices
  stampflow scatter cup.toml --vary \"material.hardening.swift.k=normal ± 5 %\" \\
    --vary \"material.hardening.swift.n=normal ± 4 %\" \\
    --correlate \"material.hardening.swift.k,material.hardening.swift.n=-0.8\"
  stampflow scatter study.toml --shard 7/64 --out shards
  stampflow merge shards/scatter-*-of-64.csv --out out/study-scatter/scatter.csv
  stampflow scatter study.toml --resume
  stampflow scatter cup.toml --shards 64 --print slurm

Exit codes: 0 done, 2 bad input, 130 interrupted (rows are kept, --resume goes on)";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file, or a study file with [scatter]
    #[arg(value_name = "CASE.toml|STUDY.toml")]
    file: PathBuf,
    /// A key and how it scatters, as often as needed
    #[arg(long, value_name = "KEY=DISTRIBUTION")]
    vary: Vec<String>,
    /// Two keys that go together, with their correlation between -1 and 1
    #[arg(long, value_name = "KEY,KEY=NUMBER")]
    correlate: Vec<String>,
    /// Points of the sample; best a power of two [default: 1024]
    #[arg(long, value_name = "N")]
    runs: Option<u64>,
    /// Another sample of the same: any whole number [default: 1]
    #[arg(long, value_name = "N")]
    seed: Option<u32>,
    /// Also say what share of each number's variance is whose: so many times the runs as keys, and two more
    #[arg(long)]
    indices: bool,
    #[command(flatten)]
    rows: Rows,
    #[command(flatten)]
    parts: Parts,
    #[command(flatten)]
    many: Many,
}

pub fn scatter(args: &Args) -> anyhow::Result<Code> {
    let scatter = args.scatter().map_err(asked)?;
    let dir = args.many.folder(&args.file, "scatter");
    if let Some(lines) = args.parts.lines(&args.command(), "scatter", &dir) {
        return say(lines);
    }
    let (shard, indices) = (args.rows.shard(), args.rows.indices(scatter.count(), "fewer --runs")?);
    let path = dir.join(shard.file("scatter"));
    let count = args.many.count(&args.file, "parts");
    let base = Base::of(&scatter, &count).map_err(asked)?;
    if let Begun::Open(mut journal) =
        Journal::open(&path, scatter.key(), &base.header(), &indices, args.rows.earlier()).map_err(asked)?
    {
        let rest = &indices[journal.done()..];
        let ended = study::run(&scatter, rest, args.many.threads(), Bars::Without, &count, |row| {
            let line = base.columns.line(&scatter, &row);
            journal.add(&line.into_iter().chain(base.grids.cells(&row)).collect::<Vec<_>>())
        });
        ended.with_context(|| format!("cannot write {}", journal.part().display()))?;
        if !all_there(&journal, indices.len()) {
            return Ok(Code::Done);
        }
        journal.finish().with_context(|| format!("cannot write {}", path.display()))?;
    }
    if shard != Shard::WHOLE {
        let merge =
            "`stampflow merge` puts the shards together, and `stampflow scatter ... --resume` says what they say";
        return say(wrapped(&format!("{} runs in {}; {merge}", indices.len(), path.display())));
    }
    let found = Found::of(&scatter, &base, &Sample::read(&path, &base.columns).map_err(asked)?);
    let name = args.file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let written = written(args, &dir, &found, &base, &name)?;
    match args.many.json.json {
        true => {
            let mut value = json::scatter(&scatter, &found);
            value["file"] = path.display().to_string().into();
            value["written"] = written.into();
            say_json(&value)
        }
        false => say(shown(&scatter, &found, &name) + wrapped(&format!("\n{}", written.join(", ")))),
    }
}

/// Writes tables and pictures; returns what they are called.
fn written(args: &Args, dir: &Path, found: &Found, base: &Base, name: &str) -> anyhow::Result<Vec<String>> {
    let pictures = args.many.pictures.pictures();
    let charts = scatter_pictures(found, &base.grids, name);
    let drawn = charts.iter().flat_map(|(stem, chart)| pictures.files(stem, chart));
    let tables = scatter_tables(found).into_iter().map(|(name, bytes)| (name.to_owned(), bytes));
    let written = write_all(dir, tables.chain(drawn))?;
    Ok(std::iter::once(dir.join("scatter.csv")).chain(written).map(|path| path.display().to_string()).collect())
}

impl Args {
    fn scatter(&self) -> Result<Scatter, StudyError> {
        let (case, mut base, asked) = file::load(&self.file)?;
        base.extend(self.many.overrides.all());
        let more =
            self.vary.iter().map(|text| Factor::split(text).map(|(key, scatter)| (key.to_owned(), scatter.to_owned())));
        let vary = asked.vary.into_iter().map(Ok).chain(more).collect::<Result<_, _>>()?;
        let pairs = self.correlate.iter().map(|text| Correlation::read(text));
        let correlations = asked.correlations.into_iter().map(Ok).chain(pairs).collect::<Result<_, _>>()?;
        let (points, seed) = (self.runs.unwrap_or(asked.points), self.seed.unwrap_or(asked.seed));
        Scatter::new(Subject::new(case, base)?, Asked { vary, correlations, points, seed, indices: self.indices })
    }
}

impl Args {
    /// What runs the same study, without its folder.
    fn command(&self) -> String {
        let all = [("--vary", &self.vary), ("--correlate", &self.correlate), ("--set", &self.many.overrides.all())];
        let numbers = [("--runs", self.runs), ("--seed", self.seed.map(u64::from))];
        let numbers = numbers.into_iter().filter_map(|(name, number)| Some(format!(" {name} {}", number?)));
        let options: String = all.into_iter().map(|(name, values)| options(name, values)).chain(numbers).collect();
        let indices = if self.indices { " --indices" } else { "" };
        format!("scatter {}{options}{indices}", quoted(&self.file.to_string_lossy()))
    }
}

/// What is said: the answer, what it rests on, lights and numbers.
fn shown(scatter: &Scatter, found: &Found, name: &str) -> Shown {
    let told = |items: Vec<String>| {
        items
            .iter()
            .map(|item| wrapped(&format!("- {}", item.to_string())))
            .fold(Shown::default(), |all, one| all + one)
    };
    let answer = wrapped(&format!("{name}: {}.\n", found.sentence().to_string()));
    let declared = told(scatter.told.clone());
    let declared = if scatter.told.is_empty() { declared } else { Shown::from("\n") + declared };
    answer + told(found.sentences()) + declared + Shown::from("\n") + lights(found) + Shown::from("\n") + numbers(found)
}

fn range(estimate: Estimate) -> String {
    let [low, high] = [estimate.low, estimate.high].map(|share| Amount::share(share).to_string());
    format!("{low} to {high}")
}

fn lights(found: &Found) -> Shown {
    let headers =
        ["Light", "Row", "Share of parts", "Interval of 95 %", "What decides"].map(|header| String::from(header));
    let row = |event: &Event| {
        let decides = event.influence.told(found).filter(|_| event.hits > 0).unwrap_or_default();
        [
            Cell { text: String::from(event.light.name()), tone: Tone::of(event.light) },
            Cell::plain(String::from(event.label)),
            Cell::plain(Amount::share(event.chance.value).to_string()),
            Cell::plain(range(event.chance)),
            Cell::plain(decides.to_string()),
        ]
    };
    table(Some(headers.each_ref().map(String::as_str)), found.events.iter().map(row).collect())
}

fn numbers(found: &Found) -> Shown {
    let headers = ["Number", "5 %", "Median", "95 %", "What decides"].map(|header| String::from(header));
    let (mut rows, mut same) = (Vec::new(), Vec::new());
    for spread in &found.numbers {
        let told = |value| spread.number.amount(value).to_string();
        let Some([low, median, high]) = spread.quantiles().map(|quantiles| quantiles.map(told)) else { continue };
        let label = String::from(spread.number.label);
        if low == high {
            same.push(format!("{number} {low}", number = spread.number.label));
            continue;
        }
        // Of what scatters itself there is nothing to be found out.
        let is_given = found.factors.iter().any(|factor| Some(factor.as_str()) == spread.number.row);
        let decides = spread.influence.of_number(found).filter(|_| !is_given).unwrap_or_default();
        rows.push([label, low, median, high, decides.to_string()].map(Cell::plain));
    }
    let table = table(Some(headers.each_ref().map(String::as_str)), rows);
    match same.is_empty() {
        true => table,
        false => {
            let same = format!("The same in all parts: {numbers}.", numbers = joined(same, ", "));
            table + Shown::from("\n") + wrapped(&(same.to_string() + "\n"))
        }
    }
}
