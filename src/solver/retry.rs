//! Starts from which a step is tried before it is halved.

use super::corrector::{Pass, correct, patience};
use super::*;
use crate::model::ContactMethod;

/// Starting point of the corrector; when one fails the next is tried before the step is halved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Velocities at the end of the last step.
    Predictor,
    /// A few iterations with the secant matrix from rest: no motion but the tools'.
    Secant,
    /// Solution with a many times larger cut-off, itself started from rest.
    Softened,
    /// Softened start that reduces the cut-off in steps: for a sheet at rest nearly everywhere, as after a trim.
    SoftenedInSteps,
}

impl Start {
    const USUAL: &[Start] = &[Start::Predictor, Start::Secant, Start::Softened];
    /// Order of the first step: nothing has moved yet; velocities of the stage before may help.
    const FIRST: &[Start] = &[Start::Secant, Start::Softened, Start::SoftenedInSteps, Start::Predictor];

    /// Name in tables.
    pub fn key(self) -> &'static str {
        ["predictor", "secant", "softened", "softened_in_steps"][self as usize]
    }

    /// Factors on the cut-off for the passes before the last.
    fn softening(self) -> &'static [f64] {
        match self {
            Start::Predictor | Start::Secant => &[],
            Start::Softened => &[30.0],
            Start::SoftenedInSteps => &[30.0, 10.0, 3.0],
        }
    }

    pub(super) fn count(self, effort: &mut Effort) {
        effort.predictor += usize::from(self == Start::Predictor);
        effort.secant += usize::from(self == Start::Secant);
        effort.softened += usize::from(!self.softening().is_empty());
    }
}

const SECANT_START: usize = 15;
/// Most rounds of the augmented Lagrangian in a step; two or three are usual.
const MOST_ROUNDS: usize = 40;

/// Tries a step from each start until one converges; counts the others in `rejected`.
pub(super) fn solve<'s>(
    step: &'s Step<'s>,
    trial: &'s mut Trial,
    evaluation: &'s mut Evaluation,
    rejected: &mut usize,
    observer: &mut dyn Observer,
) -> Result<(Start, Converged<'s>), Outcome> {
    let mut outcome = Outcome::BEGUN;
    let from_rest = step.number == 1 || !step.model.settings.predictor;
    for &start in if from_rest { Start::FIRST } else { Start::USUAL } {
        outcome = attempt(step, trial, evaluation, start, observer);
        if outcome.converged {
            return Ok((start, Converged::new(step, trial, evaluation, outcome)));
        }
        *rejected += 1;
        if outcome.interrupted {
            break;
        }
    }
    Err(outcome)
}

fn attempt(step: &Step, trial: &mut Trial, out: &mut Evaluation, start: Start, observer: &mut dyn Observer) -> Outcome {
    let settings = &step.model.settings;
    let matrix = settings.iteration;
    let most = settings.max_iterations * patience(if trial.kept.is_some() { Iteration::Secant } else { matrix });
    let mut correct = |trial: &mut Trial, out: &mut Evaluation, matrix, most| {
        correct(step, trial, out, Pass { start, matrix, most }, observer)
    };
    trial.predict(step, start != Start::Predictor);
    let mut spent = 0;
    for &softening in start.softening() {
        trial.softening = softening;
        let soft = correct(trial, out, matrix, most);
        trial.softening = 1.0;
        if !soft.converged {
            return soft;
        }
        spent += soft.iterations;
    }
    if start == Start::Secant {
        let secant = correct(trial, out, Iteration::Secant, SECANT_START);
        if secant.interrupted {
            return secant;
        }
        spent = secant.iterations;
    }
    let mut outcome = correct(trial, out, matrix, most);
    let most_rounds = if settings.contact == ContactMethod::AugmentedLagrangian { MOST_ROUNDS } else { 0 };
    let mut rounds = 1;
    while rounds <= most_rounds && outcome.converged && augmented_lagrangian::shift(trial, out, rounds - 1) {
        spent += outcome.iterations;
        rounds += 1;
        outcome = correct(trial, out, matrix, most);
    }
    Outcome { iterations: outcome.iterations + spent, rounds, ..outcome }
}

/// Solves the `number`-th step of a run by itself, `dt` \[s\] long; only the first guesses of elastoplastic points differ.
pub fn try_step(model: &Model, state: &State, dt: f64, number: usize, observer: &mut dyn Observer) -> Option<State> {
    let mut state = state.clone();
    let mut context = RunContext::new(model);
    while let Some(tool) = context.release(&state) {
        state.release(tool);
    }
    let (mut trial, mut evaluation) = (Trial::new(&context, &state), Evaluation::new(&context, &state));
    let step = Step::new(&context, &state, dt, number);
    let solved = solve(&step, &mut trial, &mut evaluation, &mut 0, observer);
    solved.ok().map(|(_, converged)| converged.advanced())
}
