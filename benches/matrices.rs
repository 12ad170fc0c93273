//! Iterations of the accepted steps of whole runs with each matrix of the corrector, and how often a step was rejected, as a
//! table of Markdown.
//!
//! `cargo bench --bench matrices`

use stampflow::model::Iteration;
use stampflow::solver::solution::StageSolution;
use stampflow::{case, solver};

const CASES: [&str; 7] = [
    "quickstart",
    "woo_hemispherical",
    "chalmers_cup",
    "osu_stretch",
    "osu_stretch_friction",
    "stretch_thin",
    "strip_draw",
];

fn main() {
    println!("| case | primal-dual | Newton | secant |\n|---|---|---|---|");
    for name in CASES {
        let path = format!("{}/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let case = case::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        let [primal_dual, newton, secant] =
            [Iteration::PrimalDual, Iteration::Newton, Iteration::Secant].map(|iteration| {
                let mut model = case.model().clone();
                model.settings.iteration = iteration;
                told(&solver::run(&model, &mut ()), model.travel)
            });
        println!("| {name} | {primal_dual} | {newton} | {secant} |");
    }
}

/// Iterations, rejected steps in brackets, and where a run ended that did not come to its full travel.
fn told(run: &StageSolution, travel: f64) -> String {
    let iterations: usize = run.steps.iter().map(|step| step.iterations).sum();
    let rejected: usize = run.steps.iter().map(|step| step.rejected).sum();
    let reached = run.steps.last().map_or(0.0, |step| step.travel);
    let ended =
        if run.stop.is_complete() { String::new() } else { format!(", ends at {reached:.1} of {travel:.1} mm") };
    format!("{iterations} ({rejected}){ended}")
}
