//! Mesh and method of a solution in words.

use crate::model::{Grading, Iteration, Model, Norm, Theory};
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Share of the elements that bent, of all steps, and share of the thickness points that full bending would have evaluated in
/// as many iterations \[–\].
pub(super) fn bent(model: &Model, run: &StageSolution) -> (f64, f64) {
    let (elements, layers) = (model.blank.elements as f64, model.blank.layers as f64);
    let (mut bent, mut all, mut points, mut full) = (0.0, 0.0, 0.0, 0.0);
    for step in &run.steps {
        let bending = step.bending as f64;
        // One more evaluation finds the step in equilibrium.
        let evaluations = step.iterations as f64 + 1.0;
        bent += bending;
        all += elements;
        points += evaluations * (bending * layers + elements - bending);
        full += evaluations * elements * layers;
    }
    if all > 0.0 { (bent / all, points / full) } else { (0.0, 0.0) }
}

pub(super) fn mesh(model: &Model) -> String {
    let blank = &model.blank;
    let theory = match blank.theory {
        Theory::Membrane => "membrane".to_owned(),
        Theory::Bending => format!("bending, {} layers", blank.layers),
        Theory::Selective => {
            format!("bending with {} layers where t/R is above {}", blank.layers, model.settings.bend_ratio)
        }
    };
    let grading = if blank.grading == Grading::Uniform { "uniform" } else { "graded by the tools' radii" };
    format!("{} elements, {theory}, {grading}", blank.elements)
}

pub(super) fn corrector(model: &Model) -> String {
    let matrix = match model.settings.iteration {
        Iteration::PrimalDual => "primal-dual Newton",
        Iteration::Newton => "Newton",
        Iteration::Secant => "secant",
    };
    let norm = match model.settings.norm {
        Norm::Velocity => "velocity",
        Norm::Residual => "residual",
        Norm::Both => "velocity and residual",
    };
    format!("{matrix} matrix, {norm} norm below {}", Amount::norm(model.settings.tolerance))
}
