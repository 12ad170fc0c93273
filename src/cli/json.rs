//! What programs read instead of printed tables: results on the output stream, errors on the error stream.

use super::code::BadPath;
use super::{Code, say};
use serde::Serialize;
use serde_json::{Map, Value, json};
use stampflow::case::CaseError;
use stampflow::compare::Comparison;
use stampflow::import::ImportError;
use stampflow::units::rounded;

/// The option of every verb that has a result.
#[derive(Debug, clap::Args)]
pub struct Json {
    /// Print JSON for programs instead, and errors as JSON too; shows no progress
    #[arg(long)]
    pub json: bool,
}

/// Whether the command line asks for JSON, be the rest of it right or wrong.
pub fn is_asked_for() -> bool {
    std::env::args_os().any(|arg| arg == "--json")
}

/// Prints a value, indented.
pub fn say_json(value: &impl Serialize) -> anyhow::Result<Code> {
    say(&serde_json::to_string_pretty(value)?)
}

/// A comparison with all its numbers; what was not reached is null.
pub fn comparison(case: &str, comparison: &Comparison) -> Value {
    let table = comparison.table();
    let numbers = table.columns.iter().map(|column| {
        let values = column.values.iter().map(|value| json!(rounded(*value))).collect();
        (column.header(), Value::Array(values))
    });
    json!({
        "case": case,
        "quantity": comparison.spec.against.name(),
        "reference": comparison.spec.reference,
        "source": comparison.source,
        "worst": comparison.worst(),
        "accepted": comparison.accepted(),
        "verdict": comparison.outcome(),
        "failure": comparison.is_failure(),
        "reason": comparison.spec.reason,
        "values": numbers.collect::<Map<_, _>>(),
    })
}

/// An error in one line: what is wrong, where and what to do, as far as that is known.
pub fn error(error: &anyhow::Error) -> String {
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
    format!("{value}\n")
}

/// The context of what is wrong with a drawing, or with the case made from it: its path.
fn drawing(error: &anyhow::Error) -> Option<String> {
    (error.chain().len() > 1).then(|| error.to_string())
}
