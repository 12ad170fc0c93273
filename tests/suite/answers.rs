//! What a designer reads: one screen that answers, within 80 columns.

use crate::common::cli::{COMPARE, CUP, STAGES, folder, stampflow, text};
use std::fs;
use std::path::Path;

/// A hemispherical cup of AA6016 that tears: deeper than the sheet stretches.
fn torn(dir: &Path) {
    let new = "new hemispherical-cup --material aa6016 --friction 0.15 --height 52mm -o torn.toml";
    let made = stampflow(dir, &new.split(' ').collect::<Vec<_>>());
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
}

fn fits(told: &str) {
    // Accents of their own stand over the letter before them.
    let width = |line: &&str| line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count();
    let wide: Vec<&str> = told.lines().filter(|line| width(line) > 80).collect();
    assert!(wide.is_empty(), "wider than 80 columns: {wide:#?}");
}

/// Trust: Hill and Swift by this sheet's law, which the case holds; the limit is passed at the dome.
#[test]
fn a_torn_cup_is_red_at_once_and_strict_runs_end_with_4() {
    let dir = folder(CUP);
    torn(dir.path());
    let run = stampflow(dir.path(), &["run", "torn.toml", "-q"]);
    let told = text(&run.stdout);
    let first = told.lines().take(5).collect::<Vec<_>>().join(" ");
    assert!(first.contains("RED") && first.contains("tears"), "{told}");
    assert!(told.contains("→ change") && told.lines().count() < 60, "one screen: {told}");
    fits(told);
    let strict = stampflow(dir.path(), &["run", "torn.toml", "-q", "--strict"]);
    assert_eq!(strict.status.code(), Some(4), "{}", text(&strict.stderr));
    assert!(dir.path().join("out/torn/summary.json").is_file(), "results are kept");
    let checked = stampflow(dir.path(), &["check", "torn.toml", "--run", "-q", "--strict"]);
    assert_eq!(checked.status.code(), Some(4));
    fits(text(&checked.stdout));
}

#[test]
fn a_sound_cup_has_its_sentence_and_its_numbers() {
    let dir = folder(CUP);
    let run = stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let told = text(&run.stdout);
    for says in
        ["does not tear", "Thinnest", "Punch force", "Holder", "Blank", "Height", "Draw-in", "a press of at least"]
    {
        assert!(told.contains(says), "{says}: {told}");
    }
    assert!(!told.contains("Iterations"), "the solver's part is for --verbose: {told}");
    let verbose = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--verbose"]);
    assert!(text(&verbose.stdout).contains("Iterations"));
    fits(text(&verbose.stdout));
}

#[test]
fn several_cases_are_told_in_one_line_each() {
    let dir = folder(CUP);
    fs::copy(dir.path().join("cases/cup.toml"), dir.path().join("cases/bowl.toml")).unwrap();
    let run = stampflow(dir.path(), &["run", "cases/cup.toml", "cases/bowl.toml", "-q"]);
    let told = text(&run.stdout);
    assert!(told.lines().count() <= 4 && told.starts_with("cup: ") && told.contains("\nbowl: "), "{told}");
}

/// A report is of the numbers beside it, or gone; what someone else calls report.html stays.
#[test]
fn one_run_writes_the_report_and_the_next_does_not_leave_it_behind() {
    let dir = folder(CUP);
    let page = dir.path().join("out/cup/report.html");
    let run = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--report"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    assert!(fs::read_to_string(&page).unwrap().contains("stampflow report, version"));
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    assert!(!page.exists(), "it was of the numbers before");
    fs::write(&page, "mine").unwrap();
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    assert_eq!(fs::read_to_string(&page).unwrap(), "mine");
    let refused = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--report"]);
    assert!(refused.status.code() == Some(2) && text(&refused.stderr).contains("no report of ours"));
    assert_eq!(fs::read_to_string(&page).unwrap(), "mine");
}

#[test]
fn programs_get_numbers_units_and_limits() {
    let dir = folder(CUP);
    for args in [&["run", "cases/cup.toml", "--json"][..], &["check", "cases/cup.toml", "--run", "--json"]] {
        let done = stampflow(dir.path(), args);
        let value: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        let verdict = &value["verdict"];
        assert!(verdict["light"].is_string() && verdict["sentence"].is_string(), "{verdict}");
        let number =
            |key: &str| verdict["numbers"].as_array().unwrap().iter().find(|n| n["key"] == key).unwrap().clone();
        assert!(number("thinnest")["value"].as_f64().is_some_and(|t| t < 1.0) && number("thinnest")["unit"] == "mm");
        assert_eq!(number("punch_force")["unit"], "N");
        let thinning = verdict["findings"].as_array().unwrap().iter().find(|f| f["key"] == "thinning").unwrap();
        assert_eq!(thinning["unit"], "percent");
        assert_eq!(thinning["limits"]["amber"].as_f64(), Some(20.0));
        assert_eq!(thinning["limits"]["sense"], "at_most");
    }
}

/// Trust: the angle of the long table.
#[test]
fn a_bend_is_known_by_its_angle() {
    let dir = folder(CUP);
    let made = stampflow(dir.path(), &["new", "v-bend", "-o", "v.toml"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let value: serde_json::Value =
        serde_json::from_slice(&stampflow(dir.path(), &["run", "v.toml", "--json"]).stdout).unwrap();
    let numbers = value["verdict"]["numbers"].as_array().unwrap();
    let angle = numbers.iter().find(|number| number["key"] == "opening_angle").expect("an angle");
    let changes = value["stages"][1]["springback"].as_array().unwrap();
    let change = changes.iter().find(|change| change["key"] == "opening_angle").unwrap();
    assert!(angle["value"] == change["after"] && angle["unit"] == "deg", "{angle} {change}");
    let told = stampflow(dir.path(), &["run", "v.toml", "-q"]);
    let told = text(&told.stdout);
    assert!(told.contains("Opening angle") && told.contains("under load"), "{told}");
    let us = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--units", "us"]);
    let us = text(&us.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    let press = us.split("a press of at least ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a rating");
    let digits = press.replace('.', "").trim_matches('0').len();
    assert!((1..=2).contains(&digits) && us.contains("(1.2 times the load)"), "{press}: {us}");
}

/// Trust: what --json prints of the same run; of several stages each folder has it.
#[test]
fn the_summary_carries_the_verdict() {
    for (case, files) in [
        (CUP.to_owned(), &["summary.json"][..]),
        (CUP.to_owned() + STAGES, &["1-draw/summary.json", "2-retract/summary.json"]),
    ] {
        let dir = folder(&case);
        let done = stampflow(dir.path(), &["run", "cases/cup.toml", "--json"]);
        let printed: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        for file in files {
            let written = fs::read_to_string(dir.path().join("out/cup").join(file)).unwrap();
            let written: serde_json::Value = serde_json::from_str(&written).unwrap();
            assert!(written["verdict"]["sentence"].is_string() && written["program"].is_string(), "{written}");
            assert_eq!(written["verdict"], printed["verdict"], "{file}");
        }
    }
}

#[test]
fn every_verb_keeps_to_80_columns() {
    let dir = folder(&format!("{CUP}{COMPARE}"));
    fs::write(dir.path().join("cases/curve.csv"), "travel_mm,punch_force_kN\n1,5\n4,16\n").unwrap();
    fs::write(
        dir.path().join("cases/sources.toml"),
        "[\"curve.csv\"]\ncitation = \"a test\"\nkind = \"benchmark\"\ngrade = \"C\"\n",
    )
    .unwrap();
    let verbs = ["run", "check", "verify", "report", "new", "import", "compare", "materials", "schema", "man"];
    for verb in verbs {
        fits(text(&stampflow(dir.path(), &[verb, "--help"]).stdout));
    }
    fits(text(&stampflow(dir.path(), &["--help"]).stdout));
    for args in [
        &["materials"][..],
        &["new", "--list"],
        &["new", "cup", "--help"],
        &["check", "cases/cup.toml"],
        &["verify", "cases/cup.toml", "-q"],
    ] {
        let done = stampflow(dir.path(), args);
        assert!(!done.stdout.is_empty(), "{args:?}: {}", text(&done.stderr));
        fits(text(&done.stdout));
    }
}

#[test]
fn the_answer_is_in_us_units() {
    let dir = folder(CUP);
    let us = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--units", "US"]);
    let us = text(&us.stdout);
    assert!(us.contains(" in ") && us.contains("US tonf") && !us.contains(" kN"), "{us}");
}
