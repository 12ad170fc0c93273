//! Where the numbers of a case come from, as it says itself.

use super::file::CaseFile;
use super::{CaseError, source::Source};

/// Where the numbers of a case come from: how they were measured, or author and year. `None` where the case does not say;
/// the run does not depend on it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sources {
    /// Of the friction of all tools.
    pub friction: Option<String>,
    /// Of the material, by its name in the library where the case names one.
    pub material: Option<String>,
}

/// A number that an override has replaced is no longer its source's.
pub(super) fn forget_replaced(file: &mut CaseFile, overrides: &[String]) {
    let keys = || overrides.iter().filter_map(|written| written.split_once('=')).map(|(path, _)| path.trim());
    let replaced = |source: &str, is_of: fn(&str) -> bool| keys().any(is_of) && !keys().any(|path| path == source);
    if replaced("friction.source", |path| path.split('.').any(|key| key == "friction")) {
        file.friction.source = None;
    }
    if replaced("material.source", |path| path.split('.').next() == Some("material")) {
        file.material.source = None;
    }
}

/// What the file says, a named material completed.
///
/// # Errors
/// When a source is written and says nothing.
pub(super) fn of(file: &CaseFile, source: &Source) -> Result<Sources, CaseError> {
    let said = |given: &Option<String>, path: &str| match given {
        Some(text) if text.trim().is_empty() => {
            let help = "write how it was measured, or author and year; leave it out where the numbers are assumed";
            Err(source.error(path, "`source` says nothing", help))
        }
        given => Ok(given.clone()),
    };
    Ok(Sources {
        friction: said(&file.friction.source, "friction.source")?,
        material: said(&file.material.source, "material.source")?,
    })
}
