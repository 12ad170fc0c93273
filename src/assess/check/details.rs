//! What a report adds, so that a run can be judged and repeated from it: constants of the sheet, its temperature, where
//! friction comes from, mesh and settings of the solver.

use super::line::{Line, line};
use crate::case::Case;
use crate::material::chaboche::shifting;
use crate::material::{Elastic, Material};
use crate::model::{ContactMethod, Grading, Heat, Iteration, Mode, Model, Norm, Settings, ToolHeat};
use crate::table::Unit;
use crate::units::ZERO_CELSIUS;
use crate::units::{Amount, Digits, joined};

/// In the order of telling.
pub(super) fn lines(case: &Case) -> Vec<Line> {
    let model = case.model();
    let mut lines = vec![mode(model)];
    sheet(&model.material, &mut lines);
    match &model.heat {
        Some(heat) => warmth(heat, &mut lines),
        None => lines.push(line("temperature", Amount::temperature(20.0), "throughout, not given")),
    }
    let sources = [("material source", &case.sources.material), ("friction source", &case.sources.friction)];
    lines.extend(sources.iter().filter(|(_, given)| given.is_none()).map(|(label, _)| line(*label, "not given", "")));
    let limit = model.forming_limit.as_ref().map_or_else(|| String::from("none"), |curve| curve.name.into());
    lines.push(line("forming limit", limit, ""));
    lines.push(mesh(model));
    solver(&model.settings, &mut lines);
    lines
}

/// A number that was given, to so many digits as it has.
fn given(value: f64, unit: Unit) -> Amount {
    Amount::new(value, unit, Digits::Given(6))
}

fn mode(model: &Model) -> Line {
    let (name, meaning) = match model.mode {
        Mode::Flow => ("flow", "rigid and viscoplastic: no elasticity, no spring-back"),
        Mode::ElastoViscoplastic => ("elasto-viscoplastic", "with elasticity: the sheet springs back"),
        Mode::Elastic => ("elastic", "no yielding"),
    };
    line("mode", name, meaning)
}

fn sheet(material: &Material, lines: &mut Vec<Line>) {
    match material.elastic {
        Some(Elastic { young, poisson }) => {
            lines.push(line("Young's modulus", Amount::new(young, Unit::MPa, Digits::Converted(3)), ""));
            lines.push(line("Poisson's ratio", Amount::number(poisson), ""));
        }
        None => lines.push(line("elasticity", "none given", "the flow law needs none")),
    }
    let ratio = Amount::number(material.yield_criterion.ratio());
    lines.push(match &material.gtn {
        Some(gtn) => line("yield condition", gtn.to_string(), format!("r̄ = {ratio}")),
        None if ratio.value == 1.0 => line("yield condition", "Huber-Mises", "isotropic, r̄ = 1"),
        None => line("yield condition", "Hill 1948", format!("r̄ = {ratio}")),
    });
    match shifting(material.chaboche) {
        Some(all) => lines.extend(all.iter().filter(|law| law.modulus > 0.0).map(|law| {
            let recall = format!("modulus, recall {recall}", recall = Amount::number(law.dynamic_recovery));
            line("back-stress", given(law.modulus, Unit::MPa), recall)
        })),
        None => lines.push(line("back-stresses", "none", "isotropic hardening")),
    }
    lines.push(match material.rate {
        Some(law) => line("rate law", String::from(law.to_string()), "times the yield stress"),
        None => line("rate law", "none", "the yield stress does not feel the strain rate"),
    });
    lines.extend(
        material.thermal.map(|law| line("softening by heat", String::from(law.to_string()), "times the yield stress")),
    );
}

/// What changes the sheet's temperature; the temperature itself is said with the blank.
fn warmth(heat: &Heat, lines: &mut Vec<Line>) {
    let Some(flow) = &heat.flow else { return };
    let number = |label: &'static str, value: f64, unit: &str| {
        line(label, joined([Amount::number(value).into(), unit.to_owned().into()], " "), "")
    };
    lines.push(number("heat capacity", flow.capacity, "MPa/K"));
    lines.push(line("heat from work", Amount::given_share(flow.plastic_share), "of the plastic work"));
    lines.push(number("conductivity", flow.conductivity, "N/(s K)"));
    lines.extend(flow.tools.iter().map(|ToolHeat { role, temperature, transfer }| {
        let meaning = format!("transfers {h} N/(mm s K)", h = Amount::number(*transfer));
        let label = format!("{tool} temperature", tool = role.name());
        line(label, Amount::temperature(temperature - ZERO_CELSIUS), meaning)
    }));
}

fn mesh(model: &Model) -> Line {
    let blank = &model.blank;
    let size = Amount::size(blank.length / blank.elements as f64);
    let spread = match blank.grading {
        Grading::Uniform => format!("elements, each {size} wide"),
        Grading::Radii | Grading::Divided { .. } => {
            format!("elements, {size} on average, finer where the tools' radii ask for it")
        }
    };
    line("mesh", Amount::count(blank.elements), spread)
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
    let most = format!(
        "{norm} below {tolerance}, at most {n} iterations a step",
        tolerance = Amount::norm(settings.tolerance),
        n = settings.max_iterations
    );
    lines.push(line("corrector", matrix, most));
    let steps = format!(
        "of the travel at most, {first} at first; at most {strain} strain a step",
        first = Amount::given_share(settings.first_step),
        strain = Amount::number(settings.strain_step)
    );
    lines.push(line("steps", Amount::given_share(settings.max_step), steps));
    let contact = match settings.contact {
        ContactMethod::Penalty => "penalty",
        ContactMethod::AugmentedLagrangian => "augmented Lagrangian",
    };
    let stiffness = format!(
        "{stiffness} over the thickness, sets in over {gap} of it",
        stiffness = given(settings.contact_stiffness, Unit::MPa),
        gap = Amount::given_share(settings.contact_smoothing)
    );
    lines.push(line("contact", contact, stiffness));
    let rigid = "of a step of a hundredth of the travel, below which the sheet is rigid";
    lines.push(line("cut-off strain", Amount::norm(settings.cutoff_strain), rigid));
    let slip = "of the punch's speed, where friction has 71 % of its full value";
    lines.push(line("slip speed", Amount::number(settings.slip_speed), slip));
    let arcs = settings.facets.map_or_else(|| "exact".into(), |n| format!("{n} chords per 90°"));
    lines.push(line("tools' arcs", arcs, ""));
}
