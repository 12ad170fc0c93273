//! What is wrong with a case file, where, and what to write instead.

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

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
    pub(super) fn at(
        source: Arc<NamedSource<String>>,
        span: Range<usize>,
        what: String,
        label: String,
        help: String,
    ) -> Self {
        let help = (!help.is_empty()).then_some(help);
        Self { what, label, help, source_code: source, span: Some(span.into()) }
    }

    /// An error outside of any file's text.
    pub(super) fn bare(what: String, help: String) -> Self {
        let source_code = Arc::new(NamedSource::new("", String::new()));
        Self { what, label: String::new(), help: (!help.is_empty()).then_some(help), source_code, span: None }
    }

    pub(super) fn unreadable(path: &Path, error: &std::io::Error) -> Self {
        let what = match error.kind() {
            std::io::ErrorKind::NotFound => format!("there is no file {}", path.display()),
            std::io::ErrorKind::InvalidData => format!("{} is not UTF-8 text", path.display()),
            _ => format!("{} cannot be read: {error}", path.display()),
        };
        Self::bare(what, "give the path of a case file, such as cases/quickstart.toml".into())
    }

    /// What to do about it.
    pub fn remedy(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// Line and column of the place, from 1, where there is one.
    pub fn position(&self) -> Option<(usize, usize)> {
        let before = self.source_code.inner().get(..self.span?.offset())?;
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        Some((before.matches('\n').count() + 1, before[line_start..].chars().count() + 1))
    }

    /// The whole message with the line and a caret, 100 columns wide; without colours the same everywhere.
    pub fn render(&self, colours: bool) -> String {
        let theme = if colours { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let mut text = String::new();
        let handler = GraphicalReportHandler::new_themed(theme).with_width(100).with_links(false);
        handler.render_report(&mut text, self).expect("writing to a string does not fail");
        text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
    }
}
