//! Errors of case files: key, place and remedy.

use crate::case::files::{remedy, visible};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use std::io::{self, ErrorKind};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// Longest quote in a message \[characters\].
const LONGEST: usize = 300;
/// Longest line of a file that is drawn \[bytes\].
const LONGEST_LINE: usize = 250;

/// A case that cannot be solved as it is written.
#[derive(Clone, Debug, thiserror::Error, Diagnostic)]
#[error("{what}")]
pub struct CaseError {
    what: String,
    label: String,
    #[help]
    help: Option<String>,
    #[source_code]
    source_code: Arc<NamedSource<String>>,
    #[label("{label}")]
    span: Option<SourceSpan>,
}

impl CaseError {
    pub(crate) fn at(
        source: Arc<NamedSource<String>>,
        span: Range<usize>,
        what: String,
        label: String,
        help: String,
    ) -> Self {
        // A place that spans lines is shown by its first.
        let first_line = source.inner().get(span.clone()).and_then(|text| text.find('\n'));
        let span = span.start..first_line.map_or(span.end, |length| span.start + length);
        let help = (!help.is_empty()).then(|| shortened(&help));
        Self { what: shortened(&what), label: shortened(&label), help, source_code: source, span: Some(span.into()) }
    }

    /// An error outside of any file's text.
    pub(crate) fn bare(what: String, help: String) -> Self {
        let source_code = Arc::new(NamedSource::new("", String::new()));
        Self { what, label: String::new(), help: (!help.is_empty()).then_some(help), source_code, span: None }
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
        let error = Self {
            what: shown(&self.what),
            label: shown(&self.label),
            help: self.help.as_deref().map(shown),
            source_code: Arc::new(NamedSource::new(shown(self.source_code.name()), shown(text))),
            span,
        };
        let theme = if colours { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(theme).with_width(100).with_links(false);
        handler.render_report(&mut text, &error).expect("writing to a string does not fail");
        text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
    }
}

fn shortened(text: &str) -> String {
    let length = text.chars().count();
    if length <= 2 * LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain(" … ".chars()).chain(text.chars().skip(length - LONGEST / 3)).collect()
}
