//! Verdict for the user of one case: findings, what hangs on friction and hardening, and advice that was tried.

use super::{advice::advise, *};
use crate::assess::{Answer, Finding, after, error_bars::ErrorBars, error_bars::weighed, sensitivity};
use rayon::prelude::*;

/// Judges a solution: less and more friction and less hardening are solved, advice on red and amber rows if it is wanted.
pub fn judge(solution: &Solution, bars: Option<&ErrorBars>, advice: bool, watch: &dyn Watch) -> (Answer, Vec<Finding>) {
    let mut findings = after(&solution.case, &solution.stages);
    if is_known(solution) {
        let solved = |(other, case)| Some((other, BaseCase::solve(case, watch).ok().filter(is_known)?));
        let others = sensitivity::neighbours(&solution.case, &findings).into_par_iter().map(solved);
        if let Some(others) = others.collect::<Option<Vec<_>>>() {
            sensitivity::judge(solution, &others, &mut findings);
        }
    }
    let (answer, mut findings) = weighed(solution, findings, bars);
    if advice {
        advise(solution, bars, &mut findings, watch);
    }
    (answer, findings)
}

pub(super) fn is_known(solution: &Solution) -> bool {
    !FailureMode::all(&solution.stages, &[]).contains(&FailureMode::NoResult)
}
