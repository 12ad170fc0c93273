//! `scatter`: samples, what is estimated from them and how sure that is, and the verb.

use crate::common::cli::{CUP, folder, stampflow, text};
use stampflow::case::library;
use stampflow::study::scatter::{Asked, Correlation, Distribution, REPLICATES, Sampling, Scatter, Tries};
use stampflow::study::scatter::{indices, probability};
use stampflow::study::{Designs, StudyError, Subject};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;

const CASE: &str = "cases/quickstart.toml";

/// Values of a function at every row of a sample.
fn values(sampling: &Sampling, f: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    (0..sampling.rows()).map(|row| f(&sampling.unit(row))).collect()
}

/// Ishigami's function with a = 7 and b = 0.1, of coordinates from 0 to 1.
fn ishigami(u: &[f64]) -> f64 {
    let [x, y, z] = [u[0], u[1], u[2]].map(|u| PI * (2.0 * u - 1.0));
    x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
}

/// Trust: the closed form of T. Ishigami, T. Homma (1990): V₁ = ½ (1 + b π⁴/5)², V₂ = a²/8, V₁₃ = 8 b² π⁸/225. 0.02 is what is
/// asked of 65 536 points. Of 240 intervals from fewer points, each with a chance of 5 % to miss, more than 30 miss in one of
/// ten thousand such tests.
#[test]
fn the_indices_of_ishigamis_function_are_its_closed_form() {
    let (a, b): (f64, f64) = (7.0, 0.1);
    let (v1, v2, v13) = (0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2), a * a / 8.0, 8.0 * b * b * PI.powi(8) / 225.0);
    let all = v1 + v2 + v13;
    let truth = [(v1 / all, (v1 + v13) / all), (v2 / all, v2 / all), (0.0, v13 / all)];
    let of = |seed: u32, points: u64| {
        let sampling = Sampling::new(seed, points, vec![0, 1, 2], true);
        let found = indices(&sampling, &values(&sampling, ishigami)).expect("it varies");
        let pairs = found.into_iter().zip(truth);
        pairs.flat_map(|(index, (first, total))| [(index.first, first), (index.total, total)]).collect::<Vec<_>>()
    };
    for (estimate, truth) in (0..3).flat_map(|seed| of(seed, 1 << 16)) {
        assert!((estimate.value - truth).abs() < 0.02, "{estimate:?}, not {truth}");
    }
    let missed = (0..40)
        .flat_map(|seed| of(seed, 1024))
        .filter(|(estimate, truth)| !(estimate.low..=estimate.high).contains(truth));
    let missed = missed.count();
    assert!((1..=30).contains(&missed), "{missed} of 240");
}

/// Hits of an event by scramblings.
fn tries(sampling: &Sampling, is_hit: impl Fn(&[f64]) -> bool) -> [Tries; REPLICATES] {
    let mut tries = [(0, 0); REPLICATES];
    for row in 0..sampling.rows() {
        let own = &mut tries[sampling.place(row).replicate];
        *own = (own.0 + u64::from(is_hit(&sampling.unit(row))), own.1 + 1);
    }
    tries
}

/// Trust: areas and volumes by hand: a slice, a corner, a quarter of a circle, and a sum of four; the last event is as good as
/// of independent points, for the sequence has no structure as fine. Of 200 studies with intervals of 95 % fewer than 92 % is
/// less likely than 3 in 100 for each.
#[test]
fn intervals_of_a_probability_hold_it_in_95_of_100_studies() {
    type Event = (&'static str, f64, fn(&[f64]) -> bool);
    let events: [Event; 5] = [
        ("slice", 0.032, |u| u[0] < 0.032),
        ("corner", 0.031_25, |u| u[0] + u[1] < 0.25),
        ("circle", PI / 4.0, |u| u[0] * u[0] + u[1] * u[1] < 1.0),
        ("sum of four", 1.0 / 24.0, |u| u.iter().sum::<f64>() < 1.0),
        ("parity", 0.5, |u| u.iter().map(|u| (64.0 * u) as u64).sum::<u64>() % 2 == 0),
    ];
    for (name, truth, is_hit) in events {
        let held = (0..200).filter(|seed| {
            let sampling = Sampling::new(*seed, 1024, vec![0, 1, 2, 3], false);
            let found = probability(&tries(&sampling, is_hit)).expect("tries");
            (found.low..=found.high).contains(&truth)
        });
        let share = held.count() as f64 / 200.0;
        assert!(share >= 0.92, "{name}: {share}");
    }
}

fn scatter(vary: &[(&str, &str)], correlate: &[&str]) -> Result<Scatter, StudyError> {
    let vary = vary.iter().map(|(key, scatter)| ((*key).to_owned(), (*scatter).to_owned())).collect();
    let correlations = correlate.iter().map(|text| Correlation::read(text)).collect::<Result<_, _>>()?;
    Scatter::new(Subject::new(CASE, Vec::new())?, Asked { vary, correlations, ..Asked::default() })
}

const K: &str = "material.hardening.swift.k";
const N: &str = "material.hardening.swift.n";

/// Trust: of two normal distributions the coefficient of the copula is Pearson's; 1024 points leave less than 0.01 of it.
#[test]
fn k_and_n_of_a_coil_go_together_as_they_are_asked_to() {
    let pair = format!("{K},{N}=-0.8");
    let scatter = scatter(&[(K, "normal ± 5 %"), (N, "normal 0.22 ± 0.01"), ("friction", "uniform ± 0.02")], &[&pair]);
    let scatter = scatter.expect("a scatter");
    let column = |i: usize| -> Vec<f64> {
        (0..scatter.count()).map(|row| scatter.design(row).values[i].number.expect("a number")).collect()
    };
    let [k, n, friction] = [0, 1, 2].map(column);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let product = |a: &[f64], b: &[f64]| {
        let (of_a, of_b) = (mean(a), mean(b));
        a.iter().zip(b).map(|(a, b)| (a - of_a) * (b - of_b)).sum::<f64>() / a.len() as f64
    };
    let correlation = |a: &[f64], b: &[f64]| product(a, b) / (product(a, a) * product(b, b)).sqrt();
    assert!((correlation(&k, &n) + 0.8).abs() < 0.01, "{}", correlation(&k, &n));
    assert!(correlation(&k, &friction).abs() < 0.02);
    assert!((mean(&k) - 520.0).abs() < 0.5 && (product(&k, &k).sqrt() - 26.0).abs() < 0.3);
    assert_eq!(scatter.groups(), [format!("{K} & {N}"), "friction".into()]);
    assert_eq!(scatter.design(7), scatter.design(7));
}

/// Trust: 2 % of the case's own thickness of 1 mm, and a strength that multiplies k = 520 MPa.
#[test]
fn what_is_relative_is_of_the_cases_own_value() {
    let scatter =
        scatter(&[("blank.thickness", "normal ± 2 %"), ("strength", "uniform 0.9..1.1")], &[]).expect("a scatter");
    let wanted = Distribution::Normal { mean: 1.0, deviation: 0.02, limits: None };
    assert_eq!(scatter.factors()[0].distribution, wanted);
    assert_eq!(scatter.headers(), ["blank.thickness_mm", "strength"]);
    let design = scatter.design(3);
    let factor = design.values[1].number.expect("a number");
    let case = scatter.subject().case(&design.settings).expect("a case");
    let own = scatter.subject().case(&[]).expect("a case");
    let [scaled, own] = [case, own].map(|case| case.model().material.hardening.at(0.1).stress);
    assert!((scaled / own - factor).abs() < 1e-9, "{scaled} of {own}, not {factor}");
}

/// Trust: each is wrong as its message says.
#[test]
fn what_cannot_scatter_is_told_before_anything_is_run() {
    for (vary, correlate, said) in [
        (("friction", "lognormal 0.08"), &[][..], "is no distribution"),
        (("blank.thickness", "normal 1 ± 0.02"), &[], "needs a unit"),
        (("blank.thicknes", "uniform 0.9..1.1 mm"), &[], "thicknes"),
        (("blank.thicknes", "normal ± 2 %"), &[], "the case writes no blank.thicknes"),
        (("friction", "normal 0.08 ± -0.01"), &[], "more than 0 is wanted"),
        (("friction", "uniform 0.1..0.05"), &[], "no width"),
        (("friction", "uniform 0.05..0.12"), &["friction,strength=0.5"], "strength is correlated and does not scatter"),
        (("friction", "uniform 0.05..0.12"), &["friction,strength=1.5"], "is 1.5"),
    ] {
        let error = scatter(&[vary], correlate).expect_err(said).to_string();
        assert!(error.contains(said), "{vary:?}: {error}");
    }
    for (second, said) in [("friction", "friction and friction set the same"), (K, "strength and material")] {
        let first = if second == K { "strength" } else { second };
        let error = scatter(&[(first, "uniform 0.9..1.1"), (second, "normal ± 1 %")], &[]).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    }
}

/// Trust: what the entries and the tables of the standards say; EN 10131 has 0.05 mm for 1 mm, DC04 270 to 350 MPa.
#[test]
fn sheets_of_the_library_scatter_as_their_standard_has_it() {
    let with: Vec<&str> = library::materials()
        .expect("the library")
        .iter()
        .filter(|entry| entry.class.is_some())
        .map(|e| e.name)
        .collect();
    assert_eq!(with, ["aa5754-o", "aa6016-t4", "drawing-steel", "if-steel", "radioss-steel"]);
    for name in with {
        let subject = Subject::new(CASE, vec![format!("material={name:?}")]).expect("a case");
        let scatter = Scatter::new(subject, Asked::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(scatter.headers(), ["friction", "blank.thickness_mm", "strength"], "{name}");
        assert_eq!(scatter.told.len(), 3);
    }
    let subject = Subject::new(CASE, vec!["material=\"DC04\"".into()]).expect("a case");
    let scatter = Scatter::new(subject, Asked::default()).expect("a scatter");
    let Distribution::Normal { limits: Some((low, high)), .. } = scatter.factors()[1].distribution else {
        panic!("{:?}", scatter.factors()[1]);
    };
    assert!((low - 0.95).abs() < 1e-9 && (high - 1.05).abs() < 1e-9);
    // One that the library does not have scatters by its friction alone, and that is told.
    let own = Scatter::new(Subject::new(CASE, Vec::new()).expect("a case"), Asked::default()).expect("a scatter");
    assert_eq!(own.headers(), ["friction"]);
    assert!(own.told.iter().any(|said| said.to_string().contains("none of the library")));
}

fn run(dir: &Path, more: &[&str]) -> String {
    let args =
        ["scatter", "cases/cup.toml", "--vary", "friction=uniform 0.05..0.12", "--vary", "strength=normal ± 5 %"];
    let fixed = ["--runs", "32", "--quiet", "--format", "svg"];
    let out = stampflow(dir, &[&args[..], &fixed[..], more].concat());
    assert!(out.status.success(), "{}", text(&out.stderr));
    text(&out.stdout).to_owned()
}

#[test]
fn a_scatter_is_told_in_words_of_the_shop() {
    let dir = folder(CUP);
    let told = run(dir.path(), &["--out", "out", "--captions", "none"]);
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("of 32 parts tore, though up to") && !told.contains("at most"), "{told}");
    assert!(!told.contains("rank correlation") && told.contains("it rises with strength, closely"), "{told}");
    // A clearance is told in thicknesses, and what is the same in all parts stands in no row.
    let (rows, same) = told.split_once("The same in all parts: ").expect(&told);
    let (same, _) = same.split_once(". ").unwrap_or((same, ""));
    assert!(same.contains("Clearance 1") && same.contains(" t") && !rows.contains("Clearance"), "{told}");
}

/// Trust: what was run in parts, put together and read again is what was run at once, byte for byte.
#[test]
fn shards_put_together_say_what_one_run_says() {
    let dir = folder(CUP);
    let whole = run(dir.path(), &["--out", "whole", "--indices"]);
    for shard in ["1/2", "2/2"] {
        run(dir.path(), &["--out", "parts", "--indices", "--shard", shard]);
    }
    let shards = ["parts/scatter-1-of-2.csv", "parts/scatter-2-of-2.csv"];
    let merged = stampflow(dir.path(), &["merge", shards[0], shards[1], "--out", "parts/scatter.csv"]);
    assert!(merged.status.success(), "{}", text(&merged.stderr));
    let parts = run(dir.path(), &["--out", "parts", "--indices", "--resume"]);
    assert_eq!(whole.replace("whole/", "").split('\n').next(), parts.replace("parts/", "").split('\n').next());
    let tables = ["scatter.csv", "quantiles.csv", "lights.csv", "indices.csv", "bands.csv"];
    for file in tables.into_iter().chain(["scatter.svg", "load_band.svg", "thickness_band.svg", "influence.svg"]) {
        let [a, b] = ["whole", "parts"].map(|folder| fs::read(dir.path().join(folder).join(file)).expect(file));
        assert!(!a.is_empty() && a == b, "{file}");
    }
    // 32 points, their partners, and two between.
    let rows = fs::read_to_string(dir.path().join("whole/scatter.csv")).expect("rows");
    assert_eq!(rows.lines().count(), 1 + 32 * 4);
}

/// Trust: a die whose throat is narrower than its punch of 30 mm is no case: half of the throats here are, and more where the
/// sheet must fit between.
#[test]
fn runs_that_fail_are_counted_and_told() {
    let dir = folder(CUP);
    let vary =
        ["--vary", "tools.die.throat=uniform 27.5..32.5 mm", "--runs", "32", "--quiet", "--json", "--out", "out"];
    let out = stampflow(dir.path(), &[&["scatter", "cases/cup.toml"], &vary[..]].concat());
    assert!(out.status.success(), "{}", text(&out.stderr));
    let told: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    let failed = told["failed"].as_u64().expect("a number");
    assert!((8..=24).contains(&failed), "{failed}");
    let reasons = told["failures"].as_object().expect("reasons");
    assert_eq!(reasons.values().filter_map(serde_json::Value::as_u64).sum::<u64>(), failed);
    let runs = told["numbers"][0]["runs"].as_u64().expect("runs");
    assert_eq!(runs + failed, 32);
    let german =
        stampflow(dir.path(), &[&["scatter", "cases/cup.toml", "--resume", "--lang", "de"], &vary[..5]].concat());
    assert!(german.status.success(), "{}", text(&german.stderr));
}

#[test]
fn a_study_that_is_no_scatter_is_bad_input() {
    let dir = folder(CUP);
    for (study, said) in [
        ("case = \"cases/cup.toml\"\nrun = 5\n", "`run` is no key"),
        ("case = \"cases/cup.toml\"\nruns = \"many\"\n", "`runs` is no whole number"),
        ("case = \"cases/cup.toml\"\n[scatter]\nfriction = 0.1\n", "friction is no text"),
        ("case = \"cases/cup.toml\"\nruns = 8\n", "8 runs say nothing"),
    ] {
        fs::write(dir.path().join("study.toml"), study).expect("written");
        let out = stampflow(dir.path(), &["scatter", "study.toml", "--quiet"]);
        assert_eq!(out.status.code(), Some(2), "{study}");
        assert!(text(&out.stderr).contains(said), "{}", text(&out.stderr));
    }
}

/// Trust: friction below 0 makes no case, whatever its size, and half of these are below 0.
#[test]
fn reasons_that_differ_by_a_number_are_one() {
    let dir = folder(CUP);
    let args = ["scatter", "cases/cup.toml", "--vary", "friction=uniform -0.1..0.1", "--runs", "32", "--quiet"];
    let done = stampflow(dir.path(), &[&args[..], &["--json"]].concat());
    assert!(done.status.success(), "{}", text(&done.stderr));
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
    let reasons = told["failures"].as_object().expect("reasons");
    assert_eq!(reasons.len(), 1, "{reasons:?}");
    assert_eq!(reasons.values().next(), Some(&told["failed"]));
    let done = stampflow(dir.path(), &[&args[..], &["--resume"]].concat());
    assert!(text(&done.stdout).contains("16 such as"), "{}", text(&done.stdout));
}
