//! Error messages, on the error stream.

use super::code::BadPath;
use super::options::Json;
use super::say::{Shown, warn};
use super::table::colours;
use serde_json::json;
use stampflow::case::CaseError;
use stampflow::import::ImportError;
use std::io;

/// Prints the error with what caused it, a case's error with its line and a caret; or as JSON where that is asked for.
pub fn complain(error: &anyhow::Error) {
    warn(if Json::is_asked_for() {
        json(error).into()
    } else if let Some(case) = error.downcast_ref::<CaseError>() {
        Shown::coloured(case.render(colours(&io::stderr())))
    } else {
        Shown::from(format!("error: {error:#}"))
    });
}

/// An error in one line: what is wrong, where and what to do, as far as that is known.
fn json(error: &anyhow::Error) -> String {
    let value = if let Some(case) = error.downcast_ref::<CaseError>() {
        let (line, column) = case.position().unzip();
        let file = case.file().map(str::to_owned).or_else(|| drawing(error));
        json!({ "error": case.to_string(), "help": case.remedy(), "file": file, "line": line, "column": column })
    } else if let Some(ImportError { what, help, line }) = error.downcast_ref() {
        json!({ "error": what, "help": help, "file": drawing(error), "line": line, "column": null })
    } else if let Some(BadPath { what, help, path }) = error.downcast_ref() {
        json!({ "error": what, "help": help, "file": path, "line": null, "column": null })
    } else {
        json!({ "error": format!("{error:#}"), "help": null, "file": null, "line": null, "column": null })
    };
    value.to_string()
}

/// The context of what is wrong with a drawing, or with the case made from it: its path.
fn drawing(error: &anyhow::Error) -> Option<String> {
    (error.chain().len() > 1).then(|| error.to_string())
}
