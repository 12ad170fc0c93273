//! Check of a case before it is solved: its numbers, rules of thumb, and warnings.

mod tools;

use super::{Kind, before, estimate, sentences};
use crate::case::Case;
use crate::material::{Elastic, YieldCriterion};
use crate::model::{ContactMethod, Extent, Geometry, Grading, Iteration, Mode, Model, Norm, Theory};
use crate::units::{Amount, Digits, Unit, ZERO_CELSIUS, joined};
use std::fmt;

/// Check of a case before it is solved.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Check {
    /// Title of the case.
    pub title: String,
    /// The case in numbers.
    pub lines: Vec<Line>,
    /// Constants of the sheet, mesh and settings, from which the run can be repeated.
    pub details: Vec<Line>,
    /// Doubts; the case can be solved all the same.
    pub warnings: Vec<String>,
    /// Assumptions, declared or made while reading.
    pub notes: Vec<String>,
}

/// Checks a case without solving it.
pub fn report(case: &Case) -> Check {
    let model = case.model();
    let strength = estimate::tensile_strength(&model.material);
    let source = |label, source: &Option<String>| source.as_ref().map(|source| line(label, source.clone(), ""));
    let mut lines = blank(model);
    lines.push(line("material", model.material.describe(), ""));
    lines.extend(source("material source", &case.sources.material));
    lines.push(number("tensile strength", Amount::stress(strength), "by the law, at Considère's load maximum"));
    lines.extend(tools::lines(model));
    lines.extend(source("friction source", &case.sources.friction));
    lines.extend(tools::holder(model, strength));
    lines.push(number("elements", Amount::count(model.blank.elements as f64), ""));
    lines.extend(estimate::coarsest_corner(model).map(|fit| {
        let (tool, radius) = (fit.role.name(), Amount::drawn(fit.radius));
        let per_quarter = Amount::new(fit.per_quarter, Unit::None, Digits::Significant(2));
        let meaning = format!("at the {tool}'s radius of {radius}: {per_quarter} elements per 90°");
        number("element size", Amount::size(fit.size), meaning)
    }));
    lines.extend(case.later().iter().enumerate().map(|(i, stage)| tools::stage(i + 2, stage)));
    lines.extend(case.compare.iter().map(|spec| {
        let missing = if spec.data.is_some() { "" } else { " (no data: add the CSV file to see it)" };
        line("compare", spec.reference.display().to_string(), format!("{}{missing}", spec.against))
    }));
    let findings = before(case);
    Check {
        title: model.title.clone(),
        lines,
        details: settings(case),
        warnings: sentences(&findings, Kind::Warning),
        notes: model.notes.iter().cloned().chain(sentences(&findings, Kind::Assumption)).collect(),
    }
}

fn blank(model: &Model) -> Vec<Line> {
    let blank = &model.blank;
    let (geometry, meaning): (String, _) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric".into(), String::new()),
        Geometry::PlaneStrain => {
            ("plane strain".into(), format!("half length, {} in all", Amount::set(2.0 * blank.length)))
        }
    };
    let volume = |unit| Amount::new(model.extent().area(blank.length) * blank.thickness, unit, Digits::Significant(3));
    let points = blank.layers;
    let theory = match blank.theory {
        Theory::Bending => format!("bending, {points} points through the thickness"),
        Theory::Membrane => "membrane".into(),
        Theory::Selective => {
            let ratio = Amount::number(model.settings.bend_ratio);
            format!("bending with {points} points where t/R is above {ratio}, else membrane")
        }
    };
    let mut lines = vec![
        line("geometry", joined([geometry, model.extent().described()], "; "), ""),
        line("blank", size_of(model, blank.length, Amount::set), meaning),
        number("thickness", Amount::size(blank.thickness), ""),
        match model.extent() {
            Extent::PerDepth => number("volume", volume(Unit::Mm2), "times the depth"),
            _ => number("volume", volume(Unit::Mm3), ""),
        },
        line("theory", theory, ""),
    ];
    lines.extend(model.heat.as_ref().map(|heat| {
        let ends = [heat.initial.smallest(), heat.initial.largest()];
        let [low, high] = ends.map(|kelvin| Amount::temperature(kelvin - ZERO_CELSIUS));
        let range = if low == high { low.into() } else { format!("{low} to {high}") };
        line("temperature", range, if heat.flow.is_some() { "at first" } else { "throughout" })
    }));
    lines
}

/// Constants of the sheet, mesh and solver, from which a run can be repeated.
fn settings(case: &Case) -> Vec<Line> {
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

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.title)?;
        let width = self.lines.iter().map(|line| line.label.chars().count()).max().unwrap_or(0);
        for Line { label, value, meaning, .. } in &self.lines {
            writeln!(f, "  {label:<width$}  {}", joined([value.clone(), meaning.clone()], " "))?;
        }
        for (heading, entries) in [("notes", &self.notes), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                writeln!(f, "\n{heading}")?;
            }
            entries.iter().try_for_each(|entry| writeln!(f, "  - {entry}"))?;
        }
        Ok(())
    }
}

/// Label, value and meaning.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Line {
    /// Name of the value.
    pub label: String,
    /// Number with its unit, or word.
    pub value: String,
    /// Meaning or origin; may be empty.
    pub meaning: String,
    /// Value in its unit; `None` for words.
    pub number: Option<f64>,
    /// Unit of the number; else empty.
    pub unit: &'static str,
}

fn line(label: impl Into<String>, value: impl Into<String>, meaning: impl Into<String>) -> Line {
    Line { label: label.into(), value: value.into(), meaning: meaning.into(), number: None, unit: "" }
}

fn number(label: &str, amount: Amount, meaning: impl Into<String>) -> Line {
    Line { number: Some(amount.value), unit: amount.unit.spelled(), ..line(label, amount, meaning) }
}

/// Distance from the axis or symmetry plane \[mm\] as shops give it: for round parts the diameter.
fn size_of(model: &Model, half: f64, amount: fn(f64) -> Amount) -> String {
    match model.geometry {
        Geometry::Axisymmetric => format!("Ø {}", amount(2.0 * half)),
        Geometry::PlaneStrain => amount(half).to_string(),
    }
}
