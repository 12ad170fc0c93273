//! Inputs of every kind made wrong: each is refused with a message or ends in a named way.
//! Nothing panics, nothing hangs, nothing fills the memory, and what comes out is finite.
//!
//! The tests that run by themselves are a small part; all of it is
//! `cargo test --release --test suite attack:: -- --ignored --nocapture --test-threads 1`, some minutes. A seed makes the same inputs again, and
//! what fails is left in a file that the message names.

mod excess;
mod mutate;
mod promises;

use crate::common::prelude::*;
use mutate::mutated;
use stampflow::results::{Results, comparison::comparisons, csv};
use stampflow::{case::CaseError, plot::svg};
use std::{sync::mpsc::channel, time::Instant};

/// A cup without its punch's section, and what is read beside it.
const CUP: &str = include_str!("cup.toml");
const PUNCH: &str = r#"tools.punch = { flat = { radius = "30 mm", nose = "6 mm" }, friction = 0.08, travel = "5 mm" }"#;
const DRAWN_PUNCH: &str = r#"tools.punch = { profile = "curve.csv", friction = 0.08, travel = "5 mm" }"#;
const BAND: &str = include_str!("band.toml");
/// A case that reads `curve.csv`, and what stands there.
const BESIDE: [(&[&str], &str); 4] = [
    (&[CUP, DRAWN_PUNCH], "r_mm,z_mm,radius_mm\n0,0,\n30,0,6\n30,-20,\n30.01,-40,\n"),
    (&[CUP, PUNCH, "heat.initial = \"curve.csv\""], "# Measured.\ns0_mm,temperature_C\n10,20\n30,150\n55,230.5\n"),
    (&[CUP, PUNCH, COMPARE], "travel_mm,punch_force_kN\n1,4\n2,7.5\n3,9.9\n5,14\n"),
    (&[CUP, PUNCH, BAND], "point,low_mm,high_mm,error_mm\n1,0.95,0.98,0.01\n2,0.97,1.01,0.01\n"),
];

/// What is made wrong.
#[derive(Clone)]
enum Target {
    Case,
    Drawing,
    /// What a case reads: its text.
    Beside(String),
}

struct Subject {
    target: Target,
    bytes: Vec<u8>,
}

impl Subject {
    /// Every shipped case and two that use the rest of the keys, every drawing of another program, and every kind of table.
    fn all() -> Vec<Self> {
        let of = |files: Vec<_>, target: fn() -> Target| {
            let read = move |path| Self { target: target(), bytes: fs::read(path).expect("readable") };
            files.into_iter().map(read).collect::<Vec<_>>()
        };
        let tables = BESIDE.iter().flat_map(|(case, table)| {
            std::iter::repeat_with(|| Self { target: Target::Beside(case.join("\n")), bytes: (*table).into() }).take(3)
        });
        let mut all = of(files("cases", "toml"), || Target::Case);
        all.extend(of(files("tests/suite/attack", "toml"), || Target::Case));
        all.extend(of(files("tests/drawings", "dxf"), || Target::Drawing));
        all.extend(tables);
        all
    }
}

/// Ends a run after so much work: elements times what each looks at, once in every iteration.
struct Budget {
    left: usize,
    size: usize,
}

impl Observer for Budget {
    fn state(&mut self, model: &Model, _: &State) {
        let pieces: usize = model.tools.iter().map(|tool| tool.profile.pieces().len()).sum();
        self.size = model.blank.elements * (model.blank.layers + pieces);
    }

    fn iteration(&mut self, _: &stampflow::solver::Iterate) {
        self.left = self.left.saturating_sub(self.size);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.left == 0
    }
}

/// A message that can be acted on: it says something, points into its text, stays short, and no terminal obeys it.
fn check_refusal(error: &CaseError) {
    assert!(!error.to_string().trim().is_empty());
    assert!(error.position().is_none_or(|(line, column)| line >= 1 && column >= 1));
    let shown = error.render(false);
    assert!(shown.chars().count() < 6_000, "a message of {} characters", shown.chars().count());
    assert!(!shown.contains(|c: char| c.is_control() && c != '\n' && c != '\t'), "{shown:?}");
}

/// Checks, solves as far as a budget of work goes, and looks at what came out; whether it could be solved.
fn check_accepted(case: Case, work: usize) -> bool {
    promises::of_model(&case);
    if let Err(error) = comparisons(&case, &Computed::nothing(case.model())) {
        assert!(error.to_string().chars().count() < 2_000, "{error}");
        return false;
    }
    let solution = case.solve(&mut Budget { left: work, size: 0 });
    for stage in &solution.stages {
        assert!(!stage.stop.to_string().is_empty());
        let end = stage.steps.last().map_or(0.0, |last| last.time / stage.model.duration);
        assert!(stage.stop.kind.name() != "full travel" || (end - 1.0).abs() < 1e-6, "full travel at {end}");
        let finite = |frame: &stampflow::Frame| frame.nodes.iter().all(|n| n.r.is_finite() && n.z.is_finite());
        assert!(stage.frames.iter().all(finite), "{}", stage.stop);
    }
    let results = Results::of(&solution).expect("it fitted before");
    for output in OUTPUTS {
        for view in &results.views {
            match output.make {
                Make::Table(make) => {
                    let Some(table) = make(view) else { continue };
                    for column in &table.columns {
                        // A limit that has ended is none, and its cell is empty.
                        let may_end = ["limit_major", "margin"].contains(&&*column.key);
                        let sound = |v: &f64| v.is_finite() || v.is_nan() && may_end;
                        assert!(column.values.iter().all(sound), "{}: {}", output.file, column.key);
                    }
                    assert!(!csv(&table).is_empty());
                }
                Make::Text(make) => make(view).iter().for_each(|text| promises::of_json(text)),
                Make::Plot(make) => make(view).iter().for_each(|chart| promises::of_picture(&svg(chart), output.file)),
                Make::Moving(..) | Make::OfCase(_) => {}
            }
        }
        if let Make::OfCase(make) = output.make {
            drop(make(&results));
        }
    }
    let _ = solution.summary();
    true
}

/// Work of one input: a small case to its end, a large one some iterations.
const WORK: usize = 300_000;

fn check_read(case: Result<Case, CaseError>, work: usize) -> bool {
    match case {
        Ok(case) => check_accepted(case, work),
        Err(error) => {
            check_refusal(&error);
            false
        }
    }
}

fn check_case(text: &str, files: &dyn Files) -> bool {
    check_read(case::parse_with(text, "cases/mutated.toml", &[], files), WORK)
}

fn check_drawing(bytes: &[u8]) -> bool {
    match Import::default().read(bytes, Path::new("mutated.dxf")) {
        Ok(imported) => check_read(Ok(imported.case), WORK),
        Err(error) => {
            let length = error.to_string().chars().count();
            assert!(length < 3_000, "a message of {length} characters");
            false
        }
    }
}

/// Whether the bytes could be read and solved.
fn check(target: &Target, bytes: &[u8]) -> bool {
    match target {
        Target::Case => check_case(&String::from_utf8_lossy(bytes), &Disk),
        Target::Drawing => check_drawing(bytes),
        Target::Beside(case) => {
            let mut memory = Memory::default();
            memory.insert("cases/curve.csv", bytes);
            check_case(case, &memory)
        }
    }
}

/// Ten seconds of a quiet machine; the slowest input takes less than one.
const LONGEST: Duration = Duration::from_secs(60);

/// Runs a job beside a clock: the time it took and what it says, or how it failed.
fn timed(job: impl FnOnce() -> bool + Send + 'static) -> Result<(Duration, bool), String> {
    let start = Instant::now();
    let (done, ended) = channel();
    let worker = std::thread::spawn(move || {
        let solved = job();
        let _ = done.send(());
        solved
    });
    if ended.recv_timeout(LONGEST) == Err(std::sync::mpsc::RecvTimeoutError::Timeout) {
        return Err(format!("no end after {LONGEST:?}"));
    }
    worker.join().map(|solved| (start.elapsed(), solved)).map_err(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        words.unwrap_or("a panic").chars().take(500).collect()
    })
}

/// Runs `count` inputs of a seed, of which a share has to be solved.
fn run_all(seed: u64, count: u64, least: f64, mut one: impl FnMut(u64) -> (String, Result<(Duration, bool), String>)) {
    let (mut failed, mut slowest, mut done) = (String::new(), (Duration::ZERO, 0), 0);
    for i in 0..count {
        match one(i) {
            (_, Ok((time, solved))) => (slowest, done) = (slowest.max((time, i)), done + u64::from(solved)),
            (name, Err(why)) => drop(writeln!(failed, "seed {seed}, input {i}, {name}: {why}")),
        }
    }
    println!("seed {seed}: {count} inputs, {done} solved, slowest {slowest:?}");
    assert!(failed.is_empty(), "{failed}");
    assert!(done as f64 > least * count as f64, "{done} of {count} inputs were solved");
}

fn attack(seed: u64, count: u64) {
    let subjects = Subject::all();
    run_all(seed, count, 0.1, |i| {
        let mut rng = Rng::with_seed(seed.wrapping_mul(1_000_003) + i);
        let subject = &subjects[rng.usize(..subjects.len())];
        let bytes = mutated(&subject.bytes, matches!(subject.target, Target::Case), &mut rng);
        let (target, own) = (subject.target.clone(), bytes.clone());
        let result = timed(move || check(&target, &own));
        let path = std::env::temp_dir().join(format!("stampflow-attack-{seed}-{i}"));
        if result.is_err() {
            fs::write(&path, &bytes).expect("writable");
        }
        (path.display().to_string(), result)
    });
}

#[test]
fn three_hundred_mutated_inputs_are_refused_or_solved() {
    attack(1, 300);
}

#[test]
#[ignore = "takes minutes"]
fn ten_thousand_mutated_inputs_are_refused_or_solved() {
    (2..=6).for_each(|seed| attack(seed, 2_000));
}
