//! The implicit corrector: iterates with H until the step is in equilibrium (Sosnowski 1994, equation 9).

use super::Observer;
use super::assembly::{Trial, Workspace};
use super::attempt::Step;
use crate::model::{Iteration, Mode, Norm};
use crate::solution::IterationRecord;

/// Largest move of a node in one iteration, over the sheet thickness \[–\].
const LARGEST_MOVE: f64 = 0.5;
/// The same while the tools are taken away: long thin walls swing far.
const LARGEST_SWING: f64 = 5.0;
/// Largest turn of a fibre in one iteration \[rad\].
const LARGEST_TURN: f64 = 0.3;
/// The velocity norm alone can accept a wrong force; it also asks for a residual below this share of the largest force \[–\].
const LOOSE_RESIDUAL: f64 = 0.01;
/// Mean move of a node, over the sheet thickness, below which a step counts as standing still \[–\]: the velocity norm is
/// then that of this move, for no increment is small against nothing.
const STILL: f64 = 1e-6;
/// Share by which a pressure may miss or exceed the cap that it sits on \[–\]: its equation is linear, so this is round-off.
const CAP: f64 = 1e-10;
/// The secant matrix converges linearly and gets this many times the iterations.
const SECANT_PATIENCE: usize = 10;

/// How many times the usual iterations a matrix may take.
pub(super) fn patience(matrix: Iteration) -> usize {
    if matrix == Iteration::Secant { SECANT_PATIENCE } else { 1 }
}

/// How a try of a step went.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome {
    pub converged: bool,
    pub iterations: usize,
    pub velocity_norm: f64,
    pub residual_norm: f64,
}

/// Corrects the prediction in `work` to equilibrium at the end of a step with one matrix and at most so many iterations.
pub(super) fn correct(
    work: &mut Workspace,
    step: &Step,
    matrix: Iteration,
    most: usize,
    observer: &mut dyn Observer,
) -> Outcome {
    let Step { model, state, dt, number } = *step;
    let settings = &model.settings;
    let t = model.blank.thickness;
    let mut outcome =
        Outcome { converged: false, iterations: 0, velocity_norm: f64::INFINITY, residual_norm: f64::INFINITY };
    let searches = model.mode != Mode::Flow && work.kept.is_none();
    loop {
        let trial = Trial { matrix, iteration: outcome.iterations, velocity_norm: outcome.velocity_norm };
        if !work.assemble(step, &trial) {
            return outcome;
        }
        outcome.residual_norm = work.residual_norm;
        let small = |norm: f64| norm <= settings.tolerance;
        outcome.converged = match settings.norm {
            Norm::Velocity => small(outcome.velocity_norm) && outcome.residual_norm <= LOOSE_RESIDUAL,
            Norm::Residual => small(outcome.residual_norm),
            Norm::Both => small(outcome.velocity_norm) && small(outcome.residual_norm),
        };
        outcome.converged &= work.beyond_cap <= CAP;
        let looks_back = searches && (1..most).contains(&outcome.iterations);
        if let Some(back) = looks_back.then(|| work.line.back(&work.system)).flatten() {
            work.advance(-back);
            outcome.iterations += 1;
            outcome.velocity_norm = f64::INFINITY;
            continue;
        }
        if outcome.converged || outcome.iterations == most || !work.line.aim(&mut work.system) {
            return outcome;
        }
        outcome.iterations += 1;

        let reach = if model.release.is_some() { LARGEST_SWING } else { LARGEST_MOVE };
        let mut cut: f64 = 1.0;
        for d in &work.line.direction {
            cut = cut.min(reach * t / d.xy().norm()).min(LARGEST_TURN / d.z.abs());
        }
        for k in work.tools.iter().filter_map(|tool| tool.shared) {
            cut = cut.min(LARGEST_MOVE * t / work.line.shared[k].abs());
        }
        work.line.go(cut);
        work.advance(cut);
        let (mut change, mut total) = (0.0, 0.0);
        for (d, u) in work.line.direction.iter().zip(&work.moves) {
            let weight = [1.0, 1.0, t]; // a turn counts by what it moves a thickness away
            for k in 0..3 {
                change += (weight[k] * cut * d[k]).powi(2);
                total += (weight[k] * u[k]).powi(2);
            }
        }
        let still = (STILL * t).powi(2) * work.moves.len() as f64;
        let velocity_norm = (change / total.max(still)).sqrt();
        // A capped increment says nothing of how far the answer still is.
        outcome.velocity_norm = if cut < 1.0 { f64::INFINITY } else { velocity_norm };
        observer.iteration(&IterationRecord {
            step: number,
            travel: model.travel_at(state.time + dt),
            iteration: outcome.iterations,
            velocity_norm,
            residual_norm: outcome.residual_norm,
            cut,
            active_contacts: work.active_contacts,
        });
    }
}
