//! What is wrong with a drawing, where, and what to do about it.

/// A drawing that no tool's section can be read from.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\n  {help}")]
pub struct ImportError {
    /// What is wrong, with the entities and the place.
    pub what: String,
    /// What to do about it.
    pub help: String,
}

impl ImportError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into() }
    }
}
