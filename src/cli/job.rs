//! Cases from their files to their results; the failure of one stops no other.

use super::bug::caught;
use super::code::{Code, complain};
use super::interrupt;
use super::progress::{Records, Watch};
use rayon::prelude::*;
use stampflow::case::{self, Case, Solution};
use stampflow::results::ResultFolder;
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

/// Successes; failures are appended to `failed`.
fn sound<T>(all: impl Iterator<Item = anyhow::Result<T>>, failed: &mut Vec<anyhow::Error>) -> Vec<T> {
    all.filter_map(|one| one.map_err(|error| failed.push(error)).ok()).collect()
}

/// Reads every case; the errors of the others come second.
pub fn load_all(paths: &[PathBuf], overrides: &[String]) -> (Vec<Case>, Vec<anyhow::Error>) {
    let mut failed = Vec::new();
    (sound(paths.iter().map(|path| load(path, overrides)), &mut failed), failed)
}

/// Opens the folder of each case; errors are appended to `failed`.
pub fn prepared(
    cases: Vec<Case>,
    failed: &mut Vec<anyhow::Error>,
    folder: impl Fn(&Case) -> anyhow::Result<ResultFolder>,
) -> Vec<(Case, ResultFolder)> {
    sound(cases.into_iter().map(|case| folder(&case).map(|folder| (case, folder))), failed)
}

/// Solves cases side by side, calls `then` as each ends, and returns its results in the cases' order. After an
/// interrupt no other case begins.
pub fn solve_all<T: Send>(
    cases: Vec<(Case, ResultFolder)>,
    watch: impl Fn(&Case) -> Watch + Sync,
    then: impl Fn(Solution, Records, ResultFolder) -> anyhow::Result<T> + Sync,
) -> Vec<anyhow::Result<T>> {
    let solved = cases.into_par_iter().filter(|_| !interrupt::is_wanted()).map(|(case, folder)| {
        caught(&format!("case {}", case.name), || {
            let watch = watch(&case);
            let (solution, kept) = watch.solve(case);
            then(solution, kept, folder)
        })
    });
    solved.collect()
}

/// Prints all errors and returns the exit code of the first, or `code` without any.
pub fn complained(failed: &[anyhow::Error], code: Code) -> Code {
    failed.iter().for_each(complain);
    failed.first().map_or(code, Code::of)
}
