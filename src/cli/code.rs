//! Exit codes, and the errors of the command line itself.

use stampflow::assess::{Answer, Light};
use stampflow::case::CaseError;
use stampflow::compare::CompareError;
use stampflow::import::ImportError;
use stampflow::results::WriteError;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Shown below the help of the whole program.
pub const HELP: &str = "\
Examples:
  stampflow check cases/quickstart.toml
  stampflow run cases/quickstart.toml
  stampflow run cases/*.toml --out results
  stampflow validate

Exit codes:
  0    done
  1    any other failure; validate: a comparison is out of its tolerance
  2    bad input, nothing was written
  3    a run stopped before its full travel, its results are kept
  4    with --strict: the verdict is red, the results are kept
  130  interrupted (Ctrl-C): the results up to there are kept; a second Ctrl-C ends at once";

/// What the program's end means to a script.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Code {
    Done = 0,
    Failed = 1,
    BadInput = 2,
    StoppedEarly = 3,
    Red = 4,
    Interrupted = 130,
}

/// What was asked for makes no sense, whatever the files say.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct BadRequest(pub String);

/// A file or folder that was named and cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{what}; {help}")]
pub struct BadPath {
    pub what: String,
    pub help: String,
    pub path: PathBuf,
}

/// A place for results that cannot be written to, found before anything is solved.
pub fn unusable(option: &str) -> impl Fn(WriteError) -> BadPath {
    move |error| {
        let cause = error.source().map_or(String::new(), |cause| format!(": {cause}"));
        let (what, help) = (format!("{error}{cause}"), format!("choose another place with {option}"));
        BadPath { what, help, path: error.path }
    }
}

impl Code {
    /// What a run that came to an end is to a script: red where that is asked for, complete or not.
    pub fn of_run(strict: bool, complete: bool, answer: &Answer) -> Self {
        match answer.light {
            Light::Red if strict => Self::Red,
            _ if complete => Self::Done,
            _ => Self::StoppedEarly,
        }
    }

    /// The code that an error ends the program with.
    pub fn of(error: &anyhow::Error) -> Self {
        let bad_input = error.is::<CaseError>() || error.is::<CompareError>() || error.is::<ImportError>();
        if bad_input || error.is::<BadRequest>() || error.is::<BadPath>() { Self::BadInput } else { Self::Failed }
    }
}

impl From<Code> for ExitCode {
    fn from(code: Code) -> Self {
        Self::from(code as u8)
    }
}
