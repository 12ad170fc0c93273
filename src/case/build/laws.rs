//! Laws made ready for use, and what is wrong with them shown where they were written.

use crate::case::{CaseError, source::Source};
use crate::material::law::{Family, LawError, Named};

/// The one law of a table that must name exactly one, ready for use.
pub(super) fn only<F: Family>(named: Named<F>, path: &str, source: &Source) -> Result<F, CaseError> {
    match named.only() {
        Ok(law) => prepared(law, None, path, source),
        Err(given) => Err(not_one(given.len(), path, &F::NAMES.join(", "), source)),
    }
}

/// A law made ready for use.
pub(super) fn prepared<F: Family>(law: F, young: Option<f64>, path: &str, source: &Source) -> Result<F, CaseError> {
    let name = law.name();
    law.prepared(young).map_err(|error| {
        let message = format!("{name}: {}", error.message);
        blame(LawError { message, ..error }, &format!("{path}.{name}"), source)
    })
}

/// What is wrong with a law, shown at its key.
pub(super) fn blame(error: LawError, path: &str, source: &Source) -> CaseError {
    source.error(format!("{path}.{}", error.key).trim_end_matches('.'), error.message, error.help)
}

/// Not one law where there must be exactly one.
pub(super) fn not_one(found: usize, path: &str, names: &str, source: &Source) -> CaseError {
    if found > 0 {
        return source.error(path, format!("[{path}] names more than one law"), "keep one of them");
    }
    source.error(path, format!("[{path}] names no law"), format!("give one of {names}, or drop [{path}]"))
}
