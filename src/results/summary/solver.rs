//! Mesh, method and effort of the numerical solution.

use super::{Summary, largest};
use crate::model::{Grading, Iteration, Model, Norm, Theory};
use crate::solver::solution::{Effort, StageSolution, StepRecord};
use crate::units::Amount;

impl Summary {
    /// Contact, mesh, method and effort.
    pub(super) fn solver(&mut self, model: &Model, run: &StageSolution, last: &StepRecord) {
        let largest = |value| largest(run, value);
        self.number("sticking", "Contacts that stick at the end", Amount::share(last.sticking));
        self.count("flips", "Contacts that came or went", run.steps.iter().map(|s| s.contact_changes).sum());
        self.number("strain_increment", "Largest strain of one step", Amount::strain(largest(|s| s.strain_increment)));
        self.text("mesh", "Mesh", mesh(model));
        if model.blank.theory == Theory::Selective {
            let (share, points) = bent(model, run);
            self.number("bending_share", "  elements times steps that bent", Amount::share(share));
            self.number("point_share", "  law points over those of full bending", Amount::share(points));
        }
        self.text("corrector", "Corrector", corrector(model));
        let Effort { predictor, secant, softened, halved, overstrained, overstepped, abandoned } = run.effort;
        self.count("steps", "Steps", run.steps.len());
        self.count("steps_from_predictor", "  solved from the predictor", predictor);
        self.count("steps_from_secant", "  from a secant start at rest", secant);
        self.count("steps_from_softened", "  from a softened start", softened);
        self.count("iterations", "Iterations", run.steps.iter().map(|s| s.iterations).sum());
        // Where the residual alone decides, a step may be accepted without an increment that says how far it was.
        let known = run.steps.iter().map(|s| s.velocity_norm).filter(|norm| norm.is_finite());
        if let Some(norm) = known.reduce(f64::max) {
            self.number("velocity_norm", "Largest accepted velocity norm", Amount::norm(norm));
        }
        let residual = Amount::norm(largest(|s| s.residual_norm));
        self.number("residual_norm", "Largest accepted residual norm", residual);
        self.count("rejected", "Rejected tries", run.steps.iter().map(|s| s.rejected).sum::<usize>() + abandoned);
        self.count("steps_halved", "  steps halved", halved);
        self.count("steps_overstrained", "  repeated for too much strain", overstrained);
        self.count("steps_overstepped", "  repeated to find the end of the run", overstepped);
    }
}

/// Share of the elements that bent, of all steps, and share of the thickness points that full bending would have evaluated in
/// as many iterations \[–\].
fn bent(model: &Model, run: &StageSolution) -> (f64, f64) {
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

fn mesh(model: &Model) -> String {
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

fn corrector(model: &Model) -> String {
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
