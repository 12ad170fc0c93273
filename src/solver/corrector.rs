//! Implicit corrector: iterates with H until equilibrium (Sosnowski 1994, equation 9).

use super::{equilibrium::evaluate, evaluation::Linearisation, *};

/// Largest move of a node in one iteration, over the sheet thickness \[–\].
pub(super) const LARGEST_MOVE: f64 = 0.5;
/// Largest move during a release, over the thickness \[–\].
const LARGEST_SWING: f64 = 5.0;
/// Largest turn of a fibre in one iteration \[rad\].
const LARGEST_TURN: f64 = 0.3;
/// Largest residual accepted with the velocity norm \[–\].
const LOOSE_RESIDUAL: f64 = 0.01;
/// Residual below which the remaining velocity error is extrapolated \[–\]: forces then agree within 1e-6.
const SETTLED_RESIDUAL: f64 = 1e-3;
/// Residual of round-off in sums of forces, thousands of which cancel \[–\]: the work of its increments has no sign to search by.
const ROUND_OFF: f64 = 1e-11;
/// Least reference move of a node in the velocity norm, over the thickness \[–\].
const STILL: f64 = 1e-6;
/// Accepted relative distance of a pressure from its cap \[–\].
const CAP: f64 = 1e-10;
/// Factor on the iterations of the secant matrix, which converges linearly.
const SECANT_PATIENCE: usize = 10;

pub(super) fn patience(matrix: Iteration) -> usize {
    if matrix == Iteration::Secant { SECANT_PATIENCE } else { 1 }
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Outcome {
    pub converged: bool,
    pub interrupted: bool,
    pub iterations: usize,
    /// Passes of the corrector: 1 and the rounds of the augmented Lagrangian.
    pub rounds: usize,
    /// Norm of the last increment; infinite unless taken whole.
    pub velocity_norm: f64,
    /// Norm of the last increment, whole or not; 0 without one.
    pub increment: f64,
    /// Extrapolated sum of the increments to come \[–\].
    pub velocity_left: f64,
    pub residual_norm: f64,
}

impl Outcome {
    pub fn begun() -> Self {
        let [velocity_norm, velocity_left, residual_norm] = [f64::INFINITY; 3];
        Self { rounds: 1, velocity_norm, velocity_left, residual_norm, ..Self::default() }
    }

    fn moved(&mut self, increment: f64, whole: bool) {
        self.increment = increment;
        let norm = if whole { increment } else { f64::INFINITY };
        let ratio = norm / self.velocity_norm;
        let falls = self.velocity_norm < f64::INFINITY && ratio < 1.0;
        self.velocity_left = if falls { norm * ratio / (1.0 - ratio) } else { f64::INFINITY };
        self.velocity_norm = norm;
    }
}

#[derive(Clone, Copy)]
pub(super) struct Pass {
    pub start: Start,
    pub matrix: Iteration,
    pub most: usize,
}

pub(super) struct Corrector<'s, 'o> {
    pub step: &'s Step<'s>,
    pub trial: &'s mut Trial,
    pub evaluation: &'s mut Evaluation,
    pub observer: &'o mut dyn Observer,
}

impl Corrector<'_, '_> {
    pub fn correct(&mut self, pass: Pass) -> Outcome {
        let (Step { model, context, .. }, Pass { matrix, most, .. }) = (self.step, pass);
        let mut outcome = Outcome::begun();
        let searches = model.mode != Mode::Flow && self.trial.kept.is_none();
        loop {
            // The last evaluation needs no matrix; it is repeated with one if it was not the last.
            let is_near = outcome.velocity_norm.min(outcome.velocity_left) <= model.settings.tolerance;
            let foreseen = self.trial.kept.is_none() && model.settings.norm == Norm::Velocity && is_near;
            if !self.judge(matrix, foreseen, &mut outcome)
                || (foreseen && !outcome.converged && !self.judge(matrix, false, &mut outcome))
            {
                return outcome;
            }
            let Self { step, trial, evaluation, observer } = self;
            observer.iteration(&Iterate { step, pass, trial, evaluation, outcome: &outcome });
            let looks_back = searches && (1..most).contains(&outcome.iterations) && outcome.residual_norm > ROUND_OFF;
            if let Some(back) = looks_back.then(|| trial.line.back(&evaluation.system)).flatten() {
                trial.advance(context, -back);
                outcome.iterations += 1;
                outcome.moved(velocity_norm(model, trial, back), false);
                continue;
            }
            if outcome.converged || outcome.iterations == most || !trial.line.aim(&mut evaluation.system) {
                // Under a negative pressure that holds a strain rate the sheet bulges to the wrong side.
                let mut held = context.gas_shared.iter().zip(&trial.gas).filter(|(shared, _)| shared.is_some());
                outcome.converged &= !held.any(|(_, pressure)| *pressure < 0.0);
                return outcome;
            }
            if observer.wants_to_stop() {
                outcome.interrupted = true;
                return outcome;
            }
            outcome.iterations += 1;
            let share = allowed_share(context, trial);
            trial.line.length = share;
            trial.advance(context, share);
            // A capped increment says nothing of how far the answer still is.
            outcome.moved(velocity_norm(model, trial, share), share >= 1.0);
        }
    }

    fn judge(&mut self, matrix: Iteration, residual_alone: bool, outcome: &mut Outcome) -> bool {
        let (iteration, velocity_norm) = (outcome.iterations, outcome.velocity_norm);
        let at = Linearisation { matrix, residual_alone, iteration, velocity_norm };
        let sound = evaluate(self.step, self.trial, &at, self.evaluation);
        if sound {
            outcome.residual_norm = self.evaluation.residual_norm;
            outcome.converged = is_converged(self.step.model, self.evaluation, outcome);
        }
        sound
    }
}

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

pub(super) fn allowed_share(context: &RunContext, trial: &Trial) -> f64 {
    let (model, line) = (context.model, &trial.line);
    let t = model.blank.thickness;
    let reach = if model.release.is_some() { LARGEST_SWING } else { LARGEST_MOVE };
    let of_nodes = line.direction.iter().map(|d| (reach * t / d.xy().norm()).min(LARGEST_TURN / d.z.abs()));
    let of_tools = context.tools.iter().filter_map(|tool| Some(LARGEST_MOVE * t / line.shared[tool.shared?].abs()));
    of_nodes.chain(of_tools).fold(1.0, f64::min)
}

/// Relative increment of the velocities by a share of the direction \[–\].
pub(super) fn velocity_norm(model: &Model, trial: &Trial, share: f64) -> f64 {
    let t = model.blank.thickness;
    let (mut change, mut total) = (0.0, 0.0);
    for (d, u) in trial.line.direction.iter().zip(&trial.moves) {
        let weight = [1.0, 1.0, t]; // a turn counts by what it moves a thickness away
        for k in 0..3 {
            change += (weight[k] * share * d[k]).powi(2);
            total += (weight[k] * u[k]).powi(2);
        }
    }
    (change / total.max((STILL * t).powi(2) * trial.moves.len() as f64)).sqrt()
}
