//! `stampflow scatter`.

use super::code::Code;
use super::study::{ShardOptions, StudyOptions, TableOptions, request, run};
use stampflow::study::Scatter;
use std::path::PathBuf;

pub const HELP: &str = "\
Each key has a distribution; the runs are a quasi-random sample of them (scrambled \
Sobol points). `friction` is that of every tool, `strength` a factor on all stresses of \
the hardening law. Without --vary friction scatters, and of a library sheet thickness \
and strength by its standard. DIR has the sample (scatter.csv), tables of lights and \
quantiles, and histograms.

A distribution is one of
  uniform LOW..HIGH UNIT            normal MEAN ± DEVIATION UNIT
  uniform ± HALF UNIT               normal ± DEVIATION UNIT in LOW..HIGH UNIT
without a middle about the case's own value; % is of the middle, +- is ±.

Examples:
  stampflow scatter cup.toml
  stampflow scatter cup.toml --vary \"friction=uniform 0.05..0.12\" \\
    --vary \"blank.thickness=normal ± 0.02 mm in ± 0.05 mm\"
  stampflow scatter study.toml --shard 7/64 --out shards
  stampflow merge shards/scatter-*-of-64.csv --out out/study-scatter/scatter.csv
  stampflow scatter study.toml --resume

Exit codes: 0 done, 2 bad input, 130 interrupted (rows are kept, --resume goes on)";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file, or a study file
    #[arg(value_name = "CASE.toml|STUDY.toml")]
    file: PathBuf,
    /// A key and its distribution, as often as needed
    #[arg(long, value_name = "KEY=DISTRIBUTION")]
    vary: Vec<String>,
    /// Sample size; best a power of two [default: 1024]
    #[arg(long, value_name = "N")]
    runs: Option<u64>,
    /// Seed of the sample [default: 1]
    #[arg(long, value_name = "N")]
    seed: Option<u32>,
    #[command(flatten)]
    rows: TableOptions,
    #[command(flatten)]
    shard: ShardOptions,
    #[command(flatten)]
    options: StudyOptions,
}

pub fn scatter(args: &Args) -> anyhow::Result<Code> {
    let set = args.options.overrides.all();
    let mut scatter = Scatter::load(&args.file, set, &args.vary, args.runs, args.seed).map_err(request)?;
    let options = (&args.options, &args.rows, Some(&args.shard));
    run(&mut scatter, (&args.file, "scatter", "scatter"), options, false, &mut |_| Ok(()))
}
