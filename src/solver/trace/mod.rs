//! One step of a run taken apart: predictor and iterations, with any of the corrector's matrices from the same state.
//!
//! ```
//! use stampflow::model::Iteration;
//! use stampflow::solver::trace::{Asked, trace};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # #[cfg(feature = "case")] {
//! let case = stampflow::Case::load("cases/quickstart.toml")?;
//! let asked = Asked { step: 20, ..Asked::default() };
//! let traced = trace(&case.stages, &asked, &mut ())?;
//! let way = &traced.ways[0]; // with the case's own matrix
//! assert!(way.converged && way.iterations().last().expect("at least the predictor").residual_norm < 0.01);
//! # }
//! # Ok(())
//! # }
//! ```

mod asked;
mod before;
mod error;
mod rate;
mod way;

pub use asked::Asked;
pub use error::NoSuchStep;
pub use rate::Rate;
pub use way::{Attempt, Iterated, Pass, Way, key};

use crate::model::{Model, Settings, Stage};
use crate::solver::solution::StepRecord;
use crate::solver::state::State;
use crate::solver::{Observer, try_step};
use before::Before;

/// A step taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// What was asked for.
    pub asked: Asked,
    /// The model of the stage, with its own settings.
    pub model: Model,
    /// The sheet and its tools before the step.
    pub before: State,
    /// The step as the run took it.
    pub record: StepRecord,
    /// Duration of the step \[s\].
    pub dt: f64,
    /// One for each matrix, in the order in which they were named.
    pub ways: Vec<Way>,
}

impl Trace {
    /// What the norm has come down to where the step counts as solved \[–\].
    pub fn tolerance(&self) -> f64 {
        self.asked.tolerance.unwrap_or(self.model.settings.tolerance)
    }
}

/// Runs stages with their own matrix up to a step, and takes that apart; `observer` looks on at the run and may end it.
///
/// # Errors
/// When the run has no such step.
pub fn trace(stages: &[Stage], asked: &Asked, observer: &mut dyn Observer) -> Result<Trace, NoSuchStep> {
    let Before { model, state, record, dt } = before::before(stages, asked, observer)?;
    let own = [model.settings.iteration];
    let matrices = if asked.matrices.is_empty() { &own[..] } else { &asked.matrices };
    let ways = matrices.iter().map(|&matrix| {
        let mut model = model.clone();
        let tolerance = asked.tolerance.unwrap_or(model.settings.tolerance);
        model.settings = Settings { iteration: matrix, tolerance, ..model.settings };
        let mut attempts = way::Attempts::default();
        let converged = try_step(&model, &state, dt, asked.step, &mut attempts);
        Way { matrix, attempts: attempts.0, converged }
    });
    let ways = ways.collect();
    Ok(Trace { asked: asked.clone(), before: state, record, dt, ways, model })
}
