//! The keys of a case, and serde's complaints in a die designer's words.

use super::examples::{example_line, is_index};
use super::reader::Error;
use super::source::Source;
use super::wording::listed;
use super::{CaseError, CaseFile};
use crate::units::did_you_mean;

/// Reads the keys.
pub(super) fn read(source: &Source) -> Result<CaseFile, CaseError> {
    if source.is_empty() {
        let what = if source.text().trim().is_empty() { "the file is empty" } else { "the file holds comments only" };
        let help = "a case needs title, geometry, [blank], a law such as [material.hardening.swift], [tools.punch] and \
                    mostly [tools.die] and [tools.holder]; begin with a copy of cases/quickstart.toml";
        return Err(source.error_at(0..0, what.into(), "here".into(), help.into()));
    }
    source.read().map_err(|error| content(&error, source))
}

/// TOML that is not a case file.
fn content(error: &Error, source: &Source) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let path = source.path_at(&span).unwrap_or_default();
    let message = error.message();
    let mut words = message.split('`').skip(1).step_by(2);
    let subject = words.next().unwrap_or("");
    let known: Vec<&str> = words.collect();
    let (table, key) = path.rsplit_once('.').unwrap_or(("", &path));
    let written = source.written(&path);
    let (what, help) = if message.starts_with("unknown field") && table.is_empty() && source.has("case") {
        let what = format!("this is a study, not a case: `{subject}` is no key of a case");
        (what, "run it with `stampflow sweep`, `scatter` or `fit`, whichever it is written for".to_owned())
    } else if message.starts_with("unknown field") {
        (
            format!("unknown key `{subject}` in {}", shown(table)),
            proposal(subject, &listed(kind_of(table), &known), "keys"),
        )
    } else if message.starts_with("missing field") {
        return missing(source, &path, subject);
    } else if message.starts_with("unknown variant") {
        (format!("`{key}` cannot be \"{subject}\""), proposal(subject, &known, "values"))
    } else {
        let (what, help) = message.split_once('\n').unwrap_or((message, ""));
        let key = if path.is_empty() { "case".into() } else { last_name(&written) };
        let joint = if what.starts_with("must ") { "" } else { ":" };
        let example = example_line(&path).filter(|_| written == path); // of the key that was written
        let help = match example {
            Some(line) if help.is_empty() || help.starts_with("write for example") => {
                format!("write for example {line}")
            }
            _ => help.to_owned(),
        };
        (format!("`{key}`{joint} {}", plain(what)), help)
    };
    let label = if path.is_empty() { "here".into() } else { written };
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

/// The key that says what a table is: entries of arrays are called by their array.
fn kind_of(table: &str) -> &str {
    table.rsplit('.').find(|key| !is_index(key)).unwrap_or("")
}

fn shown(table: &str) -> String {
    if table.is_empty() { "the case".into() } else { format!("[{table}]") }
}

/// The key at the end of a path, with the index behind it if it is an entry of an array.
fn last_name(path: &str) -> String {
    let names: Vec<&str> = path.split('.').collect();
    let from = names.iter().rposition(|name| !is_index(name)).unwrap_or(0);
    names[from..].join(".")
}

fn proposal(word: &str, known: &[&str], kind: &str) -> String {
    format!("{}known {kind}: {}", did_you_mean(word, known.iter().copied()), known.join(", "))
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
        "newtype variant" => "a table with its parameters behind it",
        w if w.starts_with("struct ") || w == "a map" => "a table of keys",
        w if w.starts_with("enum ") || w.ends_with("enum") => "a word in quotes",
        other => other,
    };
    let found = found.strip_prefix("invalid type: ").or(found.strip_prefix("invalid value: ")).unwrap_or(found);
    let found = found.replace("invalid length 0", "an empty list").replace("invalid length 1", "a list of one");
    let found = found.replace("floating point", "number").replace("integer", "number").replace("sequence", "list");
    let found = found.replace("unit variant", "a name alone");
    let found = found.replace("string", "text").replace("map", "table");
    format!("found {found}, wanted {wanted}")
}
