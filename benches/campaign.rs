//! Random dies: how many run to their full travel, and what they cost.
//!
//! `cargo bench --bench campaign -- --count 1000 --seed 7`

#[path = "../tests/common/random_die.rs"]
mod random_die;

use random_die::{Process, random_die};
use rayon::prelude::*;
use stampflow::solver;
use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::time::Instant;

struct Outcome {
    process: Process,
    kind: &'static str,
    line: String,
    /// iterations a step, rejected tries, penetration, imbalance, seconds
    figures: [f64; 5],
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let value = |name: &str, default: u64| {
        let at = arguments.iter().position(|a| a == name);
        at.and_then(|i| arguments.get(i + 1))
            .map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
    };
    let (count, seed) = (value("--count", 200), value("--seed", 7));
    let outcomes: Vec<Outcome> = (0..count).into_par_iter().map(|i| one(seed.wrapping_mul(1_000_003) + i)).collect();

    println!("{count} random dies, seed {seed}");
    let mut kinds: BTreeMap<(&str, Process), usize> = BTreeMap::new();
    for o in &outcomes {
        *kinds.entry((o.kind, o.process)).or_default() += 1;
        if o.kind != "full travel" || o.figures[3] > 0.02 || o.figures[1] > 10.0 {
            let [_, rejected, _, imbalance, _] = o.figures;
            println!("  {}, {rejected} rejected, imbalance {:.1} %: {}", o.kind, 100.0 * imbalance, o.line);
        }
    }
    for kind in ["full travel", "localised", "drawn through", "tools closed", "no equilibrium", "panic"] {
        let total: usize = kinds.iter().filter(|(k, _)| k.0 == kind).map(|(_, n)| n).sum();
        println!("{kind:<16} {total:>6}  {:.1} %", 100.0 * total as f64 / count as f64);
        for ((k, process), n) in &kinds {
            if *k == kind && kind != "full travel" {
                println!("    {process:?}: {n}");
            }
        }
    }
    let names = ["iterations a step", "rejected tries", "penetration over t", "imbalance", "seconds"];
    println!("{:<20} {:>12} {:>16}", "", "median", "99th percentile");
    for (i, name) in names.iter().enumerate() {
        let mut values: Vec<f64> = outcomes.iter().filter(|o| o.kind != "panic").map(|o| o.figures[i]).collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        println!("{name:<20} {:>12.4} {:>16.4}", at(0.5), at(0.99));
    }
}

fn one(seed: u64) -> Outcome {
    let die = random_die(seed);
    let (process, text) = (die.process, die.text.clone());
    let start = Instant::now();
    let Ok(run) = catch_unwind(move || solver::run(&die.model, &mut ())) else {
        return Outcome { process, kind: "panic", line: format!("seed {seed}: {text}"), figures: [0.0; 5] };
    };
    let kind = run.stop.kind();
    let steps = run.history.len().max(1) as f64;
    let last = run.history.last().copied().unwrap_or_default();
    let largest = |f: fn(&stampflow::StepRecord) -> f64| run.history.iter().map(f).fold(0.0, f64::max);
    Outcome {
        process,
        kind,
        line: format!("seed {seed}: {text}: {} (thinnest {:.3})", run.stop, last.thinnest),
        figures: [
            run.history.iter().map(|r| r.iterations as f64).sum::<f64>() / steps,
            run.history.iter().map(|r| r.rejected as f64).sum(),
            largest(|r| r.penetration),
            last.work.imbalance().abs(),
            start.elapsed().as_secs_f64(),
        ],
    }
}
