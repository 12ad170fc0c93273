//! Cases on their way from their files to their results.

use super::interrupt;
use super::progress::{Kept, Watch};
use rayon::prelude::*;
use stampflow::case::{self, Case, Solution};
use stampflow::compare::Computed;
use stampflow::output::{ResultFolder, comparisons};
use std::path::Path;

/// Reads a case, and the curves that it will be compared with, so that bad input is found before solving.
pub fn load(path: &Path, overrides: &[String]) -> anyhow::Result<Case> {
    let case = case::load(path, overrides)?;
    comparisons(&case, &Computed::nothing(case.model()))?;
    Ok(case)
}

/// Solves cases side by side and hands each with its folder to `then` as it ends; what `then` returns comes back in the cases' order. Once
/// the runs are to end no other case begins.
pub fn solve_all<T: Send>(
    cases: Vec<(Case, ResultFolder)>,
    watch: impl Fn(&Case) -> Watch + Sync,
    then: impl Fn(Solution, Kept, ResultFolder) -> anyhow::Result<T> + Sync,
) -> Vec<anyhow::Result<T>> {
    let solved = cases.into_par_iter().filter(|_| !interrupt::is_wanted()).map(|(case, folder)| {
        let watch = watch(&case);
        let (solution, kept) = watch.solve(case);
        then(solution, kept, folder)
    });
    solved.collect()
}
