//! Random dies: how they end, and what they cost.
//!
//! `cargo bench --bench campaign -- --count 1000 --seed 7`, with `--elastoplastic 1` for the elastoplastic law,
//! `--sheets 1` for the sheets of the library in place of random laws, `--templates 1` for tubes, holes, pads and reverse redraws, `--work 1` for bends, ironing, gas, free flanges and second stages in place of sections that are drawn; `--r 60` is r̄ = 0.6 in place of the sheet's, and
//! `--hosford 8` Hosford's yield condition of that exponent with it

#[path = "../tests/suite/common/random_die.rs"]
mod random_die;
#[path = "common/random_template.rs"]
mod random_template;
#[path = "../tests/suite/common/random_work.rs"]
mod random_work;

use random_die::{THIRD_SERIES, random_die};
use random_template::random_template;
use random_work::{make_elastic, random_work};
use rayon::prelude::*;
use stampflow::material::{Hill48, Hosford, YieldCriterion};
use stampflow::model::Beginning;
use stampflow::{Stage, StageSolution, StepRecord, solver};
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
    work: String,
    kind: &'static str,
    line: String,
    /// In the order of [`FIGURES`].
    figures: [f64; 6],
}

fn main() {
    let (count, seed) = (argument("--count", 200), argument("--seed", 7));
    let asked = |name: &str| argument(name, 0) != 0;
    let make = match () {
        () if asked("--templates") => random_template,
        () if asked("--work") => work,
        () => section,
    };
    let series = if asked("--sheets") { THIRD_SERIES } else { 0 };
    let seeds = (0..count).into_par_iter().map(|i| series + seed.wrapping_mul(1_000_003) + i);
    let elastoplastic = asked("--elastoplastic");
    let r = argument("--r", 100) as f64 / 100.0;
    let criterion: Option<YieldCriterion> = match argument("--hosford", 0) {
        0 if !asked("--r") => None,
        0 => Some(Hill48::new(r).into()),
        exponent => Some(Hosford::new(r, exponent as f64).into()),
    };
    let outcomes: Vec<Outcome> = seeds.map(|seed| one(seed, make(seed, elastoplastic), criterion)).collect();

    // What is worth a look is for whoever runs it, the figures are for the book.
    eprintln!("worth a look:");
    for o in &outcomes {
        let [_, rejected, _, _, imbalance, _] = o.figures;
        if o.kind != FULL_TRAVEL || imbalance > 0.02 || rejected > 10.0 {
            eprintln!("  {}, {rejected} steps rejected, imbalance {:.1} %: {}", o.kind, 100.0 * imbalance, o.line);
        }
    }
    println!("{count} random dies, seed {seed}\n");
    print_ends(&outcomes);
    println!();
    print_figures(&outcomes);
}

/// A number given on the command line.
fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}

/// Full travel, physical stops kind by kind, no equilibrium, panics; what did not end well by kind of work.
fn print_ends(outcomes: &[Outcome]) {
    let mut ends: BTreeMap<&str, BTreeMap<&str, usize>> = BTreeMap::new();
    for o in outcomes {
        *ends.entry(o.kind).or_default().entry(&o.work).or_default() += 1;
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
        for (work, n) in ends.get(kind).into_iter().flatten() {
            println!("    {work}: {n}");
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

/// What is made from a seed, its stages, and its description.
type Made = (String, Vec<Stage>, String);

/// A section that is drawn in one stage.
fn section(seed: u64, elastoplastic: bool) -> Made {
    let mut die = random_die(seed);
    if elastoplastic {
        make_elastic(&mut die.model);
    }
    let stage = Stage { name: "draw".into(), model: die.model, begin: Beginning::default() };
    (format!("{:?}", die.process), vec![stage], die.text)
}

/// Work of another kind.
fn work(seed: u64, elastoplastic: bool) -> Made {
    let work = random_work(seed, elastoplastic);
    (format!("{:?}", work.kind), work.stages, work.text)
}

fn one(seed: u64, (work, mut stages, text): Made, criterion: Option<YieldCriterion>) -> Outcome {
    for stage in &mut stages {
        if let Some(criterion) = criterion {
            stage.model.material.yield_criterion = criterion;
        }
    }
    let start = Instant::now();
    let Ok(solved) = catch_unwind(move || solver::solve(&stages, &mut ())) else {
        return Outcome { work, kind: PANIC, line: format!("seed {seed}: {text}"), figures: [0.0; 6] };
    };
    let run = solved.last().expect("a stage");
    let all = || solved.iter().flat_map(|stage| &stage.steps);
    let total = |f: fn(&StepRecord) -> usize| all().map(f).sum::<usize>() as f64;
    let counted = |f: fn(&StageSolution) -> usize| solved.iter().map(f).sum::<usize>() as f64;
    // Of the first stage: a later one may do hardly any work.
    let drawn = solved[0].steps.last().copied().unwrap_or_default();
    let thinnest = run.steps.last().map_or(drawn.thinnest, |last| last.thinnest);
    Outcome {
        work,
        kind: run.stop.kind.name(),
        line: format!("seed {seed}: {text}: stage {}: {} (thinnest {thinnest:.3})", solved.len(), run.stop),
        figures: [
            total(|r| r.iterations) / all().count().max(1) as f64,
            counted(|stage| stage.effort.halved + stage.effort.overstrained),
            total(|r| r.rejected) + counted(|stage| stage.effort.abandoned),
            all().map(|r| r.penetration).fold(0.0, f64::max),
            drawn.work.imbalance().abs(),
            start.elapsed().as_secs_f64(),
        ],
    }
}
