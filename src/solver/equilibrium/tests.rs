//! The whole matrix against differences.

use super::*;
use crate::geometry::Profile;
use crate::material::{Elastic, Gtn, Hardening, Hill48, Rate, ThermalLaw, hardening::Swift};
use crate::model::{Bead, Blank, Face, Friction, Gas, Grading, Heat, Press, RateControl};
use crate::numerics::block_tridiagonal::MAX_SHARED;

/// A blank of so many elements without tools, solved with Newton's matrix.
pub fn bare(geometry: Geometry, theory: Theory, length: f64, thickness: f64, elements: usize) -> Model {
    let layers = if theory == Theory::Membrane { 1 } else { 5 };
    let blank = Blank { elements, grading: Grading::Uniform, theory, layers, ..Blank::new(length, thickness) };
    let material = Material::plain(Hardening::Swift(Swift::new(500.0, 0.2, 1e-3).expect("valid")));
    let settings = Settings { iteration: Iteration::Newton, ..Settings::default() };
    Model { geometry, timed: true, settings, ..Model::new(blank, material, vec![], 1.0) }
}

pub const NEWTON: Linearisation =
    Linearisation { matrix: Iteration::Newton, residual_alone: false, iteration: 0, velocity_norm: 0.0 };

/// Calls `test` with the second step of a run from `state` and a predicted trial.
pub fn with_step<T>(
    model: &Model, state: &State, (dt, from_rest): (f64, bool),
    test: impl FnOnce(&Step, &mut Trial, &mut Evaluation) -> T,
) -> T {
    let context = RunContext::new(model, state);
    let step = Step::new(&context, state, dt, 2);
    let (mut trial, mut evaluation) = (Trial::new(&context, state), Evaluation::new(&context, state));
    trial.predict(&step, from_rest);
    test(&step, &mut trial, &mut evaluation)
}

fn model(geometry: Geometry, theory: Theory) -> Model {
    let t = 1.0;
    let tool = |role, profile, motion| Tool { role, profile, friction: 0.12.into(), motion };
    let force = if geometry == Geometry::Axisymmetric { 9e3 } else { 120.0 };
    let tools = vec![
        tool(Role::Punch, Profile::flat_punch(12.0, 4.0, t), Motion::Travel),
        tool(Role::Die, Profile::die(13.3, 4.0, t), Motion::Fixed),
        tool(Role::Holder, Profile::holder(17.3, t), Motion::Pressed(Press { force: force.into(), stiffness: 30.0 })),
    ];
    let beads = vec![Bead { at: 21.0, restraining: 20.0.into(), closing: 5.0, round: None }];
    let gas = vec![Gas { face: Face::Upper, pressure: 3.0.into(), within: 15.0 }];
    let [travel, duration] = [6.0; 2];
    Model { tools, beads, gas, travel, duration, frames: vec![6.0], ..bare(geometry, theory, 24.0, t, 12) }
}

fn formed(model: &Model) -> State {
    let mut model = model.clone();
    model.settings.iteration = Iteration::PrimalDual;
    let run = run(&model, &mut ());
    assert!(run.stop.is_complete(), "{}", run.stop);
    run.end
}

/// Trust: central differences of the whole residual, at a state in the middle of a draw that is disturbed off
/// equilibrium: elements, contact, friction, thinning under contact and the holder's border all in one.
#[test]
fn matrix_is_the_derivative_of_the_residual() {
    for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
        for theory in [Theory::Bending, Theory::Membrane] {
            let state = formed(&model(geometry, theory));
            check(&model(geometry, theory), &state);
            // The same state with the gas as an unknown that holds a strain rate, or sits on a cap far below.
            for max_pressure in [f64::INFINITY, 1e-3] {
                let mut held = model(geometry, theory);
                held.gas[0].pressure = Pressure::Rate(RateControl { max_pressure, ..RateControl::new(0.02, 6.0) });
                check(&held, &state);
            }
        }
    }
}

/// Trust: as above, for a porous sheet with a rate, r̄ and a softening law at 150 °C under tools with other friction laws than
/// Coulomb's, and for the elastoplastic law with back-stresses that do not fade, on a sheet whose volume has changed.
#[test]
fn matrix_of_other_metals_is_the_derivative_of_the_residual() {
    for theory in [Theory::Bending, Theory::Membrane] {
        let mut voided = model(Geometry::Axisymmetric, theory);
        voided.material.gtn = Some(Gtn { initial: 0.03, nucleation: None, coalescence: None, ..Gtn::example() });
        voided.material.yield_criterion = Hill48::new(1.4).into();
        voided.material.rate = Rate::examples().into_iter().map(|(_, law)| law).next();
        voided.material.thermal = ThermalLaw::examples().into_iter().map(|(_, law)| law).next();
        voided.heat = Some(Heat { initial: 423.15.into(), flow: None });
        let laws = Friction::examples().into_iter().filter(|(_, law)| !matches!(law, Friction::Coulomb(_)));
        voided.tools.iter_mut().zip(laws).for_each(|(tool, (_, law))| tool.friction = law);
        let state = formed(&voided);
        assert!(state.points.iter().any(|point| point.porosity > 0.03));
        check(&voided, &state);
        for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
            let mut elastoplastic = model(geometry, theory);
            elastoplastic.mode = Mode::ElastoViscoplastic;
            elastoplastic.material.elastic = Some(Elastic { young: 70_000.0, poisson: 0.33 });
            elastoplastic.material.chaboche[0].modulus = 300.0;
            let state = formed(&elastoplastic);
            assert!(state.dilation.iter().any(|dilation| dilation.abs() > 1e-4), "{geometry:?}, {theory:?}");
            check(&elastoplastic, &state);
        }
    }
}

fn unknown<'t>(trial: &'t mut Trial, context: &RunContext, k: usize) -> &'t mut f64 {
    let n = trial.moves.len();
    if k < 3 * n {
        return &mut trial.moves[k / 3][k % 3];
    }
    match context.tools.iter().position(|tool| tool.shared == Some(k - 3 * n)) {
        Some(j) => &mut trial.tools[j].y,
        None => &mut trial.gas[0],
    }
}

fn column(system: &System, k: usize) -> Vec<f64> {
    let n = system.diagonal.len();
    let (j, d) = (k / 3, k % 3);
    let block = |i: usize| match i.wrapping_sub(j) {
        _ if k >= 3 * n => system.columns[i][k - 3 * n],
        0 => system.diagonal[i].column(d).into_owned(),
        1 => system.lower[i].column(d).into_owned(),
        usize::MAX => system.upper[i].column(d).into_owned(),
        _ => Vector3::zeros(),
    };
    let border = |s: usize| if k < 3 * n { system.rows[j][s][d] } else { system.corner[(s, k - 3 * n)] };
    (0..n).flat_map(|i| <[f64; 3]>::from(block(i))).chain((0..MAX_SHARED).map(border)).collect()
}

fn check(model: &Model, state: &State) {
    with_step(model, state, (0.05, false), |step, trial, evaluation| {
        for (i, x) in trial.moves.iter_mut().enumerate() {
            let wave = (i as f64 * 1.7).sin();
            x[0] += if i == 0 { 0.0 } else { 2e-4 * wave };
            x[1] += 2e-4 * (i as f64 * 2.3).cos();
            x[2] += if i == 0 || model.blank.theory == Theory::Membrane { 0.0 } else { 3e-4 * wave };
        }
        compare(step, trial, evaluation);
    });
}

fn compare(step: &Step, trial: &mut Trial, evaluation: &mut Evaluation) {
    let context = step.context;
    // A velocity norm of zero: H is the derivative only without the membrane's least tension.
    let mut at = |trial: &mut Trial| {
        assert!(evaluate(step, trial, &NEWTON, evaluation));
        evaluation.system.clone()
    };
    let residual = |system: &System| -> Vec<f64> {
        let nodes = system.rhs.iter().flat_map(|f| <[f64; 3]>::from(*f));
        nodes.chain(system.corner_rhs.iter().copied()).map(|f| -f).collect()
    };
    let exact = at(trial);
    let n = step.state.nodes.len();
    let gas = context.gas_shared[0].map(|k| 3 * n + k);
    let held = |k: usize| k < 3 && k != 1 || k < 3 * n && k % 3 == 2 && step.model.blank.theory == Theory::Membrane;
    for k in (0..3 * n + context.shared).filter(|k| !held(*k)) {
        let (x, h) = (*unknown(trial, context, k), if gas == Some(k) { 1e-6 } else { 1e-8 });
        let [plus, minus] = [x + h, x - h].map(|moved| {
            *unknown(trial, context, k) = moved;
            residual(&at(trial))
        });
        *unknown(trial, context, k) = x;
        let expected = column(&exact, k);
        for row in (0..3 * n + context.shared).filter(|row| !held(*row)) {
            let difference = (plus[row] - minus[row]) / (2.0 * h);
            let scale = match (gas == Some(k), row.checked_sub(3 * n)) {
                (true, None) => 0.5 * exact.columns[row / 3][k - 3 * n].norm().max(1e-3),
                (false, None) => exact.diagonal[row / 3].norm(),
                (_, Some(s)) if gas == Some(row) && k < 3 * n => {
                    5.0 * exact.rows.iter().map(|rows| rows[s].norm()).fold(0.0, f64::max)
                }
                (_, Some(_)) if k < 3 * n => exact.diagonal[n - 1].norm(),
                (_, Some(_)) => expected[row].abs().max(1.0),
            };
            let error = (difference - expected[row]).abs();
            assert!(error <= 2e-5 * scale, "row {row} by {k} of {n} nodes: {difference} {}", expected[row]);
        }
    }
}

#[path = "../../theory/tests.rs"]
mod theory;
