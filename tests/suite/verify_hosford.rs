//! Whole runs with Hosford's yield condition: closed forms, Hill's as its limit, and the elastic mode beside the flow mode.

use crate::common::prelude::*;
use crate::common::shipped::shipped_case as case;
use stampflow::{Model, StageSolution};

fn solve(model: &Model) -> StageSolution {
    solver::run(model, &mut ())
}

/// Trust: closed forms of a sheet that is pulled. In plane strain σ_s = c σ_y(c ε) with x^(a−1) = r̄ (1 − x)^(a−1), c^−a =
/// (1 + x^a + r̄ (1 − x)^a)/(1 + r̄); equi-biaxial σ = c σ_y(2c ε), c^a = (1 + r̄)/2. The rate is that of the instant; steps of
/// 1/500 of the radius find it to their square.
#[test]
fn the_pulled_sheet_bears_hosfords_closed_forms() {
    let rate = Rate::examples()[0].1;
    for (r, a) in [(0.3_f64, 8.0_f64), (0.6, 2.0), (1.0, 6.0), (2.5, 8.0)] {
        for geometry in [Geometry::PlaneStrain, Geometry::Axisymmetric] {
            let mut model = simple::pulled(geometry, Theory::Bending, 8.0);
            model.material.rate = Some(rate);
            model.material.yield_criterion = Hosford::new(r, a).into();
            for record in solve(&model).steps.iter().skip(6) {
                let radius = 40.0 + record.travel;
                let strain = (radius / 40.0).ln();
                let (c, per_strain, thinning, around) = match geometry {
                    Geometry::PlaneStrain => {
                        let root = r.powf(1.0 / (a - 1.0));
                        let x = root / (1.0 + root);
                        let c = ((1.0 + x.powf(a) + r * (1.0 - x).powf(a)) / (1.0 + r)).powf(-1.0 / a);
                        (c, c, 1.0, 2.0)
                    }
                    Geometry::Axisymmetric => {
                        let c = (0.5 * (1.0 + r)).powf(1.0 / a);
                        (c, 2.0 * c, 2.0, std::f64::consts::TAU * radius)
                    }
                };
                let speed = per_strain * model.speed / radius;
                let flow = model.material.hardening.at(per_strain * strain).stress * rate.at(speed).value;
                let force = around * (-thinning * strain).exp() * c * flow;
                let error = record.edge_force / force - 1.0;
                assert!(error.abs() < 2e-5, "r {r}, a {a}, {geometry:?} at {} mm: {error:e}", record.travel);
            }
        }
    }
}

/// Trust: one metal written twice; both runs stop their iterations at the solver's tolerance of 1e-4 of the velocities, whose
/// square is what forces miss.
#[test]
fn a_cup_with_exponent_two_is_hills() {
    for mode in ["flow", "elasto_viscoplastic"] {
        let common = [format!("material.mode=\"{mode}\""), "material.anisotropy=0.6".into()];
        let elastic = ["material.young=\"70 GPa\"", "material.poisson=0.33", "tools.punch.travel=\"8 mm\""];
        let run = |condition: &str| {
            let condition = format!("material.yield_condition={condition}");
            let overrides: Vec<&str> =
                common.iter().map(String::as_str).chain(elastic).chain([condition.as_str()]).collect();
            solve(case("quickstart", &overrides).model())
        };
        let (hill, hosford) = (run("\"hill48\""), run("{ hosford = { exponent = 2 } }"));
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
    let run = |mode: &str| {
        let mode = format!("material.mode=\"{mode}\"");
        solve(case("stretch_limit", &[&mode, HOSFORD, "tools.punch.travel=\"20 mm\""]).model())
    };
    let (flow, elastic) = (run("flow"), run("elasto_viscoplastic"));
    let end = |run: &StageSolution| *run.steps.last().expect("steps");
    let (flow, elastic) = (end(&flow), end(&elastic));
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
        solve(case("stretch_limit", &[&condition, "tools.punch.travel=\"20 mm\""]).model())
            .steps
            .last()
            .expect("steps")
            .thinnest
    };
    let (hill, hosford) = (thinnest("\"hill48\""), thinnest("{ hosford = { crystal = \"fcc\" } }"));
    assert!(hosford > hill);
}

/// Spring-back follows the condition through both stages.
#[test]
fn a_released_hat_springs_back_with_it() {
    let hat = case("hat_springback", &["material.yield_condition={ hosford = { crystal = \"bcc\" } }"]).solve(&mut ());
    assert!(hat.is_complete());
}

/// Trust: the definitions. What designers' formulas ask of a condition is what it answers along those paths.
#[test]
fn the_biaxial_factor_is_that_of_the_path() {
    for criterion in [Hill48::new(0.6).into(), YieldCriterion::from(Hosford::new(0.6, 8.0))] {
        assert!((criterion.stress([1.0, 1.0, 0.0])[0] - criterion.biaxial_factor()).abs() < 1e-12);
    }
}
