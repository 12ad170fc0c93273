//! What a run costs, in ratios measured in the same process: each shipped case, its wall time, its iterations, the
//! time of one evaluation of a thickness point with everything around it (elements, contact, solve), and that time over a bare
//! loop of as many hardening evaluations.
//!
//! `cargo bench --bench cases`

#[path = "common/fastest.rs"]
mod fastest;
#[allow(dead_code, reason = "tests also walk folders")]
#[path = "../tests/suite/common/files.rs"]
mod files;

use fastest::fastest;
use files::files;
use stampflow::model::Mode;
use stampflow::{Model, Observer, case, solver};
use std::hint::black_box;
use std::time::{Duration, Instant};

#[derive(Default)]
struct Count(usize);

impl Observer for Count {
    fn iteration(&mut self, _: &stampflow::solver::Iterate) {
        self.0 += 1;
    }
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
        "case", "wall ms", "steps", "iter.", "rejected", "ns/thickness point", "ns bare law", "ratio"
    );
    for path in files("cases", "toml") {
        let case = case::load(&path, &[]).unwrap_or_else(|e| panic!("{e}"));
        let model = case.model();
        let mut count = Count::default();
        let run = solver::run(model, &mut count);
        let time = fastest(|| {
            black_box(solver::run(black_box(model), &mut ()));
        });
        // One evaluation of all points per iteration, and one more that finds each step converged.
        let evaluations = (count.0 + run.steps.len()) * model.blank.elements * model.blank.layers;
        let point = time.as_nanos() as f64 / evaluations as f64;
        let law = bare(model);
        println!(
            "{:<24} {:>9.1} {:>6} {:>6} {:>9} {:>14.1} {:>12.1} {:>7.2}",
            case.name,
            time.as_secs_f64() * 1e3,
            run.steps.len(),
            count.0,
            run.steps.iter().map(|r| r.rejected).sum::<usize>(),
            point,
            law,
            point / law,
        );
    }
    elastoplastic();
}

/// Time and iterations of the elastoplastic law over those of the flow law on Woo's cup, runs of both in turn.
fn elastoplastic() {
    println!(
        "\n{:<24} {:>11} {:>16} {:>10} {:>10}",
        "elastoplastic / flow, Woo", "wall ratio", "iterations", "flow ms", "elastoplastic ms"
    );
    for layers in [5, 9, 15] {
        let settings = ["blank.elements=50".to_owned(), format!("blank.layers={layers}")];
        let flow = case::load(std::path::Path::new("cases/woo_hemispherical.toml"), &settings)
            .unwrap_or_else(|e| panic!("{e}"))
            .model()
            .clone();
        let mut elastoplastic = flow.clone();
        elastoplastic.mode = Mode::ElastoViscoplastic;
        let mut best = [Duration::MAX; 2];
        for _ in 0..15 {
            for (best, model) in best.iter_mut().zip([&flow, &elastoplastic]) {
                let start = Instant::now();
                black_box(solver::run(black_box(model), &mut ()));
                *best = start.elapsed().min(*best);
            }
        }
        let [of_flow, of_elastoplastic] = [&flow, &elastoplastic].map(|model| {
            let mut count = Count::default();
            solver::run(model, &mut count);
            count.0
        });
        let [flow, elastoplastic] = best.map(|best| best.as_secs_f64() * 1e3);
        println!(
            "{:<24} {:>11.2} {of_elastoplastic:>7} of {of_flow:>5} {flow:>10.1} {elastoplastic:>10.1}",
            format!("{layers} layers"),
            elastoplastic / flow
        );
    }
}
