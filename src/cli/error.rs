//! Exit codes, the errors that end the program, and its signals.

use super::*;
use std::{sync::Arc, sync::LazyLock, sync::atomic::AtomicBool, sync::atomic::Ordering};

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

pub fn bad_request(what: impl Into<String>) -> anyhow::Error {
    BadInput { what: what.into(), help: String::new(), path: None }.into()
}

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
    pub fn of(error: &anyhow::Error) -> Self {
        if of_case(error).is_some_and(|error| error.is_stopped_run) {
            return Self::StoppedEarly;
        }
        let of_files = error.is::<CaseError>() || error.is::<CompareError>() || error.is::<ImportError>();
        if of_files || error.is::<StudyError>() || error.is::<BadInput>() { Self::BadInput } else { Self::Failed }
    }
}

/// Results of all, without those that are errors, which are appended to `failed`.
pub fn sound<T>(all: impl IntoIterator<Item = Result<T>>, failed: &mut Vec<anyhow::Error>) -> Vec<T> {
    all.into_iter().filter_map(|one| one.map_err(|error| failed.push(error)).ok()).collect()
}

pub fn complained(failed: &[anyhow::Error], code: Code) -> Code {
    failed.iter().for_each(complain);
    failed.first().map_or(code, Code::of)
}

fn complain(error: &anyhow::Error) {
    warn(match of_case(error) {
        _ if Json::is_requested() => as_json(error).to_string().into(),
        Some(case) => ScreenText(case.render(screen::has_colours(&std::io::stderr()))),
        None => ScreenText::from(format!("error: {error:#}")),
    });
}

fn of_case(error: &anyhow::Error) -> Option<&CaseError> {
    if let Some(StudyError::Case(error)) = error.downcast_ref() { Some(error) } else { error.downcast_ref() }
}

fn as_json(error: &anyhow::Error) -> Value {
    if let Some(case) = of_case(error) {
        let (line, column) = case.position().unzip();
        json!({ "error": case.to_string(), "help": case.remedy(), "file": case.file(), "line": line, "column": column })
    } else if let Some(ImportError { what, help, line, .. }) = error.downcast_ref() {
        // The drawing's path is the context.
        json!({ "error": what, "help": help, "file": error.to_string(), "line": line, "column": null })
    } else if let Some(BadInput { what, help, path: Some(path) }) = error.downcast_ref() {
        json!({ "error": what, "help": help, "file": path.display().to_string(), "line": null, "column": null })
    } else {
        json!({ "error": format!("{error:#}"), "help": null, "file": null, "line": null, "column": null })
    }
}

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Installs the handlers of Ctrl-C and SIGTERM: the first ends the runs, the second the program; SIGHUP the runs only.
pub fn listen() -> Result<()> {
    #[cfg(windows)]
    ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(Code::Interrupted as i32)
        }
    })?;
    #[cfg(unix)]
    {
        use signal_hook::{consts::*, flag};
        for signal in [SIGINT, SIGTERM] {
            // In this order: the first signal finds the flag down and raises it, the second finds it up.
            flag::register_conditional_shutdown(signal, Code::Interrupted as i32, Arc::clone(&INTERRUPTED))?;
            flag::register(signal, Arc::clone(&INTERRUPTED))?;
        }
        // A file that grows beyond the limit of the process is an error like a full disk.
        flag::register(SIGXFSZ, Arc::default())?;
        flag::register(SIGHUP, if is_ignored(SIGHUP) { Arc::default() } else { Arc::clone(&INTERRUPTED) })?;
    }
    Ok(())
}

/// Whether the parent, such as nohup, has a signal ignored; where the system does not list it, assumed without a terminal.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    ignored.map_or_else(|| !std::io::stderr().is_terminal(), |signals| signals >> (signal - 1) & 1 == 1)
}

pub fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
