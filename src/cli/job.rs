//! Cases from their files, and errors of one of several.

use super::bug::caught;
use super::code::{Code, complain};
use stampflow::case::{self, Case};
use stampflow::results::comparison::{Computed, comparisons};
use std::path::{Path, PathBuf};

/// Reads a case and the curves that it will be compared with: bad input is found before solving.
pub fn load(path: &Path, overrides: &[String]) -> anyhow::Result<Case> {
    caught(&format!("reading {}", path.display()), || {
        let case = case::load(path, overrides)?;
        comparisons(&case, &Computed::nothing(case.model()))?;
        Ok(case)
    })
}

/// Results of all, without those that are errors, which are appended to `failed`.
pub fn sound<T>(all: impl IntoIterator<Item = anyhow::Result<T>>, failed: &mut Vec<anyhow::Error>) -> Vec<T> {
    all.into_iter().filter_map(|one| one.map_err(|error| failed.push(error)).ok()).collect()
}

/// Reads every case; the errors of the others come second.
pub fn load_all(paths: &[PathBuf], overrides: &[String]) -> (Vec<Case>, Vec<anyhow::Error>) {
    let mut failed = Vec::new();
    (sound(paths.iter().map(|path| load(path, overrides)), &mut failed), failed)
}

/// Prints all errors and returns the exit code of the first, or `code` without any.
pub fn complained(failed: &[anyhow::Error], code: Code) -> Code {
    failed.iter().for_each(complain);
    failed.first().map_or(code, Code::of)
}
