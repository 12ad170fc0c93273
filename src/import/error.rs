//! What is wrong with a drawing, where, and what to do about it.

/// A drawing that no tool's section can be read from.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\n  {help}")]
pub struct ImportError {
    /// What is wrong, with the entities and the place.
    pub what: String,
    /// What to do about it.
    pub help: String,
    /// Line of the file, from 1, of the first entity that is named.
    pub line: Option<usize>,
}

impl ImportError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), line: None }
    }

    /// The same error, at a line of the file.
    pub(super) fn at(self, line: usize) -> Self {
        Self { line: Some(line), ..self }
    }
}
