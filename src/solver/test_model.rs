//! Small models and steps for unit tests.

use super::evaluation::{Evaluation, Linearisation};
use super::run_context::RunContext;
use super::step::Step;
use super::trial::Trial;
use crate::element::{Geometry, Theory};
use crate::material::hardening::Swift;
use crate::material::{Hardening, Material};
use crate::model::{Blank, Edge, Grading, Iteration, Mode, Model, Settings};
use crate::solver::state::State;

/// A blank of so many elements without tools, solved with Newton's matrix.
pub fn bare(geometry: Geometry, theory: Theory, length: f64, thickness: f64, elements: usize) -> Model {
    Model {
        title: "test".into(),
        notes: vec![],
        geometry,
        depth: None,
        blank: Blank {
            length,
            thickness,
            elements,
            grading: Grading::Uniform,
            theory,
            layers: if theory == Theory::Membrane { 1 } else { 5 },
            rule: Default::default(),
            edge: Edge::Free,
        },
        material: Material::plain(Hardening::Swift(Swift::new(500.0, 0.2, 1e-3).expect("valid"))),
        tools: vec![],
        beads: vec![],
        gas: vec![],
        heat: None,
        travel: 1.0,
        schedule: None,
        speed: 1.0,
        duration: 1.0,
        stop: Default::default(),
        timed: true,
        frames: vec![1.0],
        settings: Settings { iteration: Iteration::Newton, ..Settings::default() },
        mode: Mode::default(),
        release: None,
        forming_limit: None,
    }
}

pub const NEWTON: Linearisation =
    Linearisation { matrix: Iteration::Newton, residual_alone: false, iteration: 0, velocity_norm: 0.0 };

/// Calls `test` with the second step of a run from `state` and a predicted trial.
pub fn with_step<T>(
    model: &Model,
    state: &State,
    (dt, from_rest): (f64, bool),
    test: impl FnOnce(&Step, &mut Trial, &mut Evaluation) -> T,
) -> T {
    let context = RunContext::new(model, state);
    let step = Step::new(&context, state, dt, 2);
    let (mut trial, mut evaluation) = (Trial::new(&context, state), Evaluation::new(&context, state));
    trial.predict(&step, from_rest);
    test(&step, &mut trial, &mut evaluation)
}
