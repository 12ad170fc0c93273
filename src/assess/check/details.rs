//! What a report adds, so that a run can be judged and repeated from it: constants of the sheet, its temperature, where
//! friction comes from, mesh and settings of the solver.

use super::{Line, line};
use crate::case::Case;
use crate::material::chaboche::shifting;
use crate::material::{Elastic, Material};
use crate::model::{ContactMethod, Grading, Heat, Iteration, Mode, Model, Norm, Settings, ToolHeat};
use crate::units::{ZERO_CELSIUS, mm, rounded};

/// In the order of telling.
pub(super) fn lines(case: &Case) -> Vec<Line> {
    let model = case.model();
    let mut lines = vec![mode(model)];
    sheet(&model.material, &mut lines);
    match &model.heat {
        Some(heat) => warmth(heat, &mut lines),
        None => lines.push(line("temperature", "20", "°C throughout, not given")),
    }
    if case.sources.material.is_none() {
        lines.push(line("material source", "not given", ""));
    }
    if case.sources.friction.is_none() {
        lines.push(line("friction source", "not given", ""));
    }
    let limit = model.forming_limit.as_ref().map_or("none", |curve| curve.name);
    lines.push(line("forming limit", limit, ""));
    lines.push(mesh(model));
    solver(&model.settings, &mut lines);
    lines
}

fn mode(model: &Model) -> Line {
    let (name, meaning) = match model.mode {
        Mode::Flow => ("flow", "rigid and viscoplastic: no elasticity, no spring-back"),
        Mode::ElastoViscoplastic => ("elasto-viscoplastic", "with elasticity, so that the sheet springs back"),
        Mode::Elastic => ("elastic", "no yielding"),
    };
    line("mode", name, meaning)
}

fn sheet(material: &Material, lines: &mut Vec<Line>) {
    match material.elastic {
        Some(Elastic { young, poisson }) => {
            lines.push(line("Young's modulus", rounded(young).to_string(), "MPa"));
            lines.push(line("Poisson's ratio", rounded(poisson).to_string(), ""));
        }
        None => lines.push(line("elasticity", "none given", "the flow law needs none")),
    }
    lines.push(line("hardening", material.hardening.describe(), ""));
    let ratio = material.hill48.ratio();
    lines.push(match (&material.gtn, ratio == 1.0) {
        (Some(gtn), _) => line("yield condition", gtn.to_string(), format!("r̄ = {}", rounded(ratio))),
        (None, true) => line("yield condition", "Huber-Mises", "isotropic, r̄ = 1"),
        (None, false) => line("yield condition", "Hill 1948", format!("r̄ = {}", rounded(ratio))),
    });
    match shifting(material.chaboche) {
        Some(all) => lines.extend(all.iter().filter(|law| law.modulus > 0.0).map(|law| {
            let meaning = format!("MPa modulus, recall {}", rounded(law.dynamic_recovery));
            line("back-stress", rounded(law.modulus).to_string(), meaning)
        })),
        None => lines.push(line("back-stresses", "none", "isotropic hardening")),
    }
    let rate = material.rate.map_or_else(|| "none".to_owned(), |law| law.to_string());
    lines.push(line("rate law", rate, if material.rate.is_some() { "on the yield stress" } else { "rate-free" }));
    lines.extend(material.thermal.map(|law| line("softening by heat", law.to_string(), "on the yield stress")));
}

/// What changes the sheet's temperature; the temperature itself is said with the blank.
fn warmth(heat: &Heat, lines: &mut Vec<Line>) {
    let Some(flow) = &heat.flow else { return };
    lines.push(line("heat capacity", rounded(flow.capacity).to_string(), "MPa/K, density times specific heat"));
    lines.push(line("heat from work", rounded(100.0 * flow.plastic_share).to_string(), "% of the plastic work"));
    lines.push(line("conductivity", rounded(flow.conductivity).to_string(), "N/(s K) along the sheet"));
    lines.extend(flow.tools.iter().map(|ToolHeat { role, temperature, transfer }| {
        let meaning = format!("°C, transfers {} N/(mm s K)", rounded(*transfer));
        line(format!("{} temperature", role.name()), rounded(temperature - ZERO_CELSIUS).to_string(), meaning)
    }));
}

fn mesh(model: &Model) -> Line {
    let (blank, grading) = (&model.blank, model.blank.grading);
    let spread = match grading {
        Grading::Uniform => "uniform",
        Grading::Radii => "graded where the tools' radii ask for it",
    };
    let size = mm(blank.length / blank.elements as f64);
    line("mesh", blank.elements.to_string(), format!("elements, {size} mm on average, {spread}"))
}

fn solver(settings: &Settings, lines: &mut Vec<Line>) {
    let matrix = match settings.iteration {
        Iteration::PrimalDual => "primal-dual Newton",
        Iteration::Newton => "Newton",
        Iteration::Secant => "secant",
    };
    let norm = match settings.norm {
        Norm::Velocity => "velocity norm",
        Norm::Residual => "residual norm",
        Norm::Both => "velocity and residual norm",
    };
    let most = format!("{norm} below {:e}, at most {} iterations a step", settings.tolerance, settings.max_iterations);
    lines.push(line("corrector", matrix, most));
    let percent = |share: f64| rounded(100.0 * share);
    let meaning = format!(
        "% of the travel at most, {} % at first; at most {} strain a step",
        percent(settings.first_step),
        settings.strain_step
    );
    lines.push(line("steps", percent(settings.max_step).to_string(), meaning));
    let contact = match settings.contact {
        ContactMethod::Penalty => "penalty",
        ContactMethod::AugmentedLagrangian => "augmented Lagrangian",
    };
    let stiffness = format!(
        "{} MPa times the thickness, sets in over {} thicknesses",
        settings.contact_stiffness, settings.contact_smoothing
    );
    lines.push(line("contact", contact, stiffness));
    lines.push(line(
        "cut-off strain",
        format!("{:e}", settings.cutoff_strain),
        "of a step below which the sheet is rigid",
    ));
    lines.push(line(
        "slip speed",
        rounded(settings.slip_speed).to_string(),
        "of the punch's, at 71 % of full friction",
    ));
    let arcs = settings.facets.map_or_else(|| "exact".to_owned(), |chords| format!("{chords} chords per 90°"));
    lines.push(line("tools' arcs", arcs, ""));
}
