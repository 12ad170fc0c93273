//! One step by itself.

use super::evaluation::Evaluation;
use super::observer::Observer;
use super::retry;
use super::run_context::RunContext;
use super::step::Step;
use super::trial::Trial;
use crate::model::Model;
use crate::solver::state::State;

/// Solves the `number`-th step of a run by itself, `dt` \[s\] long; returns the state after it where one start converges.
///
/// The iterations are those of the run, but for the first guesses of elastoplastic points, which a run takes from the step
/// before.
pub fn try_step(model: &Model, state: &State, dt: f64, number: usize, observer: &mut dyn Observer) -> Option<State> {
    let mut state = state.clone();
    let mut context = RunContext::new(model, &state);
    while let Some(tool) = context.release(&state) {
        state.release(tool);
    }
    let (mut trial, mut evaluation) = (Trial::new(&context, &state), Evaluation::new(&context, &state));
    let step = Step::new(&context, &state, dt, number);
    let solved = retry::solve(&step, &mut trial, &mut evaluation, &mut 0, observer);
    solved.ok().map(|(_, converged)| converged.advanced())
}
