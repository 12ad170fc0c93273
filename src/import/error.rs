//! Errors of a drawing: what, where, and what you can do.

/// Reason why no section can be read from a drawing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\n  {help}")]
pub struct ImportError {
    /// The error, with the entities and the place.
    pub what: String,
    /// Remedy.
    pub help: String,
    /// Line of the file, from 1, of the first named entity.
    pub line: Option<usize>,
}

impl ImportError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), line: None }
    }

    pub(super) fn at(self, line: usize) -> Self {
        Self { line: Some(line), ..self }
    }
}
