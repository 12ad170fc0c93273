//! Loads of a hat section against continuum solids.

use crate::common::page::{signed, told};
use stampflow::{case, solver};

const REFERENCE: &str = include_str!("../../reference_data/strip_over_cylinder.csv");

/// Punch force of one side at each place \[mm, N/mm\].
fn reference(case: &str, source: &str) -> Vec<[f64; 2]> {
    let rows = REFERENCE.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let rows: Vec<_> = rows.filter(|row| row[0] == case && row.get(1) == Some(&source)).collect();
    rows.iter().map(|row| [5, 6].map(|i| row[i].parse().expect("a number"))).collect()
}

/// Deviation of each load from `reference` \[–\].
fn deviations(friction: f64, holder: &str, reference: &[[f64; 2]]) -> Vec<f64> {
    let text = format!(
        r#"
title = "hat"
geometry = "plane_strain"
blank = {{ half_length = "70 mm", thickness = "0.78 mm", elements = 200, layers = 15 }}
[material]
mode = "elasto_viscoplastic"
young = "206 GPa"
poisson = 0.3
[material.hardening.swift]
k = "565.32 MPa"
offset = 0.007117
n = 0.2589
[tools.punch]
flat = {{ half_width = "25 mm", nose = "5 mm" }}
friction = {friction}
travel = "9.3 mm"
[tools.die]
throat = "25.9984 mm"
shoulder = "5 mm"
friction = {friction}
[tools.holder]
inner_half_width = "30.9984 mm"
{holder}
friction = {friction}
"#
    );
    let case = case::parse(&text, "hat.toml", &[]).unwrap_or_else(|e| panic!("{e}"));
    let run = solver::run(case.model(), &mut ());
    let load = |place: f64| {
        let around = run.steps.iter().filter(|r| (r.travel - place).abs() <= 0.3).map(|r| 0.5 * r.punch_force);
        let (sum, count) = around.fold((0.0, 0.0), |(sum, count), force| (sum + force, count + 1.0));
        sum / count
    };
    reference.iter().map(|&[place, expected]| load(place) / expected - 1.0).collect()
}

/// Trust: solids refined until they change by less than a percent. The moment of the contact pressure is left out, which
/// costs a hat without friction 2 % of its load and one with friction none.
#[test]
fn a_hat_s_load_is_that_of_solids_within_three_percent() {
    let cases = [
        (0.0, "gap = \"0.78 mm\"", reference("hat", "solid_q8r_own"), 0.03),
        (0.144, "force = \"70 N/mm\"", reference("hat_mu_0.144", "calculix_cpe8r_step_0.019_mm"), 0.02),
    ];
    let figures = cases.map(|(friction, holder, reference, limit)| {
        let deviations = deviations(friction, holder, &reference);
        assert!(deviations.len() >= 7 && deviations.iter().all(|d| d.abs() < limit), "{friction}: {deviations:?}");
        let mean = deviations.iter().sum::<f64>() / deviations.len() as f64;
        let worst = deviations.into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("some");
        signed(&[mean, worst], 1)
    });
    for (name, figures) in ["without friction", "with friction 0.144"].into_iter().zip(figures) {
        let row = format!("| hat {name}, ρ/t 6.4: mean and worst of the travel | {{}}, {{}} % |");
        told("docs/contact_on_faces.md", &row, &figures);
    }
}
