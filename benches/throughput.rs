//! Cups a minute: designs of the template `cup`, written, read and solved in memory on all cores, one run a thread.
//!
//! `cargo bench --bench throughput -- --count 1000 --seed 7`; `benches/instructions.sh --cups 20` counts the instructions of
//! a few of the same designs.
//!
//! Then the time of a thickness point over that of a bare hardening law, and the time of an iteration of one element on
//! meshes of 100 to 100 000 elements, which should be the same.

#[path = "common/fastest.rs"]
mod fastest;

use fastest::fastest;
use fastrand::Rng;
use rayon::iter::Either;
use rayon::prelude::*;
use stampflow::author::templates;
use stampflow::case::CaseError;
use stampflow::{Model, Observer, case, solver};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Iterations after which a large mesh has told its cost.
const FEW: usize = 60;

/// Counts iterations, and stops after so many.
struct Count {
    iterations: usize,
    most: usize,
}

impl Observer for Count {
    fn iteration(&mut self, _: &stampflow::solver::Iterate) {
        self.iterations += 1;
    }

    fn wants_to_stop(&mut self) -> bool {
        self.iterations >= self.most
    }
}

struct Cup {
    complete: bool,
    iterations: usize,
    /// To write and read its case, and to solve it.
    built: Duration,
    solved: Duration,
}

fn main() {
    let (count, seed) = (argument("--count", 1000), argument("--seed", 7));
    let start = Instant::now();
    let (cups, refused): (Vec<Cup>, Vec<CaseError>) =
        (0..count).into_par_iter().partition_map(|i| match draw(&design(seed, i)) {
            Ok(cup) => Either::Left(cup),
            Err(error) => Either::Right(error),
        });
    let minutes = start.elapsed().as_secs_f64() / 60.0;
    let mean = |of: &dyn Fn(&Cup) -> f64| cups.iter().map(of).sum::<f64>() / cups.len() as f64;
    println!(
        "{:<34} {:>10.0} on {} threads",
        "cups a minute",
        cups.len() as f64 / minutes,
        rayon::current_num_threads()
    );
    println!(
        "{:<34} {:>10}{}",
        "designs that cannot be built",
        refused.len(),
        refused.first().map_or(String::new(), |e| format!(": {e}"))
    );
    println!("{:<34} {:>10.1} %", "drawn to their full travel", 100.0 * mean(&|cup| f64::from(u8::from(cup.complete))));
    println!("{:<34} {:>10.1}", "iterations a cup", mean(&|cup| cup.iterations as f64));
    println!("{:<34} {:>10.2} ms", "to write and read one", 1e3 * mean(&|cup| cup.built.as_secs_f64()));
    println!("{:<34} {:>10.2} ms", "to solve one", 1e3 * mean(&|cup| cup.solved.as_secs_f64()));
    if argument("--meshes", 1) > 0 {
        ratio();
        meshes();
    }
}

fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}

/// Options of the `i`-th design: draw ratio, radii over the thickness, thickness and friction at random.
fn design(seed: u64, i: u64) -> Vec<(&'static str, String)> {
    let mut random = Rng::with_seed(seed.wrapping_mul(1_000_003) + i);
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    let (thickness, ratio) = (between(0.7, 1.5), between(1.6, 1.95));
    let [radius, nose, shoulder] =
        [(20.0, 40.0), (4.0, 8.0), (5.0, 8.0)].map(|(low, high)| between(low, high) * thickness);
    // The area of bottom and wall is that of the blank.
    let height = 0.5 * radius * (ratio * ratio - 1.0);
    let lengths = [
        ("thickness", thickness),
        ("punch-radius", radius),
        ("height", height),
        ("nose", nose),
        ("shoulder", shoulder),
    ];
    let mut options: Vec<_> = lengths.map(|(key, length)| (key, format!("{length:.3} mm"))).into();
    options.extend([("friction", format!("{:.4}", between(0.04, 0.12))), ("trim", "5 %".to_owned())]);
    options
}

/// Its model, as a case file of the template is read.
fn model(design: &[(&str, String)]) -> Result<Model, CaseError> {
    let given: Vec<(&str, &str)> = design.iter().map(|(key, value)| (*key, value.as_str())).collect();
    let text = templates::find("cup")?.fill(&given)?;
    Ok(case::parse(&text, "cup.toml", &[])?.model().clone())
}

fn draw(design: &[(&str, String)]) -> Result<Cup, CaseError> {
    let start = Instant::now();
    let model = model(design)?;
    let built = start.elapsed();
    let mut count = Count { iterations: 0, most: usize::MAX };
    let run = black_box(solver::run(&model, &mut count));
    Ok(Cup { complete: run.stop.is_complete(), iterations: count.iterations, built, solved: start.elapsed() - built })
}

/// The time of one evaluation of a thickness point, with elements, contact and solution around it, over that of a bare
/// hardening law.
fn ratio() {
    let model = model(&design(0, 0)).unwrap_or_else(|e| panic!("{e}"));
    let mut count = Count { iterations: 0, most: usize::MAX };
    let steps = solver::run(&model, &mut count).steps.len();
    // One evaluation of all points in every iteration, and one more that finds each step converged.
    let points = (count.iterations + steps) * model.blank.elements * model.blank.layers;
    let whole = fastest(|| drop(black_box(solver::run(black_box(&model), &mut ()))));
    let law = &model.material.hardening;
    let bare = fastest(|| {
        let mut sum = 0.0;
        for i in 0..points {
            let flow = law.at(black_box(1e-3 + 1e-6 * (i % 100_000) as f64));
            sum += flow.stress + flow.slope;
        }
        black_box(sum);
    });
    println!("{:<34} {:>10.2}", "ratio to the bare hardening loop", whole.as_secs_f64() / bare.as_secs_f64());
}

/// What an element costs in an iteration, on meshes of more and more of them.
fn meshes() {
    println!("\n{:<34} {:>10} {:>10}", "elements", "ns each", "of the first");
    let mut model = model(&design(0, 0)).unwrap_or_else(|e| panic!("{e}"));
    let mut first = None;
    for elements in [100, 1000, 10_000, 100_000] {
        model.blank.elements = elements;
        let mut count = Count { iterations: 0, most: FEW };
        let start = Instant::now();
        black_box(solver::run(&model, &mut count));
        let each = start.elapsed().as_secs_f64() / (count.iterations * elements) as f64;
        println!("{elements:<34} {:>10.0} {:>10.2}", 1e9 * each, each / *first.get_or_insert(each));
    }
}
