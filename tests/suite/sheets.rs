//! The sheets of the library: fits against the points they are of, back-stresses, and every sheet on every template.

use crate::common::prelude::*;
use stampflow::material::rate::JohnsonCook;
use stampflow::solve;

fn entry(name: &str) -> library::Entry {
    library::material(name).unwrap_or_else(|e| panic!("{name}: {}", e.render(false)))
}

/// Trust: the least squares of its points, Ludwik's of the curve, which `fit` finds again, and Johnson and Cook's of the rates.
#[test]
fn the_laws_of_the_stainless_bar_are_least_squares_of_its_points() {
    let own = entry("aisi304l-bar").material;
    assert_eq!(own.hardening, Hardening::Ludwik(Ludwik::new(225.1, 1235.0, 0.7286).expect("in range")));
    assert_eq!(own.rate, Some(Rate::JohnsonCook(JohnsonCook { coefficient: 0.0214, reference: 0.00315 })));
}

/// Trust: the equations of the source, dX = c dε − κ c |dε| X of the deviator, integrated on their own in tension, where dε is
/// (1, −½, −½) dε̄ and |dε| = √(3/2) dε̄; the stress along the bar is 3/2 of the deviator's. First order in 1e5 steps.
#[test]
fn the_back_stresses_of_aluminium_are_those_of_the_source_in_our_form() {
    let material = entry("AA5754-O").elastoplastic.expect("back-stresses");
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
    let entry = entry("aa5754-o");
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
            let coarse = ["blank.elements=30".to_owned()];
            let case = case::parse(&text, "case.toml", &coarse).unwrap_or_else(|e| panic!("{}", e.render(false)));
            let solved = solve(&case.stages, &mut ());
            for stage in &solved {
                assert!(stage.stop.is_complete() || stage.stop.is_physical(), "{name}: {}", stage.stop);
            }
            let thinnest = solved[0].steps.last().expect("steps").thinnest;
            assert!(thinnest > 0.0 && thinnest < 1.001 * case.model().blank.thickness, "{name}: {thinnest}");
        }
    }
}
