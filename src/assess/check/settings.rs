//! Lines on the sheet's constants, mesh and solver, from which a run can be repeated.

use super::line::{Line, line, number};
use crate::case::Case;
use crate::material::{Elastic, YieldCriterion};
use crate::model::{ContactMethod, Grading, Iteration, Mode, Norm};
use crate::units::{Amount, Digits, Unit};

pub(super) fn lines(case: &Case) -> Vec<Line> {
    let model = case.model();
    let (material, settings) = (&model.material, &model.settings);
    let mut lines = vec![match model.mode {
        Mode::Flow => line("mode", "flow", "rigid and viscoplastic: no elasticity, no spring-back"),
        Mode::ElastoViscoplastic => line("mode", "elasto-viscoplastic", "with elasticity: the sheet springs back"),
        Mode::Elastic => line("mode", "elastic", "no yielding"),
    }];
    lines.push(match material.elastic {
        Some(Elastic { young, poisson }) => {
            let poisson = format!("Poisson's ratio {}", Amount::number(poisson));
            number("Young's modulus", Amount::new(young, Unit::MPa, Digits::Significant(3)), poisson)
        }
        None => line("elasticity", "none given", "the flow law needs none"),
    });
    let ratio = format!("r̄ = {}", Amount::number(material.yield_criterion.ratio()));
    lines.push(match &material.gtn {
        Some(gtn) => line("yield condition", gtn.to_string(), ratio),
        None => match material.yield_criterion {
            YieldCriterion::Hill48(_) => line("yield condition", "Hill 1948", ratio),
            YieldCriterion::Hosford(_) => line("yield condition", "Hosford", ratio),
        },
    });
    lines.push(match material.rate {
        Some(law) => line("rate law", law.to_string(), "times the yield stress"),
        None => line("rate law", "none", "the yield stress does not depend on the strain rate"),
    });
    lines.extend(material.thermal.map(|law| line("softening by heat", law.to_string(), "times the yield stress")));
    let limit = model.forming_limit.as_ref().map_or("none", |curve| curve.name);
    lines.push(line("forming limit", limit, ""));
    let size = Amount::size(model.blank.length / model.blank.elements as f64);
    let spread = match model.blank.grading {
        Grading::Uniform => format!("elements, each {size} wide"),
        Grading::Radii | Grading::Divided { .. } => format!("elements, {size} on average, finer at the tools' radii"),
    };
    lines.push(number("mesh", Amount::count(model.blank.elements as f64), spread));
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
    let (tolerance, most) = (Amount::norm(settings.tolerance), settings.max_iterations);
    lines.push(line("corrector", matrix, format!("{norm} below {tolerance}, at most {most} iterations a step")));
    let (first, strain) = (Amount::given_share(settings.first_step), Amount::number(settings.strain_step));
    let steps = format!("of the travel at most, {first} at first; at most {strain} strain a step");
    lines.push(number("steps", Amount::given_share(settings.max_step), steps));
    let contact = match settings.contact {
        ContactMethod::Penalty => "penalty",
        ContactMethod::AugmentedLagrangian => "augmented Lagrangian",
    };
    let stiffness = Amount::new(settings.contact_stiffness, Unit::MPa, Digits::Given(6));
    let gap = Amount::given_share(settings.contact_smoothing);
    let stiffness = format!("{stiffness} over the thickness, sets in over {gap} of it");
    lines.push(line("contact", contact, stiffness));
    lines.push(number("cut-off strain", Amount::norm(settings.cutoff_strain), "of 1 % of the travel: rigid below"));
    lines.push(number(
        "slip speed",
        Amount::number(settings.slip_speed),
        "of the punch's speed: 71 % of full friction",
    ));
    lines
}
