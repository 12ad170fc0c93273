//! Fits: perfect data give their parameters back, noisy data within their standard errors.

use crate::common::prelude::*;
use stampflow::numerics::least_squares::Ended;
use stampflow::study::fit::{CaseFit, CaseFitRequest, Estimate, LawFits, fit_case, flow_curves, material_text};

/// Laws as they are common for sheet, with the parameters in the order of their estimates.
fn truths() -> [(HardeningKind, Vec<f64>); 4] {
    [
        (HardeningKind::Swift, vec![520.0, 0.22, 0.005]),
        (HardeningKind::Voce, vec![130.0, 320.0, 9.0]),
        (HardeningKind::HockettSherby, vec![120.0, 390.0, 6.0, 0.7]),
        (HardeningKind::Ludwik, vec![150.0, 400.0, 0.5]),
    ]
}

const YOUNG: f64 = 205_000.0;

/// A tension test of a law in engineering stress and strain, elastic line and all, with noise in its stress \[MPa\].
fn test_of(law: &Hardening, noise: f64, rng: &mut Rng) -> String {
    let mut text = String::from("engineering_strain_percent,engineering_stress_MPa\n");
    let at_yield = law.at(0.0).stress;
    let mut row = |plastic: f64, stress: f64| {
        let strain = plastic + stress / YOUNG;
        let stress = stress / strain.exp() + noise * normal(rng);
        let _ = writeln!(text, "{},{stress}", 100.0 * strain.exp_m1());
    };
    (1..20).for_each(|i| row(0.0, at_yield * f64::from(i) / 20.0));
    (0..70).for_each(|i| {
        let plastic = 0.0005 + 0.18 * (f64::from(i) / 70.0).powi(2);
        row(plastic, law.at(plastic).stress);
    });
    text
}

/// By Box and Muller.
fn normal(rng: &mut Rng) -> f64 {
    (-2.0 * (1.0 - rng.f64()).ln()).sqrt() * (2.0 * std::f64::consts::PI * rng.f64()).cos()
}

fn fitted(text: &str, wanted: Option<HardeningKind>, reduction: &Reduction) -> LawFits {
    let curve = FlowCurve::read(text, "test.csv", reduction).unwrap_or_else(|error| panic!("{error}"));
    fit_laws(vec![curve], wanted, &()).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether a value lies within two standard errors.
fn holds(estimate: &Estimate, value: f64) -> bool {
    estimate.error.is_some_and(|error| (value - estimate.value).abs() <= 2.0 * error)
}

/// The law of a case with a text as its `[material]`.
fn loaded(material: &str) -> Case {
    let text = fs::read_to_string("cases/quickstart.toml").expect("a case");
    let (before, rest) = text.split_once("[material.").expect("a material");
    let (_, after) = rest.split_once("[tools").expect("tools");
    case::parse(&format!("{before}{material}\n[tools{after}"), "made.toml", &[])
        .unwrap_or_else(|e| panic!("{e}\n{material}"))
}

/// Trust: the points are the law's own; 1e-4 is what is asked for. What is to be pasted is a case, and the same law.
#[test]
fn perfect_tests_give_the_numbers_of_each_law_back() {
    for (kind, truth) in truths() {
        let law = kind.law(&truth).expect("a law");
        let fits = fitted(&test_of(&law, 0.0, &mut Rng::with_seed(1)), None, &Reduction::default());
        assert_eq!(fits.best().kind, kind);
        let best = fits.best();
        for (estimate, truth) in best.estimates.iter().zip(&truth) {
            assert!((estimate.value / truth - 1.0).abs() < 1e-4, "{kind:?}: {estimate:?} {truth}");
        }
        let case = loaded(&material_text(&fits, best));
        let read = &case.model().material.hardening;
        for strain in [0.0, 0.01, 0.1, 0.5] {
            let (found, expected) = (read.at(strain).stress, law.at(strain).stress);
            assert!((found / expected - 1.0).abs() < 1e-4, "{kind:?} at {strain}: {found} {expected}");
        }
        let young = fits.tests[0].young.expect("an elastic line");
        assert!((young / YOUNG - 1.0).abs() < 1e-3, "{young}");
    }
}

/// Trust: 100 tests of each law with a noise of 1 MPa; two standard errors hold the truth in 95 of 100 were the laws linear.
#[test]
fn noisy_tests_give_the_numbers_within_their_intervals_as_often_as_these_say() {
    let mut rng = Rng::with_seed(18);
    let (mut all, mut held_in_all) = (0, 0);
    for (kind, truth) in truths() {
        let law = kind.law(&truth).expect("a law");
        let mut held = vec![0; truth.len()];
        for _ in 0..100 {
            let reduction = Reduction { young: Some(YOUNG), ..Reduction::default() };
            let fits = fitted(&test_of(&law, 1.0, &mut rng), Some(kind), &reduction);
            for ((estimate, truth), held) in fits.best().estimates.iter().zip(&truth).zip(&mut held) {
                *held += usize::from(holds(estimate, *truth));
            }
        }
        assert!(held.iter().all(|held| *held >= 80), "{kind:?}: {held:?}");
        all += 100 * truth.len();
        held_in_all += held.iter().sum::<usize>();
    }
    let share = held_in_all as f64 / all as f64;
    assert!((share - 0.95).abs() < 0.05, "{share}");
}

/// Trust: the law that made the rows, to two standard errors, and its 140.1 MPa at 0.2 %; the law's force never falls.
#[test]
fn a_long_noisy_test_gives_its_numbers_by_all_rows_and_by_every_hundredth() {
    let (kind, truth) = truths()[2].clone();
    let (law, mut rng) = (kind.law(&truth).expect("a law"), Rng::with_seed(7));
    for step in [1, 100] {
        let mut text = String::from("plastic_strain,true_stress_MPa\n");
        for strain in (0..100_000).step_by(step).map(|i| 0.0015 + 1.8e-6 * f64::from(i)) {
            let _ = writeln!(text, "{strain},{}", law.at(strain).stress + normal(&mut rng));
        }
        let fits = fitted(&text, None, &Reduction::default());
        let (best, sentence) = (fits.best(), &fits.tests[0].sentence);
        assert!(best.kind == kind && best.estimates.iter().zip(&truth).all(|(e, x)| holds(e, *x)), "{best:?}");
        assert!(step > 1 || sentence.contains("yield stress 140 MPa; the force does not fall"), "{sentence}");
        assert!(fit_laws(fits.tests, None, &crate::study::After(0.into(), 3)).is_err());
    }
}

/// Trust: two tests of one law, the second at a thousand times the rate and 1000^0.02 times as strong.
#[test]
fn tests_at_two_rates_give_the_exponent_back() {
    let (_, truth) = &truths()[0];
    let exponent: f64 = 0.02;
    let faster = vec![truth[0] * 1000f64.powf(exponent), truth[1], truth[2]];
    let curves = [(truth, 1e-3), (&faster, 1.0)].map(|(parameters, rate)| {
        let text = test_of(&HardeningKind::Swift.law(parameters).expect("a law"), 0.0, &mut Rng::with_seed(1));
        FlowCurve { rate: Some(rate), ..FlowCurve::read(&text, "test.csv", &Reduction::default()).expect("a curve") }
    });
    let fits = fit_laws(curves.to_vec(), Some(HardeningKind::Swift), &()).expect("a fit");
    let found = fits.best().estimate("rate.exponent").expect("an exponent").value;
    assert!((found / exponent - 1.0).abs() < 1e-4, "{found}");
    let case = loaded(&material_text(&fits, fits.best()));
    let rate = case.model().material.rate.expect("a rate law");
    assert!((rate.at(1.0).value / 1000f64.powf(exponent) - 1.0).abs() < 1e-4);
}

/// Trust: by hand: across, −r/(1 + r) of the strain along; the mean of 1.5, 1.2, 1.2 and 1.8 is 1.425 and Δr = (1.5 − 2.4 + 1.8)/2.
#[test]
fn tests_in_three_directions_give_r_values_and_stress_ratios() {
    let of = |angle: f64, r: f64, by: f64| {
        let mut text = String::from("plastic_strain,true_stress_MPa,true_width_strain\n");
        for i in 1..40 {
            let strain = 0.005 * f64::from(i);
            let _ = writeln!(text, "{strain},{},{}", by * 500.0 * (0.004 + strain).powf(0.2), -r / (1.0 + r) * strain);
        }
        let curve = FlowCurve::read(&text, "test.csv", &Reduction::default()).expect("a curve");
        FlowCurve { direction: Some(angle), ..curve }
    };
    let tests = vec![of(90.0, 1.8, 0.98), of(0.0, 1.5, 1.0), of(45.0, 1.2, 1.03)];
    let fits = fit_laws(tests, Some(HardeningKind::Swift), &()).expect("a fit");
    let [r0, r45, r90] = fits.r_values().expect("three directions");
    assert!([r0 - 1.5, r45 - 1.2, r90 - 1.8].iter().all(|miss| miss.abs() < 1e-6));
    let ratios: Vec<f64> = fits.directions.iter().map(|direction| direction.ratio).collect();
    assert!(ratios.iter().zip([1.0, 1.03, 0.98]).all(|(found, truth)| (found - truth).abs() < 1e-5), "{ratios:?}");
    let case = loaded(&material_text(&fits, fits.best()));
    assert!((case.r_values.expect("r-values").mean() - 1.425).abs() < 1e-3);
}

/// Trust: Considère: K (ε₀ + ε)^n has its largest force where ε₀ + ε = n; what lies beyond is left out, and no other law is.
#[test]
fn a_test_is_cut_where_its_force_is_largest() {
    let mut text = String::from("true_strain,true_stress_MPa\n");
    for i in 1..200 {
        let strain = 0.002 * f64::from(i);
        let _ = writeln!(text, "{strain},{}", 500.0 * (0.01 + strain).powf(0.2));
    }
    let reduction = Reduction { young: Some(1e9), ..Reduction::default() };
    let curve = FlowCurve::read(&text, "test.csv", &reduction).expect("a curve");
    // Trust: to half a row.
    let uniform = curve.uniform.expect("a largest force");
    assert!((uniform - 0.19).abs() <= 0.0011 && curve.end() <= uniform + 1e-9, "{uniform}");
}

/// Trust: the same numbers as the library has, which another program's least squares without weights gave; the standard
/// deviations are those of 8 specimens.
#[test]
fn the_measured_curve_of_304l_gives_the_laws_of_the_library_within_their_intervals() {
    let text = include_str!("../../reference_data/aisi304l_bar_flow_curve.csv");
    let fits = fitted(text, None, &Reduction::default());
    let best = fits.best();
    assert_eq!(best.kind, HardeningKind::Ludwik);
    for (key, truth) in [("initial", 225.1), ("k", 1235.0), ("n", 0.7286)] {
        let estimate = best.estimate(key).expect("a number");
        assert!(holds(estimate, truth), "{estimate:?}");
    }
    assert!(best.rms < 4.0);
}

const CASE: &str = "cases/quickstart.toml";

fn base() -> BaseCase {
    BaseCase::load(CASE, owned(&["blank.elements=24", "solver.max_step=0.06"])).expect("a case")
}

/// The load over the travel of the case as it stands, 24 points, each times 1 + noise.
fn curve_of(dir: &TempDir, noise: f64, rng: &mut Rng) -> PathBuf {
    let run = BaseCase::solve(base().case(&[]).expect("a case"), &()).expect("a solution").stages.remove(0);
    let mut text = String::from("travel_mm,punch_force_kN\n");
    for step in run.steps.iter().step_by((run.steps.len() / 24).max(1)) {
        let force = step.punch_force + noise * peak(&run) * normal(rng);
        let _ = writeln!(text, "{},{}", step.travel, 1e-3 * force);
    }
    let path = dir.path().join("curve.csv");
    fs::write(&path, text).expect("written");
    path
}

fn fit_to(path: &Path, texts: &[&str], watch: &dyn Watch) -> CaseFit {
    let request = CaseFitRequest::new(base(), &owned(texts), &[path.to_owned()]);
    fit_case(&request.unwrap_or_else(|error| panic!("{error}")), 2, watch).unwrap_or_else(|error| panic!("{error}"))
}

const KEYS: [&str; 2] = ["friction=0.12 in 0.01..0.3", "material.hardening.swift.k=480 in 300..800 MPa"];
const TRUTH: [f64; 2] = [0.08, 520.0];

/// Trust: the program's own curve, whose case has these numbers; 1e-4 is what is asked for.
#[test]
fn a_curve_of_the_programs_own_gives_its_keys_back() {
    let dir = TempDir::new().expect("a folder");
    let fit = fit_to(&curve_of(&dir, 0.0, &mut Rng::with_seed(1)), &KEYS, &());
    for (estimate, truth) in fit.estimates.iter().zip(TRUTH) {
        assert!((estimate.value / truth - 1.0).abs() < 1e-4, "{estimate:?}");
    }
    assert_eq!(fit.ended, Ended::Found);
    let case = case::parse(&fit.text, CASE, &[]).expect("the fitted case");
    assert!((case.model().material.hardening.at(1.0).stress / 520.0 - 1.0).abs() < 2e-2);
}

/// Trust: the start misses the curve by more than what was found when it was ended in the middle.
#[test]
fn a_fit_that_is_ended_keeps_the_best_so_far() {
    let dir = TempDir::new().expect("a folder");
    let path = curve_of(&dir, 0.01, &mut Rng::with_seed(3));
    let fit = fit_to(&path, &KEYS, &crate::study::After(0.into(), 18));
    assert_eq!(fit.ended, Ended::Stopped);
    assert!(fit.rms[1] < fit.rms[0], "{:?}", fit.rms);
}

/// Trust: the benchmark's own numbers are k = 589 MPa and no friction; its travels are read from graphs to 5 %.
#[test]
fn the_osu_curve_gives_its_own_friction_and_strength_back() {
    let study = Path::new("cases/studies/osu_fit.toml");
    let request = CaseFitRequest::load(study, Vec::new(), &[], &[]).expect("a case with its curve");
    let fit = fit_case(&request, 2, &()).expect("a fit");
    for (estimate, truth) in fit.estimates.iter().zip([0.0, 589.0]) {
        assert!(holds(estimate, truth) || estimate.bound == Some(truth), "{estimate:?}");
    }
    let k = &fit.estimates[1];
    assert!((k.value / 589.0 - 1.0).abs() < 0.05, "{k:?}");
}

/// Trust: the law that the files were written of, rounded as testing machines round; 20 mm² and 80 mm are the specimen's.
#[test]
fn exports_of_testing_machines_are_read_in_three_languages() {
    let reduction = Reduction { section: Some(20.0), gauge: Some(80.0), ..Reduction::default() };
    for (name, reduction) in [("german", reduction), ("french", Reduction::default()), ("english", reduction)] {
        let path = PathBuf::from(format!("tests/foreign/tension/{name}.csv"));
        let curves = flow_curves(&[path], &reduction, &[], &[], &()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let fits = fit_laws(curves, Some(HardeningKind::Swift), &()).unwrap_or_else(|error| panic!("{name}: {error}"));
        for (estimate, truth) in fits.best().estimates.iter().zip([520.0, 0.22, 0.005]) {
            assert!((estimate.value / truth - 1.0).abs() < 0.02, "{name}: {} {truth}", estimate.value);
        }
    }
    let error = FlowCurve::read("Kraft;Weg\n1,0;0,1\n2,0;0,2\n", "test.csv", &reduction).expect_err("unit").to_string();
    assert!(error.contains("must end in a unit"), "{error}");
}
