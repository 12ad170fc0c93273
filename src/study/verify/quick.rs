//! The estimate that every run can afford: from one coarser run.

use super::direction::Direction;
use super::estimate::Estimate;
use super::outcome::Outcome;
use super::said;
use super::verification::{Verification, Watch, solved, tolerance};
use crate::case::Solution;
use crate::units::Unit;

/// Refinement factor of the coarser run \[–\].
const COARSER: f64 = 0.5;

/// Error over the difference to the coarser run \[–\]. With the first order it would be 1; but what is coarser in all
/// directions at once has errors that cancel by chance: of 60 random dies, 19 numbers in 20 keep within five times.
const FACTOR: f64 = 5.0;

/// Least bar, because errors may cancel: of the number \[–\], of one in percent \[%\], and of a place in elements or steps,
/// likewise measured.
const LEAST: f64 = 3e-3;
const LEAST_PERCENT: f64 = 1.5;
const LEAST_PLACE: f64 = 3.0;

/// The bars of a solved case from one run that is coarser in every direction, which takes a fraction of its time: what is
/// shown by default. [`verify`](super::verify()) knows more, and it alone has bars for a sheet that tore.
pub fn quick(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let jobs: &[_] = if base.end.complete { &[(Direction::Together, COARSER)] } else { &[] };
    let coarser = solved(&solution.case, jobs, watch);
    if watch.wants_to_stop() {
        return Verification::without(base, &said::interrupted());
    }
    let mut verification = Verification::of(base, coarser, tolerance(&solution.case), |_, levels| Estimate {
        error: FACTOR * levels.get(1).map_or(0.0, |coarser| (coarser - levels[0]).abs()),
        order: None,
        extrapolated: false,
    });
    for bar in &mut verification.bars {
        let number = &bar.number;
        let least = match (number.resolution, number.amount.unit) {
            (resolution, _) if resolution > 0.0 => LEAST_PLACE * resolution,
            (_, Unit::Percent) => LEAST_PERCENT,
            _ => LEAST * number.amount.value.abs(),
        };
        bar.half = bar.half.map(|half| if half > 0.0 { half.max(least) } else { half });
    }
    verification
}
