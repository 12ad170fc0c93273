//! A random stamping section through the library: made from a seed, solved, summed up in a line.
//!
//! `cargo run --release --example random_die -- --seed 3 [--out DIR]`; without `--out` nothing is written.

#[path = "../tests/suite/common/random_die.rs"]
mod random_die;

use random_die::{RandomDie, random_die};
use stampflow::results::StageView;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let (mut seed, mut out) = (None, None);
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or(format!("{name} needs a value, as in --seed 3 --out DIR"))?;
        match name.as_str() {
            "--seed" => {
                seed = Some(value.parse::<u64>().map_err(|_| format!("--seed {value}: not a whole number from 0 on"))?);
            }
            "--out" => out = Some(value),
            _ => return Err(format!("unknown argument {name}; known are --seed N and --out DIR")),
        }
    }
    let seed = seed.ok_or("give a seed, as in --seed 3")?;

    let RandomDie { process, model, text } = random_die(seed);
    println!("{text}");
    let start = Instant::now();
    let run = stampflow::run(&model, &mut ());
    let wall = start.elapsed();
    let last = run.steps.last().copied().unwrap_or_default();
    println!(
        "{}: travel {:.2} of {:.2} mm, punch force {:.4e} {}, thinnest {:.3} of {:.3} mm, {} steps, {:.0} ms",
        run.stop.kind(),
        last.travel,
        model.travel,
        last.punch_force,
        model.extent().force_unit().symbol(),
        last.thinnest,
        model.blank.thickness,
        run.steps.len(),
        1e3 * wall.as_secs_f64()
    );
    if !run.stop.is_complete() {
        println!("{}", run.stop);
    }
    if let Some(dir) = out {
        let name = format!("{process:?}_{seed}").to_lowercase();
        let mut view = StageView::alone(&name, &run);
        (view.case_text, view.wall) = (&text, Some(wall));
        let files = view.write(Path::new(&dir)).map_err(|e| format!("{e}: {}", e.source))?;
        println!("{} files in {dir}", files.len());
    }
    Ok(())
}
