//! Errors of a study, found before anything is run.

use crate::case::{CaseError, files};
use crate::units::shortened;
use std::{io, path::Path};

pub(super) type Result<T, E = StudyError> = std::result::Result<T, E>;

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
        Self::Request { what: shortened(&what.into()), help: shortened(&help.into()) }
    }

    pub(super) fn unreadable(path: &Path, error: &io::Error, help: &str) -> Self {
        Self::new(format!("cannot read {}: {error}", path.display()), files::remedy(error, help))
    }

    pub(super) fn within(self, place: impl std::fmt::Display) -> Self {
        if let Self::Request { what, help } = self { Self::new(format!("{place}{what}"), help) } else { self }
    }
}

pub(super) fn fail<T>(what: impl Into<String>, help: impl Into<String>) -> Result<T> {
    Err(StudyError::new(what, help))
}

pub(super) fn ensure(holds: bool, what: impl Into<String>, help: impl Into<String>) -> Result<()> {
    if holds { Ok(()) } else { fail(what, help) }
}
