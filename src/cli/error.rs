//! Exit codes, the errors that end the program, and its signals.

use super::*;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use stampflow::case::CaseError;
use stampflow::import::ImportError;
use stampflow::results::{WriteError, comparison::CompareError};
use stampflow::study::StudyError;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

/// Exit code of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Code {
    #[default]
    Done = 0,
    Failed = 1,
    BadInput = 2,
    StoppedEarly = 3,
    Red = 4,
    Interrupted = 130,
}

/// A request that makes no sense, or a named file or folder that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{what}{}{help}", if .help.is_empty() { "" } else { "; " })]
struct BadInput {
    what: String,
    help: String,
    path: Option<PathBuf>,
}

/// Error of a request, whatever the files say.
pub fn bad_request(what: impl Into<String>) -> anyhow::Error {
    BadInput { what: what.into(), help: String::new(), path: None }.into()
}

/// Error of a file or folder, named before `what`, with a remedy.
pub fn bad_path(path: &Path, what: impl std::fmt::Display, help: impl Into<String>) -> anyhow::Error {
    BadInput { what: format!("{} {what}", path.display()), help: help.into(), path: Some(path.to_owned()) }.into()
}

/// Error of a place that cannot be written to, found before anything is solved.
pub fn unusable(option: &str) -> impl Fn(WriteError) -> anyhow::Error {
    move |error| {
        let (what, help) = (format!("{error}: {}", error.source), format!("choose another place with {option}"));
        BadInput { what, help, path: Some(error.path) }.into()
    }
}

impl Code {
    /// Exit code of an error.
    pub fn of(error: &anyhow::Error) -> Self {
        let of_files = error.is::<CaseError>() || error.is::<CompareError>() || error.is::<ImportError>();
        if of_files || error.is::<StudyError>() || error.is::<BadInput>() { Self::BadInput } else { Self::Failed }
    }
}

/// Results of all, without those that are errors, which are appended to `failed`.
pub fn sound<T>(all: impl IntoIterator<Item = Result<T>>, failed: &mut Vec<anyhow::Error>) -> Vec<T> {
    all.into_iter().filter_map(|one| one.map_err(|error| failed.push(error)).ok()).collect()
}

/// Prints all errors; returns the exit code of the first, or `code` without any.
pub fn complained(failed: &[anyhow::Error], code: Code) -> Code {
    failed.iter().for_each(complain);
    failed.first().map_or(code, Code::of)
}

/// Prints an error with its cause, that of a case with its line and a caret; as JSON with `--json`.
fn complain(error: &anyhow::Error) {
    warn(match of_case(error) {
        _ if Json::is_requested() => as_json(error).to_string().into(),
        Some(case) => ScreenText::coloured(case.render(screen::has_colours(&std::io::stderr()))),
        None => ScreenText::from(format!("error: {error:#}")),
    });
}

fn of_case(error: &anyhow::Error) -> Option<&CaseError> {
    match error.downcast_ref() {
        Some(StudyError::Case(error)) => Some(error),
        _ => error.downcast_ref(),
    }
}

/// Text, remedy, file, line and column of an error as far as they are known.
fn as_json(error: &anyhow::Error) -> Value {
    let (mut what, mut help, mut file, mut line, mut column) = (format!("{error:#}"), None, None, None, None);
    if let Some(case) = of_case(error) {
        (what, help, file) = (case.to_string(), case.remedy(), case.file().map(str::to_owned));
        (line, column) = case.position().unzip();
    } else if let Some(drawing) = error.downcast_ref::<ImportError>() {
        // The drawing's path is the context.
        (what, help, file, line) =
            (drawing.what.clone(), Some(drawing.help.as_str()), Some(error.to_string()), drawing.line);
    } else if let Some(BadInput { what: bad, help: remedy, path: Some(path) }) = error.downcast_ref() {
        (what, help, file) = (bad.clone(), Some(remedy.as_str()), Some(path.display().to_string()));
    }
    json!({ "error": what, "help": help, "file": file, "line": line, "column": column })
}

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Installs the handlers of Ctrl-C and SIGTERM: the first ends the runs, the second the program.
pub fn listen() -> std::io::Result<()> {
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds the flag down and raises it, the second finds it up.
        flag::register_conditional_shutdown(signal, Code::Interrupted as i32, Arc::clone(&INTERRUPTED))?;
        flag::register(signal, Arc::clone(&INTERRUPTED))?;
    }
    // A file that grows beyond the limit of the process is an error like a full disk.
    #[cfg(unix)]
    flag::register(signal_hook::consts::SIGXFSZ, Arc::default())?;
    Ok(())
}

pub fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
