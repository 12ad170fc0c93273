//! What programs read instead of printed tables: results on the output stream, errors on the error stream.

use super::{Code, say};
use serde::Serialize;
use serde_json::{Map, Value, json};
use stampflow::case::CaseError;
use stampflow::compare::Comparison;
use stampflow::quantity::rounded;

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

/// An error in one line: what is wrong, and of a case file where and what to do.
pub fn error(error: &anyhow::Error) -> String {
    let case = error.downcast_ref::<CaseError>();
    let (line, column) = case.and_then(CaseError::position).unzip();
    let value = json!({
        "error": format!("{error:#}"),
        "help": case.and_then(CaseError::remedy),
        "file": case.and_then(CaseError::file),
        "line": line,
        "column": column,
    });
    format!("{value}\n")
}
