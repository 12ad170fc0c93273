//! The verbs of the command line, each a short table of contents in its own file.

mod code;
mod import;
mod job;
mod progress;
mod run;
mod validate;

pub use code::{Code, message};

use clap::{Parser, Subcommand};
use stampflow::case;
use std::io::{self, Write};
use std::path::PathBuf;

/// Sheet-metal stamping sections (axisymmetric or plane strain) by the flow approach.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, after_help = code::HELP)]
pub struct Args {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Solve cases and write their tables and plots
    #[command(after_help = run::help())]
    Run(run::Args),
    /// Read a case and say what it means, without solving it
    #[command(after_help = "Example:\n  stampflow check cases/quickstart.toml --set tools.punch.friction=0.1")]
    Check {
        /// Case file
        case: PathBuf,
        #[command(flatten)]
        overrides: Overrides,
    },
    /// Read the tools from a drawing (DXF) and write a case file with them
    #[command(after_help = import::HELP)]
    Import(import::Args),
    /// Solve every case that has published curves and compare
    #[command(after_help = validate::HELP)]
    Validate(validate::Args),
    /// List the hardening, rate and friction laws with their parameters and sources
    Laws,
    /// Print the JSON schema of case files, for completion in editors
    #[command(
        after_help = "Example:\n  stampflow schema > case.schema.json\n\nThen begin a case file with the line\n  \
                            #:schema ./case.schema.json"
    )]
    Schema,
}

#[derive(Debug, clap::Args)]
struct Overrides {
    /// Replace what the case says: a dotted path of keys and a value with its unit, as often as needed
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

#[derive(Debug, clap::Args)]
struct Threads {
    /// Threads for cases that run side by side [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

impl Threads {
    /// Makes it so, once and before anything runs.
    fn apply(&self) -> anyhow::Result<()> {
        if let Some(threads) = self.threads {
            rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global()?;
        }
        Ok(())
    }
}

/// Does what was asked for.
pub fn main(args: Args) -> anyhow::Result<Code> {
    match args.verb {
        Verb::Run(args) => run::run(&args),
        Verb::Import(args) => import::import(&args),
        Verb::Validate(args) => validate::validate(&args),
        Verb::Check { case, overrides } => {
            let case = case::load(&case, &overrides.set)?;
            say(&case::check::report(&case).to_string())
        }
        Verb::Laws => say(&case::laws()),
        Verb::Schema => say(&case::schema()),
    }
}

/// Prints whole lines, the last one ended if need be; a reader that has gone away (`| head`) is no error.
fn say(text: &str) -> anyhow::Result<Code> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(io::stdout().lock(), "{text}{end}") {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Code::Done),
    }
}
