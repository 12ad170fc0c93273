//! One step by itself, for those who look at how it comes to equilibrium.

use super::evaluation::Evaluation;
use super::observer::Observer;
use super::process::Process;
use super::retry;
use super::step::Step;
use super::trial::Trial;
use crate::model::Model;
use crate::solver::state::State;

/// Tries a step of `dt` \[s\] from a state of a run, its `number`-th, from start to start until one brings it to equilibrium;
/// whether one did.
///
/// The iterations are those of the run that the state is from, but for what elastoplastic points guess first, which a run
/// takes from the step before.
pub fn try_step(model: &Model, state: &State, dt: f64, number: usize, observer: &mut dyn Observer) -> bool {
    let mut state = state.clone();
    let mut process = Process::new(model, &state);
    while let Some(tool) = process.release(&state) {
        state.release(tool);
    }
    let (mut trial, mut evaluation) = (Trial::new(&process, &state), Evaluation::new(&process, &state));
    let step = Step::new(&process, &state, dt, number);
    retry::solve(&step, &mut trial, &mut evaluation, &mut 0, observer).is_ok()
}
