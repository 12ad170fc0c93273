//! Random dies: how they end, and what they cost.
//!
//! `cargo bench --bench campaign -- --count 1000 --seed 7`, with `--selective 1` for selective bending, `--elastoplastic 1` for
//! the elastoplastic law

#[path = "../tests/suite/common/random_die.rs"]
mod random_die;

use random_die::{Process, random_die};
use rayon::prelude::*;
use stampflow::material::Elastic;
use stampflow::model::{Mode, Theory};
use stampflow::{StepRecord, solver};
use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::time::Instant;

/// Ends that count as done, as a failure of the solver, and as a mistake in it; all others are physical.
const FULL_TRAVEL: &str = "full travel";
const NO_EQUILIBRIUM: &str = "no equilibrium";
const PANIC: &str = "panic";

/// What is measured of every run that did not panic.
const FIGURES: [&str; 6] =
    ["iterations a step", "rejected steps", "rejected tries", "penetration over t", "power balance error", "seconds"];

struct Outcome {
    process: Process,
    kind: &'static str,
    line: String,
    /// In the order of [`FIGURES`].
    figures: [f64; 6],
}

fn main() {
    let (count, seed) = (argument("--count", 200), argument("--seed", 7));
    let theory = if argument("--selective", 0) == 0 { Theory::Bending } else { Theory::Selective };
    let seeds = (0..count).into_par_iter().map(|i| seed.wrapping_mul(1_000_003) + i);
    let elastoplastic = argument("--elastoplastic", 0) != 0;
    let outcomes: Vec<Outcome> = seeds.map(|seed| one(seed, theory, elastoplastic)).collect();

    println!("{count} random dies, seed {seed}; worth a look:");
    for o in &outcomes {
        let [_, rejected, _, _, imbalance, _] = o.figures;
        if o.kind != FULL_TRAVEL || imbalance > 0.02 || rejected > 10.0 {
            println!("  {}, {rejected} steps rejected, imbalance {:.1} %: {}", o.kind, 100.0 * imbalance, o.line);
        }
    }
    println!();
    print_ends(&outcomes);
    println!();
    print_figures(&outcomes);
}

/// A number given on the command line.
fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}

/// Full travel, physical stops kind by kind, no equilibrium, panics; what did not end well by process.
fn print_ends(outcomes: &[Outcome]) {
    let mut ends: BTreeMap<&str, BTreeMap<Process, usize>> = BTreeMap::new();
    for o in outcomes {
        *ends.entry(o.kind).or_default().entry(o.process).or_default() += 1;
    }
    let named = [FULL_TRAVEL, NO_EQUILIBRIUM, PANIC];
    let physical: Vec<&str> = ends.keys().copied().filter(|kind| !named.contains(kind)).collect();
    let print = |label: &str, kinds: &[&str]| {
        let total: usize = kinds.iter().filter_map(|k| ends.get(k)).flat_map(BTreeMap::values).sum();
        println!("{label:<28} {total:>6}  {:>5.1} %", 100.0 * total as f64 / outcomes.len().max(1) as f64);
    };
    print(FULL_TRAVEL, &[FULL_TRAVEL]);
    print("physical stop", &physical);
    for kind in &physical {
        print(&format!("  {kind}"), &[kind]);
    }
    for kind in [NO_EQUILIBRIUM, PANIC] {
        print(kind, &[kind]);
        for (process, n) in ends.get(kind).into_iter().flatten() {
            println!("    {process:?}: {n}");
        }
    }
}

fn print_figures(outcomes: &[Outcome]) {
    println!("{:<20} {:>12} {:>16}", "", "median", "99th percentile");
    for (i, name) in FIGURES.iter().enumerate() {
        let mut values: Vec<f64> = outcomes.iter().filter(|o| o.kind != PANIC).map(|o| o.figures[i]).collect();
        if values.is_empty() {
            continue;
        }
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        println!("{name:<20} {:>12.4} {:>16.4}", at(0.5), at(0.99));
    }
}

fn one(seed: u64, theory: Theory, elastoplastic: bool) -> Outcome {
    let mut die = random_die(seed);
    die.model.blank.theory = theory;
    if elastoplastic {
        die.model.mode = Mode::ElastoViscoplastic;
        die.model.material.elastic = Some(Elastic { young: 206_000.0, poisson: 0.3 });
        die.model.blank.layers = 15;
    }
    let (process, text) = (die.process, die.text.clone());
    let start = Instant::now();
    let Ok(run) = catch_unwind(move || solver::run(&die.model, &mut ())) else {
        return Outcome { process, kind: PANIC, line: format!("seed {seed}: {text}"), figures: [0.0; 6] };
    };
    let steps = run.steps.len().max(1) as f64;
    let last = run.steps.last().copied().unwrap_or_default();
    let total = |f: fn(&StepRecord) -> usize| run.steps.iter().map(f).sum::<usize>() as f64;
    Outcome {
        process,
        kind: run.stop.kind(),
        line: format!("seed {seed}: {text}: {} (thinnest {:.3})", run.stop, last.thinnest),
        figures: [
            total(|r| r.iterations) / steps,
            (run.effort.halved + run.effort.overstrained) as f64,
            total(|r| r.rejected) + run.effort.abandoned as f64,
            run.steps.iter().map(|r| r.penetration).fold(0.0, f64::max),
            last.work.imbalance().abs(),
            start.elapsed().as_secs_f64(),
        ],
    }
}
