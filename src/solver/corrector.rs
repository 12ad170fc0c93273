//! The implicit corrector: iterates with H until the step is in equilibrium (Sosnowski 1994, equation 9).

use super::equilibrium::evaluate;
use super::evaluation::{Evaluation, Linearisation};
use super::process::Process;
use super::step::Step;
use super::trial::Trial;
use super::{Iterate, Observer, Start};
use crate::model::{Iteration, Mode, Model, Norm};
use crate::solver::solution::IterationRecord;

/// Largest move of a node in one iteration, over the sheet thickness \[–\].
const LARGEST_MOVE: f64 = 0.5;
/// The same while the tools are taken away: long thin walls swing far.
const LARGEST_SWING: f64 = 5.0;
/// Largest turn of a fibre in one iteration \[rad\].
const LARGEST_TURN: f64 = 0.3;
/// The velocity norm alone can accept a wrong force; it also asks for a residual below this share of the largest force \[–\].
const LOOSE_RESIDUAL: f64 = 0.01;
/// Residual over the largest force below which what is left of the velocities' error is foreseen from how it fell, and not
/// waited for \[–\]: forces of all shipped cases then agree with those of one more iteration within 1e-6.
const SETTLED_RESIDUAL: f64 = 1e-3;
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
    /// Whether the observer wanted to stop.
    pub interrupted: bool,
    pub iterations: usize,
    /// Times that the corrector was gone through: 1, and one more for every round of the augmented Lagrangian.
    pub rounds: usize,
    /// Of the last increment, where it was taken whole: else nothing is known of how far the answer is.
    pub velocity_norm: f64,
    /// The same of any last increment; 0 where none was needed.
    pub increment: f64,
    /// What the increments yet to come would add up to, if they went on falling as the last two did \[–\].
    pub velocity_left: f64,
    pub residual_norm: f64,
}

impl Outcome {
    /// Of a try that has not begun.
    pub const BEGUN: Self = Self {
        converged: false,
        interrupted: false,
        iterations: 0,
        rounds: 1,
        velocity_norm: f64::INFINITY,
        increment: 0.0,
        velocity_left: f64::INFINITY,
        residual_norm: f64::INFINITY,
    };

    /// Notes an increment of the velocities, taken whole or not.
    fn moved(&mut self, increment: f64, whole: bool) {
        self.increment = increment;
        let norm = if whole { increment } else { f64::INFINITY };
        let ratio = norm / self.velocity_norm;
        let falls = self.velocity_norm < f64::INFINITY && ratio < 1.0;
        self.velocity_left = if falls { norm * ratio / (1.0 - ratio) } else { f64::INFINITY };
        self.velocity_norm = norm;
    }

    /// Whether the next evaluation is the last by what the velocities say, where it is they that are asked.
    fn foresees_end(&self, model: &Model) -> bool {
        let settings = &model.settings;
        settings.norm == Norm::Velocity && self.velocity_norm.min(self.velocity_left) <= settings.tolerance
    }
}

/// One pass of the corrector: at most so many iterations with one matrix.
#[derive(Clone, Copy)]
pub(super) struct Pass {
    pub start: Start,
    pub matrix: Iteration,
    pub most: usize,
}

/// Corrects a trial to equilibrium at the end of its step.
pub(super) fn correct(
    step: &Step,
    trial: &mut Trial,
    evaluation: &mut Evaluation,
    pass: Pass,
    observer: &mut dyn Observer,
) -> Outcome {
    let (model, Pass { matrix, most, .. }) = (step.model, pass);
    let mut outcome = Outcome::BEGUN;
    let searches = model.mode != Mode::Flow && trial.kept.is_none();
    loop {
        // The last evaluation needs no matrix; where the forces disagree that it is the last it is made again.
        let foreseen = trial.kept.is_none() && outcome.foresees_end(model);
        if !judge(step, trial, matrix, foreseen, evaluation, &mut outcome)
            || (foreseen && !outcome.converged && !judge(step, trial, matrix, false, evaluation, &mut outcome))
        {
            return outcome;
        }
        observe(step, pass, trial, evaluation, &outcome, observer);
        let looks_back = searches && (1..most).contains(&outcome.iterations);
        if let Some(back) = looks_back.then(|| trial.line.back(&evaluation.system)).flatten() {
            trial.advance(step.process, -back);
            outcome.iterations += 1;
            outcome.moved(velocity_norm(model, trial, back), false);
            continue;
        }
        if outcome.converged || outcome.iterations == most || !trial.line.aim(&mut evaluation.system) {
            outcome.converged &= !has_negative_pressure(step.process, trial);
            return outcome;
        }
        if observer.wants_to_stop() {
            outcome.interrupted = true;
            return outcome;
        }
        outcome.iterations += 1;
        let share = allowed_share(step.process, trial);
        trial.line.go(share);
        trial.advance(step.process, share);
        // A capped increment says nothing of how far the answer still is.
        outcome.moved(velocity_norm(model, trial, share), share >= 1.0);
    }
}

/// Calls the observer with the evaluation.
fn observe(
    step: &Step,
    pass: Pass,
    trial: &Trial,
    evaluation: &Evaluation,
    outcome: &Outcome,
    observer: &mut dyn Observer,
) {
    let cutoff = if step.model.mode == Mode::Flow { step.cutoff(trial.softening) } else { 0.0 };
    let iterate = Iterate { step, evaluation, cutoff };
    let record = IterationRecord {
        step: step.number,
        travel: step.travel(),
        start: pass.start,
        matrix: pass.matrix,
        iteration: outcome.iterations,
        velocity_norm: outcome.increment,
        residual_norm: outcome.residual_norm,
        share: if outcome.iterations > 0 { trial.line.length() } else { 0.0 },
        worst_r: evaluation.nodes[evaluation.worst_node][0],
        active_contacts: evaluation.active_contacts,
        touching: iterate.contacts().count(),
        sticking: iterate.contacts().filter(|contact| contact.sticks).count(),
        cut_off: iterate.increments().filter(|[increment, _]| iterate.is_cut_off(*increment)).count(),
    };
    observer.iteration(&record, &iterate);
}

/// Evaluates a trial and notes how far it is from equilibrium; `false` when an element has collapsed.
fn judge(
    step: &Step,
    trial: &mut Trial,
    matrix: Iteration,
    residual_alone: bool,
    evaluation: &mut Evaluation,
    outcome: &mut Outcome,
) -> bool {
    let (iteration, velocity_norm) = (outcome.iterations, outcome.velocity_norm);
    let sound = evaluate(step, trial, &Linearisation { matrix, residual_alone, iteration, velocity_norm }, evaluation);
    if sound {
        outcome.residual_norm = evaluation.residual_norm;
        outcome.converged = is_converged(step.model, evaluation, outcome);
    }
    sound
}

/// Whether the norms that the settings ask for are small.
fn is_converged(model: &Model, evaluation: &Evaluation, outcome: &Outcome) -> bool {
    let small = |norm: f64| norm <= model.settings.tolerance;
    let settled = outcome.residual_norm <= SETTLED_RESIDUAL && small(outcome.velocity_left);
    let still = small(outcome.velocity_norm) || settled;
    let converged = match model.settings.norm {
        Norm::Velocity => still && outcome.residual_norm <= LOOSE_RESIDUAL,
        Norm::Residual => small(outcome.residual_norm),
        Norm::Both => still && small(outcome.residual_norm),
    };
    converged && evaluation.held_rate.beyond_cap <= CAP
}

/// True if a strain-rate-controlled gas pressure came out negative: the sheet bulges to the wrong side.
fn has_negative_pressure(process: &Process, trial: &Trial) -> bool {
    process.gas_shared.iter().zip(&trial.gas).any(|(shared, pressure)| shared.is_some() && *pressure < 0.0)
}

/// The share of the direction that moves nothing too far.
fn allowed_share(process: &Process, trial: &Trial) -> f64 {
    let (model, line) = (process.model, &trial.line);
    let t = model.blank.thickness;
    let reach = if model.release.is_some() { LARGEST_SWING } else { LARGEST_MOVE };
    let mut share: f64 = 1.0;
    for d in &line.direction {
        share = share.min(reach * t / d.xy().norm()).min(LARGEST_TURN / d.z.abs());
    }
    for k in process.tools.iter().filter_map(|tool| tool.shared) {
        share = share.min(LARGEST_MOVE * t / line.shared[k].abs());
    }
    share
}

/// Relative increment of the velocities by a share of the direction \[–\].
fn velocity_norm(model: &Model, trial: &Trial, share: f64) -> f64 {
    let t = model.blank.thickness;
    let (mut change, mut total) = (0.0, 0.0);
    for (d, u) in trial.line.direction.iter().zip(&trial.moves) {
        let weight = [1.0, 1.0, t]; // a turn counts by what it moves a thickness away
        for k in 0..3 {
            change += (weight[k] * share * d[k]).powi(2);
            total += (weight[k] * u[k]).powi(2);
        }
    }
    let still = (STILL * t).powi(2) * trial.moves.len() as f64;
    (change / total.max(still)).sqrt()
}
