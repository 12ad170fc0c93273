//! TOML's and serde's complaints in a die designer's words.

use super::CaseError;
#[cfg(feature = "schema")]
use super::schema::example_line;
use super::source::Source;
use crate::units::{self, QuantityError, closest};
use miette::NamedSource;
use std::sync::Arc;
use toml::de::Error;

/// Examples are those of the schema.
#[cfg(not(feature = "schema"))]
fn example_line(_: &str) -> Option<String> {
    None
}

/// A text that is not TOML.
pub(super) fn syntax(error: &Error, text: &str, source: Arc<NamedSource<String>>) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let start = text.get(..span.start).and_then(|before| before.rfind('\n')).map_or(0, |i| i + 1);
    let line = text.get(start..).and_then(|rest| rest.lines().next()).unwrap_or("");
    let help = number(line, span.start.saturating_sub(start))
        .unwrap_or_else(|| "case files are TOML: [table] headers and key = value lines".into());
    let what = error.message().lines().collect::<Vec<_>>().join("; ");
    if what == "duplicate key" {
        let key = text.get(span.clone()).unwrap_or("a key").trim();
        return CaseError::at(source, span, format!("`{key}` is written twice"), "again".into(), "keep one".into());
    }
    CaseError::at(source, span, format!("this is not TOML: {what}"), "here".into(), help)
}

/// How the number that stands around byte `at` of a line is written: with a point between digits, and in quotes when a
/// unit follows.
fn number(line: &str, at: usize) -> Option<String> {
    let before = line.get(..at).filter(|before| before.contains('=')).unwrap_or(line);
    let equals = before.rfind('=')?;
    let key = line[..equals].trim_end().rsplit(['{', ',', ' ']).next()?;
    let value = line[equals + 1..].split(['#', '}', ']']).next()?.split(", ").next()?.trim().trim_end_matches(',');
    let unsigned = value.trim_start_matches(['+', '-']);
    if !unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.') || value.contains('"') {
        return None;
    }
    let (rule, value) = match units::parse(value) {
        Err(QuantityError::DecimalComma { point, .. }) => (Some("the decimal sign is a point"), point),
        _ if unsigned.starts_with('.') || unsigned.ends_with('.') => {
            (Some("a decimal point has digits on both sides"), value.to_owned())
        }
        _ => (None, value.to_owned()),
    };
    match value.parse::<f64>() {
        Err(_) => Some(format!("a number with a unit is text: write {key} = \"{value}\"")),
        Ok(number) => rule.map(|rule| format!("{rule}: write {key} = {number}")),
    }
}

/// TOML that is not a case file.
pub(super) fn content(error: &Error, source: &Source) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let path = source.path_at(&span).unwrap_or_default();
    let message = error.message();
    let mut words = message.split('`').skip(1).step_by(2);
    let subject = words.next().unwrap_or("");
    let known: Vec<&str> = words.collect();
    let (table, key) = path.rsplit_once('.').unwrap_or(("", &path));
    let (what, help) = if message.starts_with("unknown field") {
        (format!("unknown key `{subject}` in {}", shown(table)), proposal(subject, &known, "keys"))
    } else if message.starts_with("missing field") {
        return missing(source, &path, subject);
    } else if message.starts_with("unknown variant") {
        (format!("`{key}` cannot be \"{subject}\""), proposal(subject, &known, "values"))
    } else {
        let (what, help) = message.split_once('\n').unwrap_or((message, ""));
        let key = if path.is_empty() { "case".into() } else { last_name(&path) };
        let joint = if what.starts_with("must ") { "" } else { ":" };
        let help = match example_line(&path) {
            Some(line) if help.is_empty() || help.starts_with("write for example") => {
                format!("write for example {line}")
            }
            _ => help.to_owned(),
        };
        (format!("`{key}`{joint} {}", plain(what)), help)
    };
    let label = if path.is_empty() { "here".into() } else { path.clone() };
    source.error_at(span, what, label, help)
}

/// A key that is not there, shown at its table with a line that could be added.
pub(super) fn missing(source: &Source, table: &str, key: &str) -> CaseError {
    let path = if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
    let help = match example_line(&path) {
        Some(line) => format!("add a line such as {line}"),
        None => format!("add it: [{path}]"),
    };
    source.error(table, format!("`{key}` is missing in {}", shown(table)), help)
}

fn shown(table: &str) -> String {
    if table.is_empty() { "the case".into() } else { format!("[{table}]") }
}

/// The key at the end of a path, with the index behind it if it is an entry of an array.
fn last_name(path: &str) -> String {
    let names: Vec<&str> = path.split('.').collect();
    let from = names.iter().rposition(|name| name.parse::<usize>().is_err()).unwrap_or(0);
    names[from..].join(".")
}

fn proposal(word: &str, known: &[&str], kind: &str) -> String {
    let all = format!("known {kind}: {}", known.join(", "));
    match closest(word, known.iter().copied()).first() {
        Some(near) => format!("did you mean `{near}`? {all}"),
        None => all,
    }
}

/// Names of Rust's types said in words.
fn plain(message: &str) -> String {
    let Some((found, wanted)) = message.rsplit_once(", expected ") else { return message.to_owned() };
    let wanted = match wanted {
        "i64" | "usize" => "a whole number",
        "a string" => "text in quotes",
        "a boolean" => "true or false",
        "a sequence" => "a list in square brackets",
        "an array of length 2" | "a tuple of size 2" => "a list of two",
        w if w.starts_with("struct ") || w == "a map" => "a table of keys",
        w if w.starts_with("enum ") || w.ends_with("enum") => "a word in quotes",
        other => other,
    };
    let found = found.strip_prefix("invalid type: ").or(found.strip_prefix("invalid value: ")).unwrap_or(found);
    let found = found.replace("invalid length 0", "an empty list").replace("invalid length 1", "a list of one");
    let found = found.replace("floating point", "number").replace("integer", "number").replace("sequence", "list");
    let found = found.replace("string", "text").replace("map", "table");
    format!("found {found}, wanted {wanted}")
}
