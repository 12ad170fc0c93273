//! Parts whose outcome on the press is known, against the program's lights; `UPDATE=1` writes the page's two tables anew.

use crate::common::prelude::*;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/reference_data/known_outcomes");
const TABLE: &str = include_str!("../../reference_data/known_outcomes.csv");
const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/known_outcomes.md");
/// Outcomes on the press, then the light that none of them asks for.
const OUTCOMES: [&str; 6] = ["whole", "torn", "wrinkled", "ironed", "sprung back", "refused otherwise"];

/// Rows of the table: file, outcome on the press, grade, source, name, and the reason of a miss.
fn parts() -> Vec<[&'static str; 6]> {
    let rows = TABLE.lines().skip(1).map(|row| row.split(',').collect::<Vec<_>>());
    rows.map(|row| row.try_into().expect("six cells")).collect()
}

fn outcome_by_the_lights(file: &str, outcome: &str) -> &'static str {
    let case = loaded(format!("{FOLDER}/{file}.toml"), &[]);
    let stages = solver::solve(&case.stages, &mut ());
    let findings = assess::after(&case, &stages);
    let ironed = findings.iter().any(|finding| finding.key == "ironing" && finding.value() > Some(1.0));
    match FailureMode::all(&stages, &findings).first() {
        Some(FailureMode::Tears) => "torn",
        Some(FailureMode::Wrinkles) => "wrinkled",
        Some(_) => "refused otherwise",
        None if outcome == "ironed" && ironed => "ironed",
        None if outcome == "sprung back" => "sprung back",
        None => "whole",
    }
}

/// Trust: the sources that the table names; the page tells which inputs were set right after a first run.
#[test]
fn nine_of_ten_known_outcomes_are_those_of_the_lights() {
    let parts = parts();
    let found: Vec<&str> = std::thread::scope(|scope| {
        let runs: Vec<_> = parts.iter().map(|part| scope.spawn(|| outcome_by_the_lights(part[0], part[1]))).collect();
        runs.into_iter().map(|run| run.join().expect("a run")).collect()
    });
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut misses = String::from("| part | on the press | by the lights | grade | why |\n|---|---|---|---|---|\n");
    let (mut right, mut unexplained) = (0, Vec::new());
    for ([file, outcome, grade, _, name, reason], light) in parts.iter().zip(&found) {
        *counts.entry((outcome, light)).or_default() += 1;
        if outcome == light {
            right += 1;
            continue;
        }
        if reason.is_empty() {
            unexplained.push(format!("{file}: {outcome} on the press, {light} by the lights"));
        }
        writeln!(misses, "| {name} | {outcome} | {light} | {grade} | {reason} |").expect("a string");
    }
    let mut matrix = format!("| on the press | {} |\n|---|{}\n", OUTCOMES.join(" | "), "---|".repeat(OUTCOMES.len()));
    for outcome in &OUTCOMES[..5] {
        let row = OUTCOMES.map(|light| counts.get(&(*outcome, light)).map_or("·".into(), usize::to_string));
        writeln!(matrix, "| {outcome} | {} |", row.join(" | ")).expect("a string");
    }
    let share = 100.0 * right as f64 / parts.len() as f64;
    write!(matrix, "\n{right} of {} are right, {share:.0} %.\n", parts.len()).expect("a string");
    let page = std::fs::read_to_string(PAGE).expect("readable");
    let anew = [("matrix", matrix), ("misses", misses)].iter().fold(page.clone(), |page, (name, table)| {
        let (before, rest) = page.split_once(&format!("<!-- {name} -->\n")).expect(name);
        let (_, after) = rest.split_once("<!-- end -->").expect("an end");
        format!("{before}<!-- {name} -->\n{table}<!-- end -->{after}")
    });
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(PAGE, &anew).expect("writable");
    } else {
        assert_eq!(page, anew, "UPDATE=1 where that is meant");
    }
    let list = unexplained.join("\n");
    assert!(share >= 90.0 && list.is_empty(), "{share:.0} % right; without a reason:\n{list}");
}

/// Trust: the files themselves.
#[test]
fn every_known_outcome_has_its_case_and_its_grade() {
    let parts = parts();
    let cases = files(FOLDER, "toml");
    let names: BTreeSet<&str> = cases.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, parts.iter().map(|part| part[0]).collect());
    for [file, outcome, grade, source, ..] in &parts {
        let text = std::fs::read_to_string(format!("{FOLDER}/{file}.toml")).expect("readable");
        assert!(text.contains(&format!("# Source: {source}. Grade {grade}.\n")), "{file}");
        assert!(OUTCOMES[..5].contains(outcome) && ["A", "B", "C"].contains(grade), "{file}: {outcome} {grade}");
        assert_eq!(*grade == "C", source.starts_with("declared: "), "{file}: an assumption says so");
    }
    let assumed = parts.iter().filter(|part| part[2] == "C").count();
    assert!(parts.len() >= 30 && 3 * assumed <= parts.len(), "{assumed} of {} are assumptions", parts.len());
}
