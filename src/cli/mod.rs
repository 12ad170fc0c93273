//! Command line: one file for each verb, and what they share.

mod answer;
mod bug;
mod check;
mod code;
mod compare;
mod fit;
mod import;
mod interrupt;
mod job;
mod json;
mod materials;
mod new;
mod options;
mod place;
mod progress;
mod report;
mod run;
mod scatter;
mod screen;
mod search;
mod study;
mod sweep;
mod trace;
mod verify;

pub use code::{Code, complain};

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use code::BadRequest;
use options::Json;
use screen::print;
use stampflow::case::files::visible;
use stampflow::units::DisplaySettings;
use stampflow::{author, case};
use std::borrow::Cow;

const HELP: &str = "\
Examples:
  stampflow new cup -o cup.toml
  stampflow check cup.toml
  stampflow run cup.toml

`-h` prints the short help of a verb, `--help` all of it.

Exit codes:
  0    done
  1    any other failure; compare: a comparison is out of its tolerance
  2    bad input, nothing was written
  3    a run stopped before its full travel, its results are kept
  4    with --strict: the verdict is red, the results are kept
  130  interrupted (Ctrl-C): the results up to there are kept; a second Ctrl-C ends at once";

/// Sheet-metal stamping sections (axisymmetric or plane strain) by the flow approach.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, max_term_width = 80, after_help = HELP)]
pub struct Args {
    /// Units of texts: si or us (in, US tonf, ksi); files for programs stay in si
    #[arg(long, global = true, value_name = "SYSTEM", default_value = "si", value_parser = options::units)]
    units: DisplaySettings,
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Write a case file from a few sizes
    New(new::Args),
    /// Read the tools from a drawing (DXF) and write a case file with them
    #[command(after_long_help = import::HELP)]
    Import(import::Args),
    /// Explain a case; with --run solve it and give a verdict
    #[command(after_long_help = check::HELP)]
    Check(check::Args),
    /// Solve cases and write their tables and plots
    #[command(after_long_help = run::help())]
    Run(run::Args),
    /// Solve a case and write a report, one HTML page
    #[command(after_long_help = report::HELP)]
    Report(report::Args),
    /// Run a case with many settings: ranges and lists of any keys, one row a run
    #[command(after_long_help = sweep::HELP)]
    Sweep(sweep::Args),
    /// Find the limit of a condition, or the value at which a quantity is as wanted
    #[command(after_long_help = search::HELP)]
    Search(search::Args),
    /// Run a case with scattering inputs: how sure the verdict is, and what decides
    #[command(after_long_help = scatter::HELP)]
    Scatter(scatter::Args),
    /// Fit a hardening law to tension tests, or keys of a case to measured curves
    #[command(after_long_help = fit::HELP)]
    Fit(fit::Args),
    /// Compare cases, variants and measured curves, or cases with their references
    #[command(after_long_help = compare::HELP)]
    Compare(compare::Args),
    /// Refine mesh, steps, points and contact for an error bar of every number
    #[command(after_long_help = verify::HELP)]
    Verify(verify::Args),
    /// Show one step of the solver, iteration by iteration
    #[command(after_long_help = trace::HELP)]
    Trace(trace::Args),
    /// List the built-in materials, or show one
    #[command(after_long_help = materials::HELP)]
    Materials(materials::Args),
    /// Put the tables of a study's shards together
    #[command(hide = true, after_long_help = sweep::MERGE_HELP)]
    Merge(sweep::MergeArgs),
    /// Print the JSON schema of case files, for completion in editors
    #[command(hide = true, after_help = "Begin a case file with the line `#:schema ./case.schema.json`.")]
    Schema {
        /// Print a reference for people instead, as Markdown
        #[arg(long)]
        markdown: bool,
    },
    /// Print the completions of a shell
    #[command(hide = true)]
    Completions { shell: Shell },
    /// Print the manual page of the program or of a verb
    #[command(hide = true)]
    Man { verb: Option<String> },
}

/// Reads the command line and does what it asks for; a panic is an error.
pub fn main() -> anyhow::Result<Code> {
    bug::listen();
    bug::caught("the program", command)
}

fn command() -> anyhow::Result<Code> {
    let has_control_characters =
        std::env::args_os().any(|arg| matches!(visible(&arg.to_string_lossy()), Cow::Owned(_)));
    let args = match Args::try_parse() {
        // The message quotes the command line, whose control characters are printed as codes.
        Err(error) if error.use_stderr() && (Json::is_requested() || has_control_characters) => {
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
        Verb::Schema { markdown: true } => print(author::case_reference()),
        Verb::Schema { .. } => print(case::schema()),
        Verb::Completions { shell } => {
            let mut bytes = Vec::new();
            clap_complete::generate(shell, &mut Args::command(), "stampflow", &mut bytes);
            print(String::from_utf8(bytes)?)
        }
        Verb::Man { verb } => man(verb.as_deref()),
    }?;
    Ok(match code {
        Code::Done | Code::StoppedEarly if interrupt::is_wanted() => Code::Interrupted,
        code => code,
    })
}

fn man(verb: Option<&str>) -> anyhow::Result<Code> {
    let mut command = Args::command();
    // Gives the verbs their names and global options.
    command.build();
    if let Some(verb) = verb {
        let verbs: Vec<&str> = command.get_subcommands().map(|verb| verb.get_name()).collect();
        let unknown = || BadRequest(format!("there is no verb `{verb}`; there are {}", verbs.join(", ")));
        command = command.find_subcommand(verb).cloned().ok_or_else(unknown)?;
    }
    let mut bytes = Vec::new();
    clap_mangen::Man::new(command).render(&mut bytes)?;
    print(String::from_utf8(bytes)?)
}
