//! The command line as a user meets it: files, exit codes, and what is left behind.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const CUP: &str = r#"
title = "Cup"
geometry = "axisymmetric"
notes = ["declared: all of it"]
[blank]
radius = "55 mm"
thickness = "1 mm"
elements = 30
[material.hardening]
swift = { k = "520 MPa", n = 0.22, offset = 0.005 }
[tools]
punch = { flat = { radius = "30 mm", nose = "6 mm" }, friction = 0.08, travel = "5 mm" }
die = { throat = "31.25 mm", shoulder = "6 mm", friction = 0.08 }
holder = { inner_radius = "38 mm", force = "10 kN" }
"#;

const COMPARE: &str = r#"
[[compare]]
reference = "curve.csv"
x = "travel_mm"
y = "punch_force_kN"
quantity = "punch_force"
tolerance = "5 %"
reason = "for the test"
"#;

fn stampflow(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stampflow")).args(args).current_dir(dir).output().unwrap()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

fn folder(case: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::create_dir(dir.path().join("cases")).unwrap();
    fs::write(dir.path().join("cases/cup.toml"), case).unwrap();
    dir
}

#[test]
fn a_run_writes_every_file_and_sums_up() {
    let dir = folder(CUP);
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "--trace", "trace.csv"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    for output in stampflow::output::OUTPUTS {
        let size = fs::metadata(dir.path().join("out/cup").join(output.file)).unwrap().len();
        assert!(size > 200, "{}: {size} bytes", output.file);
    }
    let summary = text(&done.stdout);
    for says in ["Peak punch force", "full travel reached", "declared: all of it", "out/cup"] {
        assert!(summary.contains(says), "{summary}");
    }
    let progress = text(&done.stderr);
    assert!(progress.contains("cup: 10 %") && progress.contains("cup: 100 %"), "{progress}");
    let trace = fs::read_to_string(dir.path().join("trace.csv")).unwrap();
    assert!(trace.starts_with("step,travel_mm,iteration,velocity_norm") && trace.lines().count() > 50);
}

#[test]
fn several_cases_go_to_folders_of_their_own_without_progress_when_quiet() {
    let dir = folder(CUP);
    fs::copy(dir.path().join("cases/cup.toml"), dir.path().join("cases/bowl.toml")).unwrap();
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "cases/bowl.toml", "--out", "r", "--quiet"]);
    assert_eq!((done.status.code(), text(&done.stderr)), (Some(0), ""));
    assert!(dir.path().join("r/cup/shapes.png").exists() && dir.path().join("r/bowl/shapes.png").exists());
    let summary = text(&done.stdout);
    assert!(summary.find("in r/cup").unwrap() < summary.find("in r/bowl").unwrap(), "in the order asked for");
}

#[test]
fn an_override_reaches_the_run_and_its_summary() {
    let dir = folder(CUP);
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--set", "tools.punch.travel=3 mm"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let json = fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    assert!(json.contains("\"travel_mm\": 3.0") && json.contains("tools.punch.travel=3 mm"), "{json}");
}

#[test]
fn bad_input_ends_with_2_and_writes_nothing() {
    let dir = folder(CUP);
    fs::write(dir.path().join("cases/curveless.toml"), format!("{CUP}{COMPARE}")).unwrap();
    for args in [
        &["run", "cases/none.toml"][..],
        &["run", "cases/cup.toml", "--set", "blank.thickness=thin"],
        &["run", "cases/cup.toml", "--set", "no equals sign"],
        &["run", "cases/cup.toml", "cases/none.toml"],
        &["run", "cases/cup.toml", "cases/cup.toml"],
        &["run", "cases/curveless.toml"],
        &["run", "cases/cup.toml", "cases/curveless.toml", "--trace", "t.csv"],
        &["check", "cases/none.toml"],
        &["validate", "--cases", "none"],
        &["run"],
        &["fly"],
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}", text(&done.stderr));
        assert!(!done.stderr.is_empty() && done.stdout.is_empty(), "{args:?}");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1, "{args:?} left something behind");
    }
}

/// Trust: three iterations do not find equilibrium, and steps may not be made smaller.
#[test]
fn an_early_end_is_3_and_keeps_its_results() {
    let dir = folder(CUP);
    let args = ["run", "cases/cup.toml", "-q", "--set", "solver.max_iterations=3", "--set", "solver.min_step=0.002"];
    let done = stampflow(dir.path(), &args);
    assert_eq!(done.status.code(), Some(3), "{}{}", text(&done.stdout), text(&done.stderr));
    assert!(text(&done.stdout).contains("no equilibrium"));
    let json = fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    assert!(json.contains("\"complete\": false"));
}

#[test]
fn a_folder_that_cannot_be_made_is_1() {
    let dir = folder(CUP);
    fs::write(dir.path().join("taken"), "mine").unwrap();
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--out", "taken"]);
    assert_eq!(done.status.code(), Some(1));
    assert!(text(&done.stderr).contains("cannot write taken"), "{}", text(&done.stderr));
    assert_eq!(fs::read_to_string(dir.path().join("taken")).unwrap(), "mine");
}

/// The computed curve is made the reference, once as it is and once 10 % off.
#[test]
fn validation_passes_on_its_own_curve_and_fails_on_another() {
    let dir = folder(&format!("{CUP}{COMPARE}"));
    let reference = dir.path().join("reference_data");
    fs::create_dir(&reference).unwrap();
    let first = folder(CUP);
    stampflow(first.path(), &["run", "cases/cup.toml", "-q"]);
    let table = fs::read_to_string(first.path().join("out/cup/load_travel.csv")).unwrap();
    for (factor, code, verdict) in [(1.0, 0, " in "), (1.1, 1, " OUT ")] {
        let mut curve = String::from("travel_mm,punch_force_kN\n");
        for row in table.lines().skip(20).step_by(20) {
            let cells: Vec<f64> = row.split(',').take(2).map(|cell| cell.parse().unwrap()).collect();
            curve += &format!("{},{}\n", cells[0], factor * cells[1] / 1000.0);
        }
        fs::write(reference.join("curve.csv"), curve).unwrap();
        let done = stampflow(dir.path(), &["validate", "-q"]);
        assert_eq!(done.status.code(), Some(code), "{}{}", text(&done.stdout), text(&done.stderr));
        assert!(text(&done.stdout).contains(verdict), "{}", text(&done.stdout));
        assert!(dir.path().join("out/validate/cup/compare_1_punch_force.png").exists());
    }
}

#[test]
fn an_optional_curve_may_be_missing() {
    let dir = folder(&format!("{CUP}{COMPARE}optional = true\n"));
    let done = stampflow(dir.path(), &["validate", "-q"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    assert!(text(&done.stdout).contains("no data"));
}

#[test]
fn schema_and_check_only_print() {
    let dir = folder(CUP);
    let schema = stampflow(dir.path(), &["schema"]);
    assert!(serde_json::from_slice::<serde_json::Value>(&schema.stdout).unwrap().is_object());
    let check = stampflow(dir.path(), &["check", "cases/cup.toml"]);
    assert_eq!(check.status.code(), Some(0), "{}", text(&check.stderr));
    assert!(!check.stdout.is_empty());
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
}
