//! Whether every verb judges a part alike, and whether advice keeps its word, on random parts.
//!
//! `cargo bench --bench verdicts -- --count 200 --advised 100 --seed 7`

#[path = "common/verdicts.rs"]
mod verdicts;

use rayon::prelude::*;
use stampflow::assess::Light;
use verdicts::{advised, disagreement, random_part};

fn main() {
    let [count, wanted, seed] =
        [("--count", 200), ("--advised", 100), ("--seed", 7)].map(|(name, value)| argument(name, value));
    let seeds = |from: u64, count: u64| (from..from + count).into_par_iter().map(|i| seed * 1_000_003 + i);
    let judged: Vec<_> = seeds(0, count).map(|seed| (seed, disagreement(&random_part(seed), seed % 10 == 0))).collect();
    for (seed, (text, _)) in &judged {
        text.iter().for_each(|text| eprintln!("{seed}: {text}"));
    }
    let alike = judged.iter().filter(|(_, (text, _))| text.is_none()).count();
    let sound = judged.iter().filter(|(_, (_, is_sound))| *is_sound).count();
    println!(
        "{alike} of {count} parts are judged alike by run, page, sweep, search and scatter, every tenth by the report too; \
         {sound} of them are sound\n"
    );

    let open: Vec<_> = seeds(0, 4 * wanted).filter_map(|seed| Some((seed, advised(&random_part(seed))?))).collect();
    println!("| light | parts | with advice | whose first advice does what it says |\n|---|---:|---:|---:|");
    for light in [Light::Red, Light::Amber] {
        let own: Vec<_> = open.iter().take(wanted as usize).filter(|(_, one)| one.light == light).collect();
        let given: Vec<_> = own.iter().filter_map(|(seed, one)| Some((seed, one.first.as_ref()?))).collect();
        for (seed, (text, keeps)) in &given {
            eprintln!("{seed}: {keeps} {text}");
        }
        let kept = given.iter().filter(|(_, (_, keeps))| *keeps).count();
        println!("| {} | {} | {} | {kept} |", light.name(), own.len(), given.len());
    }
}

/// A number given on the command line.
fn argument(name: &str, default: u64) -> u64 {
    let mut arguments = std::env::args().skip_while(|a| a != name).skip(1);
    arguments.next().map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name} {v}: not a number")))
}
