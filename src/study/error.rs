//! Errors of a study, found before anything is run.

use crate::case::CaseError;

/// A study that cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The request or a file of the study is wrong.
    #[error("{what}\n  help: {help}")]
    Request {
        /// Mistake.
        what: String,
        /// Remedy.
        help: String,
    },
    /// The case that it varies is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
}

impl StudyError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Request { what: what.into(), help: help.into() }
    }
}
