//! The shipped cases as models, and whole runs of them.

use crate::common::prelude::*;
use std::sync::OnceLock;

/// Every shipped case that a punch drives.
pub const DRAWN: &str = "quickstart woo_hemispherical chalmers_cup osu_stretch osu_stretch_friction stretch_thin \
                         strip_draw brite_cylindrical hydroform";

/// The model of a case of `cases/`, with overrides such as `tools.punch.friction=0.1`.
pub fn shipped(name: &str, overrides: &[&str]) -> Model {
    shipped_case(name, overrides).model().clone()
}

/// A case of `cases/`, with overrides.
pub fn shipped_case(name: &str, overrides: &[&str]) -> Case {
    loaded(format!("{}/cases/{name}.toml", env!("CARGO_MANIFEST_DIR")), overrides)
}

pub fn loaded(path: impl AsRef<Path>, overrides: &[&str]) -> Case {
    case::load(path, &owned(overrides)).unwrap_or_else(|e| panic!("{}", e.render(false)))
}

pub fn owned(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| (*text).to_owned()).collect()
}

pub fn findings(solution: &Solution) -> Vec<Finding> {
    assess::after(&solution.case, &solution.stages)
}

pub fn row<'a>(findings: &'a [Finding], key: &str) -> &'a Finding {
    findings.iter().find(|row| row.key == key).unwrap_or_else(|| panic!("no {key}: {findings:?}"))
}

/// A case of `cases/` as it is, solved once for all tests.
pub fn solved(name: &str) -> &'static Solution {
    solved_once(&shipped_case(name, &[]))
}

/// A case without overrides, solved once for all tests that have its text.
pub fn solved_once(case: &Case) -> &'static Solution {
    static SOLVED: Mutex<BTreeMap<String, &OnceLock<Solution>>> = Mutex::new(BTreeMap::new());
    let one = *SOLVED.lock().unwrap().entry(case.text.clone()).or_insert_with(|| Box::leak(Box::default()));
    one.get_or_init(|| case.clone().solve(&mut ()))
}

/// Runs a model that has to reach its full travel.
pub fn solve(model: &Model) -> StageSolution {
    let run = solver::run(model, &mut ());
    assert!(run.stop.is_complete(), "{}: {}", model.title, run.stop);
    run
}

/// Largest punch force [N, or N/mm].
pub fn peak(run: &StageSolution) -> f64 {
    run.steps.iter().map(|r| r.punch_force).fold(0.0, f64::max)
}

pub fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// Rows of a CSV text that are so many numbers.
pub fn numbers<const N: usize>(csv: &str) -> Vec<[f64; N]> {
    let row = |line: &str| line.split(',').map(|cell| cell.parse().ok()).collect::<Option<Vec<f64>>>();
    csv.lines().filter_map(row).map(|row| row.try_into().expect("as many columns")).collect()
}

pub fn last(run: &StageSolution) -> &StepRecord {
    run.steps.last().expect("steps")
}

pub fn parsed(text: &str, overrides: &[&str]) -> Case {
    case::parse(text, "case.toml", &owned(overrides)).unwrap_or_else(|e| panic!("{}", e.render(false)))
}

/// The case of a template with these sizes, with overrides.
pub fn made(template: &str, sizes: &[(&str, &str)], overrides: &[&str]) -> Case {
    let text = stampflow::author::templates::find(template).and_then(|template| template.fill(sizes));
    parsed(&text.unwrap_or_else(|e| panic!("{template} {sizes:?}: {e}")), overrides)
}
