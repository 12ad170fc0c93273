//! The estimate that every run can afford: from one coarser run.

use super::direction::Direction;
use super::estimate::Estimate;
use super::outcome::Outcome;
use super::said;
use super::verify::{Verification, Watch, solved, tolerance};
use crate::case::Solution;

/// Of everything that is refined, so many times as fine \[–\]: half.
const COARSER: f64 = 0.5;

/// Error over the difference to the coarser run \[–\]: with the first order it would be 1.
const FACTOR: f64 = 3.0;

/// The bars of a solved case from one run that is coarser in every direction, which takes a fraction of its time: what is
/// shown by default. [`verify`](super::verify()) knows more.
pub fn quick(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let jobs: &[_] = if base.end.lost { &[] } else { &[(Direction::Together, COARSER)] };
    let coarser = solved(&solution.case, jobs, watch);
    if watch.wants_to_stop() {
        return Verification::without(base, &said::interrupted());
    }
    Verification::of(base, coarser, tolerance(&solution.case), |_, levels| Estimate {
        error: FACTOR * levels.get(1).map_or(0.0, |coarser| (coarser - levels[0]).abs()),
        order: None,
        extrapolated: false,
    })
}
