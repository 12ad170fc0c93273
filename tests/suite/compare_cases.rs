//! Cases, variants and measurements side by side: names, differences against their errors, pictures, files, wrong input.

use crate::common::cli::{CUP, folder, stampflow, text};
use serde_json::Value;
use stampflow::output::study::versus::{csv, pictures};
use stampflow::study::versus::{Asked, Candidate, Change, Versus};
use stampflow::{case, table};
use std::fs;
use std::path::Path;

/// A cup with a forming limit and variants of it.
fn versus(variants: &[&str]) -> Versus {
    let base = format!("{CUP}[forming_limit]\nhill = true\n");
    let candidate = |own: Vec<String>| Candidate { case: case::parse(&base, "cup.toml", &own).expect("a case"), own };
    let own = variants.iter().map(|text| Candidate::overrides(text).expect("overrides"));
    let all = std::iter::once(Vec::new()).chain(own).map(candidate).collect();
    Asked::new(all, Vec::new()).expect("something to compare").solve(None, 2, &()).expect("solved")
}

fn change(versus: &Versus, key: &str, run: usize) -> Change {
    versus.compared().iter().find(|row| row.number.key == key).expect("a number").changes[run]
}

/// Trust: friction raises the force by far more than bars of 2 % leave open, a millionth of it does not; the change
/// is that between the largest forces of both runs.
#[test]
fn a_difference_is_told_unless_the_error_bars_leave_it_open() {
    let versus = versus(&["friction=0.2", "friction=0.08001", "tools.holder.force=10.0 kN"]);
    let Change::By(by, Some(share)) = change(&versus, "punch_force", 0) else { panic!("friction changes the force") };
    let [a, b] = [0, 1].map(|i| {
        let steps = &versus.members[i].solution.stages[0].steps;
        steps.iter().map(|step| step.punch_force).fold(0.0, f64::max)
    });
    assert!((by.value - (b - a)).abs() < 1e-9 * b && (share - (b / a - 1.0)).abs() < 1e-9 && b > 1.05 * a, "{a} {b}");
    let within = change(&versus, "punch_force", 1);
    assert!(matches!(within, Change::Within(by) if by.value > 0.0));
    let told = within.told().to_string();
    assert!(told.starts_with('+') && told.contains('N') && told.ends_with("(within the error)"), "{told}");
    assert_eq!(change(&versus, "punch_force", 2), Change::Same);
}

/// Trust: what a user would call them.
#[test]
fn runs_are_named_by_what_sets_them_apart() {
    let names = |variants: &[&str]| {
        let versus = versus(variants);
        versus.members.iter().map(|member| member.label().to_string()).collect::<Vec<_>>()
    };
    assert_eq!(
        names(&["friction=0.1; tools.die.shoulder=5 mm"]),
        ["A: friction 0.08, die shoulder 6 mm", "B: friction 0.1, die shoulder 5 mm"]
    );
    assert_eq!(
        names(&["solver.max_step=0.05", "tools.punch.friction=0.1"]),
        [
            "A: punch friction 0.08, solver max step by default",
            "B: punch friction 0.08, solver max step 0.05",
            "C: punch friction 0.1, solver max step by default"
        ]
    );
}

/// Trust: every curve, and nothing else, in each picture.
#[test]
fn pictures_have_a_curve_of_every_run() {
    let versus = versus(&["friction=0.2"]);
    let drawn = pictures(&versus, false);
    let stems: Vec<&str> = drawn.iter().map(|drawn| drawn.stem).collect();
    assert_eq!(stems, ["compare_load", "compare_thickness", "compare_strains", "compare_sections"]);
    for drawn in &drawn {
        let labels: Vec<&str> = drawn.chart.panels[0].series.iter().filter_map(|s| s.label.as_deref()).collect();
        assert_eq!(labels[..2], ["A: friction 0.08", "B: friction 0.2"], "{}", drawn.stem);
        assert!(drawn.chart.title.starts_with("Compared: "), "{}", drawn.chart.title);
        let size = drawn.chart.panels[0].series.iter().map(|series| series.points.len()).min();
        assert!(size.is_some_and(|points| points > 3), "{}", drawn.stem);
    }
    let bytes = csv(&versus);
    let rows = table::Csv::read(text(&bytes).trim(), "the table", "").map(|csv| csv.rows.len());
    assert!(rows.is_ok_and(|rows| rows == 2 * (versus.compared().len() + 2)));
}

fn json(dir: &Path, args: &[&str]) -> Value {
    let done = stampflow(dir, args);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    serde_json::from_slice(&done.stdout).expect("JSON")
}

/// Trust: a run's own tables laid over it are what it computed, but for the digits that a table has.
#[test]
fn a_runs_own_tables_lie_on_its_curves() {
    let dir = folder(CUP);
    let ran = stampflow(dir.path(), &["run", "cases/cup.toml", "--quiet", "--out", "r"]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let args = ["compare", "cases/cup.toml", "r/load_travel.csv", "r/profile.csv", "--json", "--out", "c"];
    let value = json(dir.path(), &args);
    let measured = value["measured"].as_array().expect("curves");
    assert_eq!(measured.len(), 2);
    for (curve, (name, least)) in measured.iter().zip([("load_travel.csv", 1.0), ("profile.csv", 1e-6)]) {
        let [rms, points] = ["rms", "points"].map(|key| curve["of_runs"][0][key].as_f64().expect("a number"));
        assert_eq!(curve["curve"], name);
        // Trust: nine digits are written of forces of 10 kN and of thicknesses of 1 mm.
        assert!(rms < least && points + 1.0 >= curve["points"].as_f64().expect("a number"), "{curve}");
    }
    for file in value["files"].as_array().expect("files") {
        assert!(dir.path().join(file.as_str().expect("a path")).is_file(), "{file}");
    }
}

/// Trust: the units of the headers, a travel each where a file has several.
#[test]
fn measured_curves_are_read_with_their_units() {
    let dir = folder(CUP);
    let csv = "# measured\npunch_force_kN,travel_a_mm,travel_b_in\n1,0.5,0.02\n4,1.5,0.06\n9,3,\n";
    fs::write(dir.path().join("press.csv"), csv).unwrap();
    let measured = stampflow::study::versus::Measured::read(&dir.path().join("press.csv").into()).expect("curves");
    let curves: Vec<_> = measured.curves.iter().map(|curve| (curve.name.as_str(), curve.points.clone())).collect();
    assert_eq!(curves[0], ("press.csv, travel_a_mm", vec![(0.5, 1000.0), (1.5, 4000.0), (3.0, 9000.0)]));
    assert_eq!((curves[1].0, curves[1].1.len()), ("press.csv, travel_b_in", 2));
    assert!((curves[1].1[1].0 - 1.524).abs() < 1e-12);
}

/// Trust: the numbers of the table stand for the curves of the list above it, however long their names are.
#[test]
fn measured_curves_have_numbers_and_the_table_fits_eighty_columns() {
    let dir = folder(CUP);
    let name = "a_press_with_a_very_long_name_that_nobody_would_want_to_read_twice.csv";
    fs::write(dir.path().join(name), "travel_mm,punch_force_kN\n0.5,1\n1.5,2\n9,3\n").unwrap();
    let done = stampflow(dir.path(), &["compare", "cases/cup.toml", name, "--quiet", "--out", "c"]);
    let told = text(&done.stdout);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    assert!(told.contains(&format!("1: {name}")) && told.contains("Off curve 1, r.m.s."), "{told}");
    assert!(told.contains("at 2 of 3 points"), "{told}");
    assert!(told.lines().all(|line| line.chars().count() <= 80), "{told}");
}

/// Trust: each is wrong in the way that its message says, before anything is run.
#[test]
fn what_cannot_be_compared_is_told_and_nothing_is_written() {
    let dir = folder(CUP);
    let strip = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/strip_draw.toml");
    let write = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    write("bare.csv", "travel,punch_force\n1,2\n3,4\n");
    write("words.csv", "travel_mm,punch_force_kN\n1,two\n3,4\n");
    write("other.csv", "time_s,temperature_C\n1,2\n3,4\n");
    write("one.csv", "travel_mm,punch_force_kN\n1,2\n");
    write("late.csv", "travel_mm,punch_force_kN\n900,2\n901,3\n");
    write("swapped.csv", "travel_kN,punch_force_mm\n1,2\n3,4\n");
    write("line.csv", "travel_mm,punch_force_N_per_mm\n1,2\n3,4\n");
    let cup = "cases/cup.toml";
    for (args, said) in [
        (&[cup][..], "nothing to compare with"),
        (&[cup, cup], "is there twice"),
        (&[cup, "--also", "tools.die.shoulder=6 mm"], "is there twice"),
        (&[cup, "none.toml"], "none.toml"),
        (&[cup, "none.csv"], "cannot read none.csv"),
        (&["late.csv"], "no case"),
        (&[cup, "bare.csv"], "`travel` must end in a unit"),
        (&[cup, "words.csv"], "line 2, column `punch_force_kN`: \"two\" is not a number"),
        (&[cup, "other.csv"], "no curve of a run among the columns time_s, temperature_C"),
        (&[cup, "one.csv"], "fewer than two points"),
        (&[cup, "late.csv"], "begins at 900 mm and the runs end at 5 mm"),
        (&[cup, "swapped.csv"], "is no force over travel"),
        (&[cup, "line.csv"], "its forces are in N/mm, those of the runs in N"),
        (&[cup, "--also", "friction"], "gives no key a value"),
        (&[cup, "--also", "tools.dye.friction=0.1"], "dye"),
        (&[cup, strip], "no force in common"),
    ] {
        let done = stampflow(dir.path(), &[&["compare"], args, &["--out", "c"]].concat());
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}", text(&done.stderr));
        let told = text(&done.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(told.contains(said), "{args:?}: {told}");
        assert!(!dir.path().join("c").exists(), "{args:?}");
    }
}

/// Trust: the section's heading, its picture and the mark of the other run in each kind of file.
#[test]
fn a_report_has_the_runs_that_it_is_held_against() {
    let dir = folder(CUP);
    let report = |file: &str| {
        let args = ["report", "cases/cup.toml", "--also", "friction=0.2", "--quiet", "-o", file];
        let done = stampflow(dir.path(), &args);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        fs::read(dir.path().join(file)).unwrap()
    };
    for file in ["r.html"] {
        let told = report(file);
        for part in ["Compared", "B: friction 0.2", "Difference to A", "thickness over the blank"] {
            assert!(text(&told).contains(part), "{file}: {part}");
        }
    }
}
