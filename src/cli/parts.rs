//! The lines that run a study in parts, on a cluster or on this machine.

use std::fmt::Write;
use std::path::Path;

/// The options of every verb that prints them.
#[derive(Debug, clap::Args)]
pub struct Parts {
    /// With --print: how many parts
    #[arg(long, value_name = "N", requires = "print", value_parser = clap::value_parser!(u32).range(1..))]
    shards: Option<u32>,
    /// Print the lines that run all parts: on HyperQueue, as a Slurm job array, or on this machine
    #[arg(long, value_name = "hq|slurm|xargs", requires = "shards")]
    print: Option<Scheduler>,
}

/// What runs shards.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Scheduler {
    Hq,
    Slurm,
    Xargs,
}

impl Parts {
    /// What to paste, where that is asked for: parts of a verb with its arguments, their tables put together into
    /// `dir/NAME.csv`.
    pub fn lines(&self, verb: &str, name: &str, dir: &Path) -> Option<String> {
        let (scheduler, shards) = self.print.zip(self.shards)?;
        let folder = quoted(&dir.to_string_lossy());
        let command = format!("stampflow {verb} --out {folder} --quiet --resume --threads 1");
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
        Some(format!("{run}\nstampflow merge {folder}/{name}-*-of-{shards}.csv --out {folder}/{name}.csv\n"))
    }
}

/// ` NAME VALUE` for each value.
pub fn options(name: &str, values: &[String]) -> String {
    values.iter().fold(String::new(), |mut all, value| {
        let _ = write!(all, " {name} {}", quoted(value));
        all
    })
}

/// For a shell.
pub fn quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,".contains(c);
    if text.chars().all(is_plain) && !text.is_empty() {
        text.into()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}
