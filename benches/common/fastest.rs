//! Time of what is done again and again.

use std::time::{Duration, Instant};

/// The fastest of a few repetitions: what the machine can do when nothing else runs.
pub fn fastest(mut work: impl FnMut()) -> Duration {
    let mut best = Duration::MAX;
    for _ in 0..7 {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed());
    }
    best
}
