//! The verbs of the command line, each a short table of contents in its own file.

mod answer;
mod bug;
mod check;
mod code;
mod compare;
mod error_bars;
mod fit;
mod import;
mod interrupt;
mod job;
mod json;
mod many;
mod materials;
mod message;
mod new;
mod options;
mod parts;
mod place;
mod progress;
mod report;
mod rows;
mod run;
mod say;
mod scatter;
mod search;
mod shell;
mod studied;
mod suggested;
mod sweep;
mod table;
mod titles;
mod trace;
mod validate;
mod verify;

pub use code::Code;
pub use message::complain;

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use code::BadRequest;
use options::Json;
use say::say;
use stampflow::case::files::visible;
use stampflow::units::DisplaySettings;
use stampflow::{author, case};
use std::borrow::Cow;

/// Sheet-metal stamping sections (axisymmetric or plane strain) by the flow approach.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, max_term_width = 80, after_help = code::HELP)]
pub struct Args {
    /// Units of texts: si (mm, kN, MPa) or us (in, US tonf, ksi); files for programs stay in si
    #[arg(long, global = true, value_name = "SYSTEM", default_value = "si", value_parser = options::units)]
    units: DisplaySettings,
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Solve cases and write their tables and plots
    #[command(after_help = run::help())]
    Run(run::Args),
    /// Read a case and say what it means; with --run solve it and give a verdict
    #[command(after_help = check::HELP)]
    Check(check::Args),
    /// Solve a case and write a report for people: HTML, Markdown or PDF
    #[command(after_help = report::HELP)]
    Report(report::Args),
    /// Write a case file to begin with, from a few sizes
    New(new::Args),
    /// Read the tools from a drawing (DXF) and write a case file with them
    #[command(after_help = import::HELP)]
    Import(import::Args),
    /// Solve every case that has published curves and compare
    #[command(after_help = validate::HELP)]
    Validate(validate::Args),
    /// Take one step of the solver apart: predictor, iterations, how fast they converge
    #[command(after_help = trace::HELP)]
    Trace(trace::Args),
    /// Refine mesh, steps, points and contact, and say how far every number can be trusted
    #[command(after_help = verify::HELP)]
    Verify(verify::Args),
    /// Solve cases and variants side by side: one picture, one table of differences, measured curves beside them
    #[command(after_help = compare::HELP)]
    Compare(compare::Args),
    /// Run a case with many settings: ranges and lists of any keys, one row a run
    #[command(after_help = sweep::HELP)]
    Sweep(sweep::Args),
    /// Find where a condition ends, or where a number has a wanted value; the best of several keys
    #[command(after_help = search::HELP)]
    Search(search::Args),
    /// Run a case with what scatters: how sure the verdict is, and what decides
    #[command(after_help = scatter::HELP)]
    Scatter(scatter::Args),
    /// Put the tables of a study's shards together
    #[command(hide = true, after_help = sweep::MERGE_HELP)]
    Merge(sweep::MergeArgs),
    /// Fit a hardening law to tension tests, or keys of a case to measured curves
    #[command(after_help = fit::HELP)]
    Fit(fit::Args),
    /// List the built-in materials, or say all of one
    #[command(after_help = materials::HELP)]
    Materials(materials::Args),
    /// Print the JSON schema of case files, for completion in editors, or their reference for people
    #[command(
        hide = true,
        after_help = "Examples:\n  stampflow schema > case.schema.json\n  stampflow schema --markdown > case.md\n\nThen \
                            begin a case file with the line\n  #:schema ./case.schema.json"
    )]
    Schema {
        /// Every table and key with meaning, unit, limits and an example, as Markdown
        #[arg(long)]
        markdown: bool,
    },
    /// Print the completions of a shell
    #[command(hide = true, after_help = shell::COMPLETIONS_HELP)]
    Completions { shell: Shell },
    /// Print the manual page of the program or of a verb
    #[command(hide = true, after_help = shell::MAN_HELP)]
    Man { verb: Option<String> },
}

/// Reads the command line and does what it asks for; a panic is an error.
pub fn main() -> anyhow::Result<Code> {
    bug::listen();
    bug::caught("the program", command)
}

fn command() -> anyhow::Result<Code> {
    let args = match Args::try_parse() {
        Err(error) if error.use_stderr() && (Json::is_asked_for() || would_be_obeyed()) => {
            return Err(BadRequest(error.to_string().trim_start_matches("error: ").trim_end().to_owned()).into());
        }
        parsed => parsed.unwrap_or_else(|error| error.exit()),
    };
    interrupt::listen()?;
    args.units.set();
    let code = match args.verb {
        Verb::Run(args) => run::run(&args),
        Verb::Report(args) => report::report(&args),
        Verb::Import(args) => import::import(&args),
        Verb::Validate(args) => validate::validate(&args),
        Verb::Trace(args) => trace::trace(&args),
        Verb::Verify(args) => verify::verify(&args),
        Verb::Compare(args) => compare::compare(&args),
        Verb::Sweep(args) => sweep::sweep(&args),
        Verb::Search(args) => search::search(&args),
        Verb::Scatter(args) => scatter::scatter(&args),
        Verb::Merge(args) => sweep::merge(&args),
        Verb::Fit(args) => fit::fit(&args),
        Verb::Check(args) => check::check(&args),
        Verb::New(args) => new::new(&args),
        Verb::Materials(args) => materials::materials(&args),
        Verb::Schema { markdown: true } => say(author::case_reference()),
        Verb::Schema { .. } => say(case::schema()),
        Verb::Completions { shell } => shell::completions(Args::command(), shell),
        Verb::Man { verb } => shell::man(Args::command(), verb.as_deref()),
    }?;
    Ok(match code {
        Code::Done | Code::StoppedEarly if interrupt::is_wanted() => Code::Interrupted,
        code => code,
    })
}

/// Whether the command line, which its errors quote, holds what a terminal would obey.
fn would_be_obeyed() -> bool {
    std::env::args_os().any(|arg| matches!(visible(&arg.to_string_lossy()), Cow::Owned(_)))
}
