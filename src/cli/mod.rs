//! Command line: one file for each verb, and what they share.

/// Options of verbs as tables: field, type, name of the value, `#[arg]` settings, help; then shared options.
macro_rules! options {
    ($($(#[$meta:meta])* $name:ident {
        $($field:ident: $type:ty $(= $value:literal)? [$($arg:tt)*] $help:literal,)*
    } $($shared:ident: $options:ty),*;)+) => {$(
        #[derive(Debug, clap::Args)]
        $(#[$meta])*
        pub struct $name {
            $(#[arg($(value_name = $value,)? help = $help, $($arg)*)] pub $field: $type,)*
            $(#[command(flatten)] pub $shared: $options,)*
        }
    )+};
}

mod check;
mod compare;
mod error;
mod export;
mod fit;
mod import;
mod materials;
mod new;
mod options;
mod place;
mod progress;
mod report;
mod run;
mod screen;
mod solved;
mod study;
mod trace;
mod verify;

use crate::bug::{self, caught};
use anyhow::{Context, Result, ensure};
use clap::{ArgAction, CommandFactory, FromArgMatches, Parser, Subcommand};
use error::{Code, bad_path, bad_request, complained, is_interrupted, sound, unusable};
use options::{Common, Json, Overrides, PictureOptions, Threads, length, one_of};
use progress::Progress;
use rayon::prelude::*;
use screen::{Cell, ScreenText, emit, list, print, print_json, rows, table, warn, with, wrapped};
use serde_json::{Map, Value, json};
use solved::{Output, Solved, finish};
use stampflow::assess::error_bars::{Contribution, ErrorBars, Number, Origin};
use stampflow::assess::{
    self, Answer, Finding, Kind, Light, by_advice, headline, is_done, judgements, sentences, size_doubts, unchecked,
};
use stampflow::case::{self, Case, CaseError, Solution, library};
use stampflow::files::{Disk, Files, visible};
use stampflow::import::{DrawingUnit, ImportError};
use stampflow::model::{Geometry, Model, Role};
use stampflow::plot::{Extra, FrameRecorder, png};
use stampflow::report::{self as page, Report};
use stampflow::results::{CaseSummary, OUTPUTS, ResultFolder, Results, WriteError, comparison::CompareError, tables};
use stampflow::results::{can_write, comparison_folder, csv, is_report, is_result, result_folder, write};
use stampflow::solver::solution::{IterationRecord, StepRecord};
use stampflow::study::{StudyError, compare::SideBySide, judge, measured_curve, study_folder};
use stampflow::units::{Amount, Dimensioned, DisplaySettings, Length, Positive, QuantityError, parse, rounded};
use std::io::{IsTerminal, stdin};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{borrow::Cow, process::ExitCode};
use study::StudyOptions;

const HELP: &str = include_str!("help.txt");

fn help(section: &str) -> &'static str {
    HELP.split("# ").find_map(|part| part.strip_prefix(section)?.strip_prefix('\n')).unwrap_or_default().trim_end()
}

/// Verbs of a die's design, in the order of use; the list of verbs begins with them.
const DESIGN: [&str; 7] = ["new", "import", "check", "run", "report", "export", "materials"];
const TEMPLATE: &str = "{about}\n\n{usage-heading} {usage}\n{after-help}\n\nOptions:\n{options}";

/// Deep drawing, stretching and bending of sheet metal: the section of a round part or a strip.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, disable_help_flag = true, max_term_width = 80, help_template = TEMPLATE)]
pub struct Args {
    /// Units of texts: si, or us (in, US tonf, ksi); files stay in si
    #[arg(long, global = true, display_order = 900, value_name = "SYSTEM", default_value = "si", ignore_case = true,
          hide_default_value = true, hide_possible_values = true, value_parser = one_of(options::UNITS))]
    units: DisplaySettings,
    /// Folder of the shop's own sheets, one TOML each [default: that of STAMPFLOW_SHEETS]
    #[arg(long, global = true, display_order = 900, value_name = "DIR")]
    sheets: Option<PathBuf>,
    /// Print what is used most, with examples
    #[arg(short, long, global = true, display_order = 900, action = ArgAction::HelpShort)]
    help: (),
    /// Print every option and what it is for
    #[arg(long, global = true, display_order = 900, action = ArgAction::HelpLong)]
    help_all: (),
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    /// Write a case file from a few sizes
    New,
    Import(import::Args),
    Check(check::Args),
    Run(run::Args),
    Report(report::Args),
    Export(export::Args),
    Sweep(study::SweepArgs),
    Search(study::SearchArgs),
    Scatter(study::ScatterArgs),
    Fit(fit::Args),
    Compare(compare::Args),
    Verify(verify::Args),
    Trace(trace::Args),
    Materials(materials::Args),
    #[command(hide = true)]
    Merge(study::MergeArgs),
    /// Print the JSON schema of case files, for completion in editors
    #[command(hide = true)]
    Schema,
    #[command(about = "Print the completions of a shell", hide = true)]
    Completions {
        shell: clap_complete::Shell,
    },
    #[command(about = "Print the manual page of the program or of a verb", hide = true)]
    Man {
        verb: Option<String>,
    },
}

pub fn main(words: &[std::ffi::OsString]) -> ExitCode {
    bug::listen();
    let code = caught("the program", || command(words)).unwrap_or_else(|error| complained(&[error], Code::Done));
    ExitCode::from(code as u8)
}

fn program() -> clap::Command {
    let examples = |text: &'static str| text.find("Example").map_or("", |at| &text[at..]);
    let files: String = OUTPUTS.iter().map(|output| format!("  {:<18} {}\n", output.file, output.about)).collect();
    let with_help = |verb: clap::Command| match (verb.get_name(), help(verb.get_name())) {
        ("run", text) => verb.after_help(examples(text)).after_long_help(format!("Written files:\n{files}\n{text}")),
        (_, text) => verb.after_help(examples(text)).after_long_help(text),
    };
    let program = Args::command().mut_subcommands(with_help).mut_subcommand("new", new::command);
    let list = verbs(&program);
    program.after_help(list.clone() + "\n" + examples(help("program"))).after_long_help(list + "\n" + help("program"))
}

fn verbs(program: &clap::Command) -> String {
    let design = DESIGN.iter().filter_map(|name| program.find_subcommand(name));
    let rest = program.get_subcommands().filter(|verb| !verb.is_hide_set() && !DESIGN.contains(&verb.get_name()));
    let line = |verb: &clap::Command| format!("  {:<10} {}\n", verb.get_name(), verb.get_about().unwrap_or_default());
    let [design, rest]: [String; 2] = [design.map(line).collect(), rest.map(line).collect()];
    format!("Design:\n{design}\nStudies, tests and accuracy:\n{rest}")
}

fn command(words: &[std::ffi::OsString]) -> Result<Code> {
    let matches = program().try_get_matches_from(words).or_else(|error| {
        // The message quotes the command line, whose control characters are printed as codes.
        let has_codes = std::env::args_os().any(|arg| matches!(visible(&arg.to_string_lossy()), Cow::Owned(_)));
        if error.use_stderr() && (Json::is_requested() || has_codes) {
            return Err(bad_request(error.to_string().trim_start_matches("error: ").trim_end()));
        }
        error.exit()
    })?;
    let args = Args::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    error::listen()?;
    args.units.set();
    args.sheets.iter().try_for_each(|folder| library::use_folder(folder))?;
    let code = match args.verb {
        Verb::New => new::new(matches.subcommand_matches("new").expect("the verb")),
        Verb::Import(args) => import::import(args),
        Verb::Check(args) => check::check(&args),
        Verb::Run(args) => run::run(&args),
        Verb::Report(args) => report::report(&args),
        Verb::Export(args) => export::export(&args),
        Verb::Sweep(args) => study::sweep(&args),
        Verb::Search(args) => study::search(args),
        Verb::Scatter(args) => study::scatter(&args),
        Verb::Fit(args) => fit::fit(&args),
        Verb::Compare(args) => compare::compare(&args),
        Verb::Verify(args) => verify::verify(&args),
        Verb::Trace(args) => trace::trace(args),
        Verb::Materials(args) => materials::materials(&args),
        Verb::Merge(args) => study::merge(&args),
        Verb::Schema => print(case::schema()),
        Verb::Completions { shell } => {
            let mut bytes = Vec::new();
            clap_complete::generate(shell, &mut program(), "stampflow", &mut bytes);
            print(String::from_utf8(bytes)?)
        }
        Verb::Man { verb } => man(verb.as_deref()),
    }?;
    Ok(if matches!(code, Code::Done | Code::StoppedEarly) && is_interrupted() { Code::Interrupted } else { code })
}

fn man(verb: Option<&str>) -> Result<Code> {
    let mut command = program();
    // Gives the verbs their names and global options.
    command.build();
    let found = verb.map_or(Some(&command), |verb| command.find_subcommand(verb)).cloned();
    let unknown = || bad_request(format!("there is no verb `{}`: see stampflow --help", verb.unwrap_or_default()));
    let mut bytes = Vec::new();
    clap_mangen::Man::new(found.ok_or_else(unknown)?).render(&mut bytes)?;
    print(String::from_utf8(bytes)?)
}
