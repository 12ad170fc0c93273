//! `stampflow sweep` and `stampflow merge`.

use super::code::Code;
use super::place;
use super::screen::{print, wrapped};
use super::study::{ShardOptions, StudyOptions, TableOptions, request, run};
use stampflow::results::write;
use stampflow::study::{self, Evaluated, Sweep};
use std::path::{Path, PathBuf};

pub const HELP: &str = "\
Every combination of the values is one run; the last key varies fastest. A value is a \
range, FROM..TO UNIT/N, or a list, A,B,C UNIT; keys joined by & move together. \
`friction` is that of every tool. A study file holds the same: case, set, \
one_at_a_time, [vary] and [[together]]. DIR/study.csv has one row per run, the same \
bytes on any machine.

The picture beside it: over one key curves with error bands, over two or three keys a \
process window, with --one-at-a-time a tornado.

Examples:
  stampflow sweep cup.toml --vary \"tools.die.shoulder=4..10 mm/7\"
  stampflow sweep cup.toml --vary friction=0.04,0.08 --vary \"tools.holder.force=5..30 kN/6\"
  stampflow sweep cup.toml --one-at-a-time --vary friction=0.04,0.12 --vary \
\"tools.die.shoulder=4,8 mm\"
  stampflow sweep study.toml --resume
  stampflow sweep study.toml --shard 7/64 --out shards

Exit codes: 0 done, 2 bad input, 130 interrupted (rows are kept, --resume goes on)";

pub const MERGE_HELP: &str = "\
Give every shard of one study once, in any order. Rows that are missing, there twice, cut or of another study are refused, and \
nothing is written then. The same study with --resume and the folder as --out then writes report and pictures.

Example:
  stampflow merge shards/study-*-of-64.csv --out out/cup-sweep/study.csv";

#[derive(Debug, clap::Args)]
pub struct Args {
    /// A case file, or a study file
    #[arg(value_name = "CASE.toml|STUDY.toml")]
    file: PathBuf,
    /// A key and its values: KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT; as often as needed
    #[arg(long, value_name = "KEY=VALUES")]
    vary: Vec<String>,
    /// Each key by itself at each of its values, instead of every combination
    #[arg(long)]
    one_at_a_time: bool,
    /// Error bars for all numbers, from one coarser run of each design; default over one key
    #[arg(long)]
    error_bars: bool,
    /// No error bars
    #[arg(long, conflicts_with = "error_bars")]
    no_error_bars: bool,
    /// Also write load and thickness of each design, two CSV files in DIR/curves
    #[arg(long, value_name = "curves")]
    keep: Option<Keep>,
    #[command(flatten)]
    rows: TableOptions,
    #[command(flatten)]
    shard: ShardOptions,
    #[command(flatten)]
    options: StudyOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Keep {
    Curves,
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

pub fn sweep(args: &Args) -> anyhow::Result<Code> {
    let set = args.options.overrides.all();
    let mut sweep = Sweep::load(&args.file, set, &args.vary, args.one_at_a_time).map_err(request)?;
    let errors = args.error_bars || sweep.has_error_bars() && !args.no_error_bars;
    let dir = args.options.folder(&args.file, "sweep").join("curves");
    let mut each = |evaluated: &Evaluated| if args.keep.is_some() { curves(&dir, evaluated) } else { Ok(()) };
    let options = (&args.options, &args.rows, Some(&args.shard));
    run(&mut sweep, (&args.file, "sweep", "study"), options, errors, &mut each)
}

fn curves(dir: &Path, Evaluated { run, outcome }: &Evaluated) -> anyhow::Result<()> {
    let curves = outcome.iter().flat_map(|outcome| {
        [("load", "travel_mm,punch_force_N", &outcome.load), ("thickness", "s0_mm,thickness_mm", &outcome.thickness)]
    });
    for (name, header, points) in curves {
        let lines: String = points.iter().map(|(x, y)| format!("{x},{y}\n")).collect();
        write(&dir.join(format!("{name}-{}.csv", run.index)), format!("{header}\n{lines}").as_bytes())?;
    }
    Ok(())
}

pub fn merge(args: &MergeArgs) -> anyhow::Result<Code> {
    place::file(&args.out, &args.shards, "--out")?;
    place::replaced(&args.out, b"study,designs,index,", "--out")?;
    let (text, designs) = study::merge(&args.shards).map_err(request)?;
    write(&args.out, text.as_bytes())?;
    print(wrapped(&format!("{designs} designs of {} shards in {}", args.shards.len(), args.out.display())))
}
