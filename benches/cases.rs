//! What a run costs, in ratios measured in the same process: each shipped case, its wall time, its iterations, the
//! time of one layer-point evaluation with everything around it (elements, contact, solve), and that time over a bare
//! loop of as many hardening evaluations.
//!
//! `cargo bench --bench cases`

#[path = "../tests/common/files.rs"]
mod files;

use files::files;
use stampflow::record::IterationRecord;
use stampflow::{Model, Observer, case, solver};
use std::hint::black_box;
use std::time::{Duration, Instant};

#[derive(Default)]
struct Count(usize);

impl Observer for Count {
    fn iteration(&mut self, _: &IterationRecord) {
        self.0 += 1;
    }
}

/// The fastest of a few repetitions: what the machine can do when nothing else runs.
fn fastest(mut work: impl FnMut()) -> Duration {
    let mut best = Duration::MAX;
    for _ in 0..7 {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed());
    }
    best
}

/// Nanoseconds of one bare hardening evaluation.
fn bare(model: &Model) -> f64 {
    const EVALUATIONS: usize = 200_000;
    let law = &model.material.hardening;
    let time = fastest(|| {
        let mut sum = 0.0;
        for i in 0..EVALUATIONS {
            let flow = law.at(black_box(1e-3 + 1e-6 * i as f64));
            sum += flow.stress + flow.slope;
        }
        black_box(sum);
    });
    time.as_nanos() as f64 / EVALUATIONS as f64
}

fn main() {
    println!(
        "{:<24} {:>9} {:>6} {:>6} {:>9} {:>14} {:>12} {:>7}",
        "case", "wall ms", "steps", "iter.", "rejected", "ns/layer point", "ns bare law", "ratio"
    );
    for path in files("cases", "toml") {
        let case = case::load(&path, &[]).unwrap_or_else(|e| panic!("{e}"));
        let model = &case.model;
        let mut count = Count::default();
        let run = solver::run(model, &mut count);
        let time = fastest(|| {
            black_box(solver::run(black_box(model), &mut ()));
        });
        // One evaluation of all points per iteration, and one more that finds each step converged.
        let evaluations = (count.0 + run.history.len()) * model.blank.elements * model.blank.layers;
        let point = time.as_nanos() as f64 / evaluations as f64;
        let law = bare(model);
        println!(
            "{:<24} {:>9.1} {:>6} {:>6} {:>9} {:>14.1} {:>12.1} {:>7.2}",
            case.name,
            time.as_secs_f64() * 1e3,
            run.history.len(),
            count.0,
            run.history.iter().map(|r| r.rejected).sum::<usize>(),
            point,
            law,
            point / law,
        );
    }
}
