//! What is wrong with a study before anything of it is run.

use crate::case::CaseError;

/// What is wrong with a study, and what to try.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// Of how it was asked for.
    #[error("{what}\n  help: {help}")]
    Asked {
        /// What is wrong.
        what: String,
        /// What to write.
        help: String,
    },
    /// Of the case that it varies.
    #[error(transparent)]
    Case(#[from] CaseError),
}

impl StudyError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Asked { what: what.into(), help: help.into() }
    }
}
