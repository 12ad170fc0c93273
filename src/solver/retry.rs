//! Starts from which a step is tried before it is halved.

use super::{corrector::Corrector, corrector::Pass, corrector::patience, *};
use crate::model::ContactMethod;

named! {
    /// Starting point of the corrector; when one fails the next is tried before the step is halved.
    pub enum Start;
    /// Name in tables.
    fn key;
    Predictor: "predictor", "Velocities at the end of the last step.";
    Secant: "secant", "A few iterations with the secant matrix from rest: no motion but the tools'.";
    Softened: "softened", "Solution with a many times larger cut-off, itself started from rest.";
    SoftenedInSteps: "softened_in_steps", "Softened start that reduces the cut-off in steps: for a sheet at rest nearly everywhere, as after a trim.";
}

impl Start {
    const USUAL: &[Start] = &[Start::Predictor, Start::Secant, Start::Softened];
    /// Order of the first step: nothing has moved yet; velocities of the stage before may help.
    const FIRST: &[Start] = &[Start::Secant, Start::Softened, Start::SoftenedInSteps, Start::Predictor];

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
const MOST_ROUNDS: usize = 40;

impl<'s> Corrector<'s, '_> {
    /// Tries the step from each start until one converges; counts the others in `rejected`.
    pub fn solve(mut self, rejected: &mut usize) -> Result<(Start, Converged<'s>), Outcome> {
        let mut outcome = Outcome::begun();
        let from_rest = self.step.number == 1 || !self.step.model.settings.predictor;
        for &start in if from_rest { Start::FIRST } else { Start::USUAL } {
            outcome = self.attempt(start);
            if outcome.converged {
                return Ok((start, Converged::new(self.step, self.trial, self.evaluation, outcome)));
            }
            *rejected += 1;
            if outcome.interrupted {
                break;
            }
        }
        Err(outcome)
    }

    fn attempt(&mut self, start: Start) -> Outcome {
        let settings = &self.step.model.settings;
        let matrix = settings.iteration;
        let slowest = if self.trial.kept.is_some() { Iteration::Secant } else { matrix };
        let pass = Pass { start, matrix, most: settings.max_iterations * patience(slowest) };
        self.trial.predict(self.step, start != Start::Predictor);
        let mut spent = 0;
        for &softening in start.softening() {
            self.trial.softening = softening;
            let soft = self.correct(pass);
            self.trial.softening = 1.0;
            if !soft.converged {
                return soft;
            }
            spent += soft.iterations;
        }
        if start == Start::Secant {
            let secant = self.correct(Pass { matrix: Iteration::Secant, most: SECANT_START, ..pass });
            if secant.interrupted {
                return secant;
            }
            spent = secant.iterations;
        }
        let mut outcome = self.correct(pass);
        let most = if settings.contact == ContactMethod::AugmentedLagrangian { MOST_ROUNDS } else { 0 };
        let mut rounds = 1;
        while rounds <= most
            && outcome.converged
            && augmented_lagrangian::shift(self.trial, self.evaluation, rounds - 1)
        {
            spent += outcome.iterations;
            rounds += 1;
            outcome = self.correct(pass);
        }
        Outcome { iterations: outcome.iterations + spent, rounds, ..outcome }
    }
}

/// Solves the `number`-th step of a run by itself, `dt` \[s\] long; only the first guesses of elastoplastic points differ.
pub fn try_step(model: &Model, state: &State, dt: f64, number: usize, observer: &mut dyn Observer) -> Option<State> {
    let mut state = state.clone();
    let mut context = RunContext::new(model, &state);
    while let Some(tool) = context.release(&state) {
        state.release(tool);
    }
    let (mut trial, mut evaluation) = (Trial::new(&context, &state), Evaluation::new(&context, &state));
    let step = Step::new(&context, &state, dt, number);
    let corrector = Corrector { step: &step, trial: &mut trial, evaluation: &mut evaluation, observer };
    corrector.solve(&mut 0).ok().map(|(_, converged)| converged.advanced())
}
