//! Exit codes, and the errors that end the program.

use super::options::Json;
use super::screen::{ScreenText, has_colours, warn};
use serde_json::json;
use stampflow::assess::{Answer, Light};
use stampflow::case::CaseError;
use stampflow::import::ImportError;
use stampflow::results::WriteError;
use stampflow::results::comparison::CompareError;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Exit code of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Code {
    Done = 0,
    Failed = 1,
    BadInput = 2,
    StoppedEarly = 3,
    Red = 4,
    Interrupted = 130,
}

/// A request that makes no sense, whatever the files say.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct BadRequest(pub String);

/// A named file or folder that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{what}; {help}")]
pub struct BadPath {
    pub what: String,
    pub help: String,
    pub path: PathBuf,
}

/// Error of a place that cannot be written to, found before anything is solved.
pub fn unusable(option: &str) -> impl Fn(WriteError) -> BadPath {
    move |error| {
        let cause = error.source().map_or(String::new(), |cause| format!(": {cause}"));
        let (what, help) = (format!("{error}{cause}"), format!("choose another place with {option}"));
        BadPath { what, help, path: error.path }
    }
}

impl Code {
    /// Exit code of a run: red only with `--strict`, whether complete or not.
    pub fn of_run(strict: bool, complete: bool, answer: &Answer) -> Self {
        match answer.light {
            Light::Red if strict => Self::Red,
            _ if complete => Self::Done,
            _ => Self::StoppedEarly,
        }
    }

    /// Exit code of an error.
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

/// Prints an error with its cause, that of a case with its line and a caret; as JSON with `--json`.
pub fn complain(error: &anyhow::Error) {
    warn(if Json::is_requested() {
        as_json(error).into()
    } else if let Some(case) = error.downcast_ref::<CaseError>() {
        ScreenText::coloured(case.render(has_colours(&std::io::stderr())))
    } else {
        ScreenText::from(format!("error: {error:#}"))
    });
}

/// An error in one line: text, remedy, file, line and column as far as they are known.
fn as_json(error: &anyhow::Error) -> String {
    // An error of a drawing, or of the case made from it, has the drawing's path as context.
    let drawing = || (error.chain().len() > 1).then(|| error.to_string());
    let (what, help, file, line, column) = if let Some(case) = error.downcast_ref::<CaseError>() {
        let (line, column) = case.position().unzip();
        let file = case.file().map(str::to_owned).or_else(drawing);
        (case.to_string(), case.remedy().map(str::to_owned), file, line, column)
    } else if let Some(ImportError { what, help, line }) = error.downcast_ref() {
        (what.clone(), Some(help.clone()), drawing(), *line, None)
    } else if let Some(BadPath { what, help, path }) = error.downcast_ref() {
        (what.clone(), Some(help.clone()), Some(path.display().to_string()), None, None)
    } else {
        (format!("{error:#}"), None, None, None, None)
    };
    json!({ "error": what, "help": help, "file": file, "line": line, "column": column }).to_string()
}
