//! Errors of case files with key, place and remedy; complaints of the TOML parser and of serde in plain words.

use super::{files::remedy, files::visible, schema::example, schema::is_index, source::path_at, *};
use crate::units::{self, QuantityError, did_you_mean, shortened};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use std::{io::ErrorKind, ops::Range, sync::Arc};
use toml::de::Error;

/// Longest line of a file that is drawn \[bytes\].
const LONGEST_LINE: usize = 250;

type SourceCode = Arc<NamedSource<String>>;

/// A case that cannot be solved as it is written.
#[derive(Clone, Debug, thiserror::Error, Diagnostic)]
#[error("{what}")]
pub struct CaseError {
    what: String,
    label: String,
    #[help]
    help: Option<String>,
    #[source_code]
    source_code: SourceCode,
    #[label("{label}")]
    span: Option<SourceSpan>,
    /// True if the case is sound, and a run that it needs stopped early: that of a bead's strip.
    pub is_stopped_run: bool,
}

impl CaseError {
    pub(crate) fn at(source: SourceCode, span: Range<usize>, what: String, label: String, help: String) -> Self {
        // A place that spans lines is shown by its first.
        let first_line = source.inner().get(span.clone()).and_then(|text| text.find('\n'));
        let span = span.start..first_line.map_or(span.end, |length| span.start + length);
        let error = Self::bare(shortened(&what), shortened(&help));
        Self { label: shortened(&label), source_code: source, span: Some(span.into()), ..error }
    }

    pub(crate) fn bare(what: String, help: String) -> Self {
        let source_code = Arc::new(NamedSource::new("", String::new()));
        let help = (!help.is_empty()).then_some(help);
        Self { what, label: String::new(), help, source_code, span: None, is_stopped_run: false }
    }

    pub(super) fn unreadable(path: &Path, error: &io::Error) -> Self {
        let path = path.display();
        let what = match error.kind() {
            ErrorKind::NotFound => format!("there is no file {path}"),
            ErrorKind::InvalidData => format!("{path} is not UTF-8 text"),
            ErrorKind::IsADirectory => format!("{path} is a folder"),
            ErrorKind::FileTooLarge => format!("{path} is no case file: {error}"),
            _ => format!("{path} cannot be read: {error}"),
        };
        Self::bare(what, remedy(error, "give the path of a case file, such as cases/quickstart.toml"))
    }

    /// Remedy.
    pub fn remedy(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// The file as it was named, with a word on overrides; `None` of an error outside of any file's text.
    pub fn file(&self) -> Option<&str> {
        Some(self.source_code.name()).filter(|name| !name.is_empty())
    }

    /// Line and column of the place, from 1, where there is one.
    pub fn position(&self) -> Option<(usize, usize)> {
        let before = self.source_code.inner().get(..self.span?.offset())?;
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        Some((before.matches('\n').count() + 1, before[line_start..].chars().count() + 1))
    }

    /// The key that is wrong, `tools.punch.travel`; "here" where there is none, empty outside of any file's text.
    pub fn key(&self) -> &str {
        &self.label
    }

    /// The line of the place.
    pub fn line(&self) -> Option<&str> {
        let (line, _) = self.position()?;
        self.source_code.inner().lines().nth(line - 1)
    }

    /// The whole message with the line and a caret, 100 columns wide; control characters are [`visible`].
    pub fn render(&self, colours: bool) -> String {
        let text = self.source_code.inner();
        // The neighbours of a line are drawn with it, but no column beyond 65 535.
        let around = |line: usize| text.lines().skip(line.saturating_sub(2)).take(3);
        let is_long = |(line, _): &(usize, usize)| around(*line).any(|text| text.len() > LONGEST_LINE);
        if let Some((line, column)) = self.position().filter(is_long) {
            let what = format!("{}: {} (line {line}, column {column})", self.source_code.name(), self.what);
            return Self { what, span: None, ..self.clone() }.render(colours);
        }
        // An end of a line is left whole: before its second character stands none.
        let moved = |at: usize| text.get(..at).map_or(at, |before| visible(before.trim_end_matches('\r')).len());
        let span = self.span.map(|span| {
            let (start, end) = (moved(span.offset()), moved(span.offset() + span.len()));
            (start..end.max(start)).into()
        });
        let shown = |text: &str| visible(text).into_owned();
        let (what, label, help) = (shown(&self.what), shown(&self.label), self.help.as_deref().map(shown));
        let source_code = Arc::new(NamedSource::new(shown(self.source_code.name()), shown(text)));
        let error = Self { what, label, help, source_code, span, ..self.clone() };
        let theme = if colours { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(theme).with_width(100).with_links(false);
        handler.render_report(&mut text, &error).expect("writing to a string does not fail");
        text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
    }
}

pub(super) fn not_toml(error: &Error, text: &str, shown: SourceCode) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let what = error.message().lines().collect::<Vec<_>>().join("; ");
    if what == "duplicate key" {
        let key = text.get(span.clone()).unwrap_or("a key").trim();
        return CaseError::at(shown, span, format!("`{key}` is written twice"), "again".into(), "keep one".into());
    }
    let start = text.get(..span.start).and_then(|before| before.rfind('\n')).map_or(0, |i| i + 1);
    let line = text.get(start..).and_then(|rest| rest.lines().next()).unwrap_or("");
    let help = unquoted_number(line, span.start.saturating_sub(start))
        .or_else(|| unquoted_text(line))
        .unwrap_or_else(|| "case files are TOML: [table] headers and key = value lines".into());
    CaseError::at(shown, span, format!("this is not TOML: {what}"), "here".into(), help)
}

fn unquoted_text(line: &str) -> Option<String> {
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.split('#').next()?.trim());
    let is_text = value.starts_with(char::is_alphabetic) && !value.contains(['"', '\'', '{', '[']);
    let is_key = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.'));
    (is_text && is_key).then(|| format!("text stands in quotes: write {key} = \"{value}\""))
}

/// Remedy for the number around byte `at` of a line: a decimal point between digits, quotes around a unit.
fn unquoted_number(line: &str, at: usize) -> Option<String> {
    let equals = line.get(..at).filter(|before| before.contains('=')).unwrap_or(line).rfind('=')?;
    let key = line[..equals].trim_end().rsplit(['{', ',', ' ']).next()?;
    let value = line[equals + 1..].split(['#', '}', ']']).next()?.split(", ").next()?.trim().trim_end_matches(',');
    let unsigned = value.trim_start_matches(['+', '-']);
    if !unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.') || value.contains('"') {
        return None;
    }
    let (rule, value) = match units::parse(value) {
        Err(QuantityError { with_point: Some(point), .. }) => (Some("the decimal sign is a point"), point),
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

pub(super) fn wrong_key(error: &Error, source: &Source) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let path = path_at(&source.root, &span).unwrap_or_default();
    let message = error.message();
    let mut quoted = message.split('`').skip(1).step_by(2);
    let subject = quoted.next().unwrap_or("");
    let known: Vec<&str> = quoted.collect();
    let (table, key) = path.rsplit_once('.').unwrap_or(("", &path));
    let (what, help) = if message.starts_with("unknown field") && table.is_empty() && source.has("case") {
        let what = format!("this is a study, not a case: `{subject}` is no key of a case");
        (what, "run it with `stampflow sweep`, `scatter` or `fit`, whichever it is written for".to_owned())
    } else if message.starts_with("unknown field") {
        let table = if table.is_empty() { "the case".into() } else { format!("[{table}]") };
        (format!("unknown key `{subject}` in {table}"), proposal(subject, &known, "keys"))
    } else if message.starts_with("missing field") {
        return source.missing(&path, subject);
    } else if message.starts_with("unknown variant") {
        (format!("`{key}` cannot be \"{subject}\""), proposal(subject, &known, "values"))
    } else {
        let (what, help) = message.split_once('\n').unwrap_or((message, ""));
        let joint = if what.starts_with("must ") { "" } else { ":" };
        let example = example(&path).filter(|_| help.is_empty() || help.starts_with("write for example"));
        let help = example.map_or_else(|| help.to_owned(), |line| format!("write for example {line}"));
        let text = what.starts_with("invalid type: string").then(|| what.split('"').nth(1)).flatten();
        let point = text.and_then(|text| units::parse(text).err()?.with_point);
        let help = point.map_or(help, |point| format!("write {point}: the decimal sign is a point"));
        (format!("`{}`{joint} {}", last_name(&path), in_plain_words(what)), help)
    };
    source.error_at(span, what, if path.is_empty() { "here".into() } else { path }, help)
}

fn last_name(path: &str) -> &str {
    let key = path.rmatch_indices('.').find(|(at, _)| !path[at + 1..].split('.').all(is_index));
    if path.is_empty() { "case" } else { key.map_or(path, |(at, _)| &path[at + 1..]) }
}

fn proposal(word: &str, known: &[&str], kind: &str) -> String {
    format!("{}known {kind}: {}", did_you_mean(word, known.iter().copied()), known.join(", "))
}

/// Serde's "invalid type" message without names of Rust types.
fn in_plain_words(message: &str) -> String {
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
    const PLAIN: [(&str, &str); 10] = [
        ("invalid type: ", ""),
        ("invalid value: ", ""),
        ("invalid length 0", "an empty list"),
        ("invalid length 1", "a list of one"),
        ("floating point", "number"),
        ("integer", "number"),
        ("sequence", "list"),
        ("unit variant", "a name alone"),
        ("string", "text"),
        ("map", "table"),
    ];
    let found = PLAIN.iter().fold(found.to_owned(), |found, (rust, plain)| found.replace(rust, plain));
    format!("found {found}, wanted {wanted}")
}
