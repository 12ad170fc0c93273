//! TOML's complaints in a die designer's words.

use super::CaseError;
use crate::units::{self, QuantityError};
use miette::NamedSource;
use std::sync::Arc;
use toml::de::Error;

/// A text that is not TOML.
pub(super) fn error(error: &Error, text: &str, source: Arc<NamedSource<String>>) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let start = text.get(..span.start).and_then(|before| before.rfind('\n')).map_or(0, |i| i + 1);
    let line = text.get(start..).and_then(|rest| rest.lines().next()).unwrap_or("");
    let help = number(line, span.start.saturating_sub(start))
        .or_else(|| word(line))
        .unwrap_or_else(|| "case files are TOML: [table] headers and key = value lines".into());
    let what = error.message().lines().collect::<Vec<_>>().join("; ");
    if what == "duplicate key" {
        let key = text.get(span.clone()).unwrap_or("a key").trim();
        return CaseError::at(source, span, format!("`{key}` is written twice"), "again".into(), "keep one".into());
    }
    CaseError::at(source, span, format!("this is not TOML: {what}"), "here".into(), help)
}

/// How a text is written: in quotes.
fn word(line: &str) -> Option<String> {
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.split('#').next()?.trim());
    let is_text = value.starts_with(char::is_alphabetic) && !value.contains(['"', '\'', '{', '[']);
    let is_key = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.'));
    (is_text && is_key).then(|| format!("text stands in quotes: write {key} = \"{value}\""))
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
