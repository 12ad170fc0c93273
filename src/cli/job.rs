//! Cases on their way from their files to their results. What fails of one stops no other.

use super::bug::caught;
use super::code::Code;
use super::complain;
use super::interrupt;
use super::progress::{Kept, Watch};
use rayon::prelude::*;
use stampflow::case::{self, Case, Solution};
use stampflow::compare::Computed;
use stampflow::results::{ResultFolder, comparisons};
use std::path::{Path, PathBuf};

/// Reads a case, and the curves that it will be compared with, so that bad input is found before solving.
pub fn load(path: &Path, overrides: &[String]) -> anyhow::Result<Case> {
    caught(&format!("reading {}", path.display()), || {
        let case = case::load(path, overrides)?;
        comparisons(&case, &Computed::nothing(case.model()))?;
        Ok(case)
    })
}

/// What has succeeded; what has failed joins `failed`.
fn sound<T>(all: impl Iterator<Item = anyhow::Result<T>>, failed: &mut Vec<anyhow::Error>) -> Vec<T> {
    all.filter_map(|one| one.map_err(|error| failed.push(error)).ok()).collect()
}

/// Reads every case, and keeps what is wrong with the others.
pub fn load_all(paths: &[PathBuf], overrides: &[String]) -> (Vec<Case>, Vec<anyhow::Error>) {
    let mut failed = Vec::new();
    (sound(paths.iter().map(|path| load(path, overrides)), &mut failed), failed)
}

/// Each case with the folder of its results, and in `failed` what is wrong with those that can have none.
pub fn prepared(
    cases: Vec<Case>,
    failed: &mut Vec<anyhow::Error>,
    folder: impl Fn(&Case) -> anyhow::Result<ResultFolder>,
) -> Vec<(Case, ResultFolder)> {
    sound(cases.into_iter().map(|case| folder(&case).map(|folder| (case, folder))), failed)
}

/// Solves cases side by side and hands each with its folder to `then` as it ends; what `then` returns comes back in the
/// cases' order. Once the runs are to end no other case begins.
pub fn solve_all<T: Send>(
    cases: Vec<(Case, ResultFolder)>,
    watch: impl Fn(&Case) -> Watch + Sync,
    then: impl Fn(Solution, Kept, ResultFolder) -> anyhow::Result<T> + Sync,
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

/// Says what is wrong with each case that failed; the code is that of the first, or `code` where none did.
pub fn told(failed: &[anyhow::Error], code: Code) -> Code {
    failed.iter().for_each(complain);
    failed.first().map_or(code, Code::of)
}
