//! Whole runs with Hosford's yield condition: closed forms, Hill's as its limit, and the elastic mode beside the flow mode.

use crate::common::prelude::*;

/// Trust: one metal written twice; both runs stop at 1e-4 of the velocities, whose square is what forces miss.
#[test]
fn a_cup_with_exponent_two_is_hills() {
    for mode in ["flow", "elasto_viscoplastic"] {
        let common = [format!("material.mode=\"{mode}\""), "material.anisotropy=0.6".into()];
        let elastic = ["material.young=\"70 GPa\"", "material.poisson=0.33", "tools.punch.travel=\"8 mm\""];
        let cup = |condition: &str| {
            let condition = format!("material.yield_condition={condition}");
            let overrides: Vec<&str> =
                common.iter().map(String::as_str).chain(elastic).chain([condition.as_str()]).collect();
            run(shipped_case("quickstart", &overrides).model(), &mut ())
        };
        let (hill, hosford) = (cup("\"hill48\""), cup("{ hosford = { exponent = 2 } }"));
        assert_eq!(hill.steps.len(), hosford.steps.len(), "{mode}");
        for (a, b) in hill.steps.iter().zip(&hosford.steps) {
            assert!((a.punch_force / b.punch_force - 1.0).abs() < 1e-5, "{mode} at {} mm", a.travel);
            assert!((a.thinnest / b.thinnest - 1.0).abs() < 1e-6, "{mode} at {} mm", a.travel);
        }
    }
}

/// Trust: a stretch over a dome never unloads, so that both modes differ by the elastic strains alone: σ/E of 0.4 % of
/// aluminium shifts the force over the travel by less than 2 %, and the thinnest place by less than 1 %.
#[test]
fn both_modes_agree_where_nothing_unloads() {
    let end = |mode: &str| {
        let mode = format!("material.mode=\"{mode}\"");
        *last(&run(shipped_case("stretch_limit", &[&mode, HOSFORD, "tools.punch.travel=\"20 mm\""]).model(), &mut ()))
    };
    let [flow, elastic] = ["flow", "elasto_viscoplastic"].map(end);
    assert!((flow.travel - elastic.travel).abs() < 1e-9);
    assert!((elastic.punch_force / flow.punch_force - 1.0).abs() < 0.02);
    assert!((elastic.thinnest / flow.thinnest - 1.0).abs() < 0.01);
}

const HOSFORD: &str = "material.yield_condition={ hosford = { crystal = \"fcc\" } }";

/// The condition is what a dome's biaxial stretching feels: with r̄ far below 1 Hill's sheet is too soft there, and thins more.
#[test]
fn a_stretched_dome_of_aluminium_thins_less_than_by_hills_condition() {
    let thinnest = |condition: &str| {
        let condition = format!("material.yield_condition={condition}");
        last(&run(shipped_case("stretch_limit", &[&condition, "tools.punch.travel=\"20 mm\""]).model(), &mut ()))
            .thinnest
    };
    let (hill, hosford) = (thinnest("\"hill48\""), thinnest("{ hosford = { crystal = \"fcc\" } }"));
    assert!(hosford > hill);
}

#[test]
fn a_released_hat_springs_back_with_it() {
    let hat = shipped_case("hat_springback", &["material.yield_condition={ hosford = { crystal = \"bcc\" } }"])
        .solve(&mut ());
    assert!(hat.is_complete());
}

/// Trust: the definitions. What designers' formulas ask of a condition is what it answers along those paths.
#[test]
fn the_biaxial_factor_is_that_of_the_path() {
    for criterion in [Hill48::new(0.6).into(), YieldCriterion::from(Hosford::new(0.6, 8.0))] {
        assert!((criterion.stress([1.0, 1.0, 0.0])[0] - criterion.biaxial_factor()).abs() < 1e-12);
    }
}
