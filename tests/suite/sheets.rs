//! The sheets of the library: fits against the points they are of, back-stresses, and every sheet on every template.

use crate::common::prelude::*;
use stampflow::{material::rate::JohnsonCook, solve};

/// Trust: the least squares of its points, Ludwik's of the curve, which `fit` finds again, and Johnson and Cook's of the rates.
#[test]
fn the_laws_of_the_stainless_bar_are_least_squares_of_its_points() {
    let own = library::material("aisi304l-bar").expect("a sheet").material;
    assert_eq!(own.hardening, Hardening::Ludwik(Ludwik::new(225.1, 1235.0, 0.7286).expect("in range")));
    assert_eq!(own.rate, Some(Rate::JohnsonCook(JohnsonCook { coefficient: 0.0214, reference: 0.00315 })));
}

/// Trust: the equations of the source, dX = c dε − κ c |dε| X of the deviator, integrated on their own in tension, where dε is
/// (1, −½, −½) dε̄ and |dε| = √(3/2) dε̄; the stress along the bar is 3/2 of the deviator's. First order in 1e5 steps.
#[test]
fn the_back_stresses_of_aluminium_are_those_of_the_source_in_our_form() {
    let material = library::material("AA5754-O").expect("a sheet").elastoplastic.expect("back-stresses");
    let end = 0.05;
    let step = end / 1e5;
    for (law, (c, kappa)) in material.chaboche.iter().zip([(115.5, 0.0885), (11_500.0, 0.01676)]) {
        let mut deviator = 0.0_f64;
        for _ in 0..100_000 {
            deviator += c * step - kappa * c * 1.5_f64.sqrt() * step * deviator;
        }
        let ours = law.in_tension(end).stress;
        assert!((1.5 * deviator / ours - 1.0).abs() < 1e-3, "{} and {ours}", 1.5 * deviator);
    }
}

/// Trust: in tension the stress is what is left and the back-stresses; the table has ten of its points where the curve bends,
/// its cubics are within 0.3 % of it between them. Below 1 % the source's second back-stress rises faster than its curve.
#[test]
fn tension_of_the_aluminium_is_the_measured_curve_with_back_stresses_and_without() {
    let entry = library::material("aa5754-o").expect("a sheet");
    let shifting = entry.elastoplastic.as_ref().expect("back-stresses");
    let of = |strain: f64| shifting.monotonic(strain, 0.0).stress;
    let curve = |strain: f64| 292.14 - 189.39 * (-13.5 * strain).exp();
    for i in 0..=300 {
        let strain = 0.01 + 0.001 * f64::from(i);
        assert!((entry.material.hardening.at(strain).stress / curve(strain) - 1.0).abs() < 1e-12);
        assert!((of(strain) / curve(strain) - 1.0).abs() < 3e-3, "{strain}: {} {}", of(strain), curve(strain));
    }
    assert!((of(0.002) - 86.4).abs() < 0.5 && curve(0.002) > 107.0, "as its note says: {}", of(0.002));
}

/// Each sheet on every third template in turn.
///
/// Trust: an end is the full travel, or a stop that the sheet has; a mesh of 30 elements is coarse and the ends are the same.
#[test]
fn every_sheet_comes_to_an_end_that_is_told_and_so_does_every_template() {
    for (i, entry) in library::materials().unwrap_or_else(|e| panic!("{}", e.render(false))).iter().enumerate() {
        for template in TEMPLATES.iter().skip(i % 3).step_by(3) {
            let name = format!("{} of {}", template.name, entry.name);
            // A sheet that is let go has its back-stresses.
            let release = template.options().any(|one| one.key == "springback") && entry.material.elastic.is_some();
            let given = [("material", entry.name), ("springback", "1 deg")];
            let text = template.fill(&given[..1 + usize::from(release)]).unwrap_or_else(|e| panic!("{name}: {e}"));
            let case = parsed(&text, &["blank.elements=30"]);
            let solved = solve(&case.stages, &mut ());
            for stage in &solved {
                assert!(stage.stop.is_complete() || stage.stop.is_physical(), "{name}: {}", stage.stop);
            }
            let thinnest = solved[0].steps.last().expect("steps").thinnest;
            assert!(thinnest > 0.0 && thinnest < 1.001 * case.model().blank.thickness, "{name}: {thinnest}");
        }
    }
}

/// Trust: the graded rows that were read, `reference_data/shop_sheets.csv`: each limit of a made sheet stands in one of its source.
#[test]
fn limits_of_a_band_are_those_of_their_sources() {
    let read = std::fs::read_to_string("reference_data/shop_sheets.csv").expect("rows");
    let (mut checked, number) = (0, regex::Regex::new(r"\d+(\.\d+)?").expect("a pattern"));
    for entry in library::materials().expect("sheets").iter().filter(|entry| entry.about.is_made()) {
        let (rows, sources) = entry.about.band.as_ref().expect("a band").rows();
        for row in rows.iter().filter(|row| row[3] == "limit") {
            let place: usize = row[5].parse().expect("a number");
            let name = sources[place - 1].split_once(": ").expect("a number").1.split(" (").next().expect("a name");
            for end in row[1..3].iter().filter_map(|end| number.find(end)) {
                let value = |text: regex::Match| text.as_str().parse::<f64>().expect("digits");
                let has = |line: &str| number.find_iter(line).any(|other| value(other) == value(end));
                let is_there = read.lines().any(|line| line.contains(name) && has(line));
                assert!(is_there, "{}: {} {} of {name}", entry.name, row[0], end.as_str());
                checked += 1;
            }
        }
    }
    assert!(checked > 60, "{checked}");
}

const QUICKSTART: &str = include_str!("../../cases/quickstart.toml");
/// Trust: the band itself: Rm and the uniform strain of the middle, the upper and the lower end; Rp0.2 where Swift's law can have it.
#[test]
fn a_law_made_from_a_band_has_its_strength_and_uniform_strain() {
    for (name, coil, strengths) in
        [("dc04", "", [175.0, 310.0]), ("dc04", "strong", [210.0, 350.0]), ("en-aw-1050", "weak", [24.0, 65.0])]
    {
        let coil = if coil.is_empty() { Vec::new() } else { vec![format!("coil={coil}")] };
        let set = [vec![format!("material={name}")], coil.clone()].concat();
        let case = case::parse(QUICKSTART, "case.toml", &set).unwrap_or_else(|e| panic!("{}", e.render(false)));
        let [_, strength] = case.model().material.load_maximum(1.0, 293.15);
        let proof = case.model().material.hardening.at(0.002).stress;
        assert!((strength - strengths[1]).abs() < 0.01 && (proof - strengths[0]).abs() < 0.5, "{proof} {strength}");
        assert_eq!(case.sources.material.is_some_and(|s| s.contains(" coil ")), !coil.is_empty(), "{name}");
    }
}

/// Trust: the factor itself, on a law with back-stresses and one without.
#[test]
fn strength_scales_the_flow_stress_of_a_sheet() {
    for set in [&["material=dc04"][..], &["material=aa5754-o", "material.mode=elasto_viscoplastic"]] {
        let stress =
            |more: &[&str]| parsed(QUICKSTART, &[set, more].concat()).model().material.monotonic(0.1, 0.0).stress;
        assert!((stress(&["material.strength=1.08"]) / stress(&[]) - 1.08).abs() < 1e-12);
    }
}
