//! Random numbers for every equation of `docs/theory.md`: what goes into the functions that the page names, and what comes out.

use super::{NEWTON, bare, with_step};
use crate::contact::penalty::Penalty;
use crate::element::theory::{element, stress, surface, tangent};
use crate::element::{Geometry, Theory, surface::STATIONS};
use crate::equations::{Check, Matrix, Random, Symbols, column, samples};
use crate::geometry::Profile;
use crate::material::elastoplastic::{Carried, ElastoplasticLaw, Operators, Trial};
use crate::material::flow::{FlowLaw, Iterate, PointState, Tangent, YieldCondition};
use crate::material::fracture::{Brozzo, CockcroftLatham, Fracture, FractureStress, Oyane, RiceTracey};
use crate::material::{BackStress, Elastic, Gtn, Hardening, Hill48, Hosford, PointLaw, Rate, Surroundings, ThermalLaw};
use crate::material::{hardening::Swift, rate::CowperSymonds, rate::PowerRate, thermal::Exponential};
use crate::model::{Edge, Face, Gas, Iteration, Model, Motion, Role, Tool};
use crate::numerics::block_tridiagonal::System;
use crate::solver::evaluation::{ContactPosition, Evaluation};
use crate::solver::{corrector::allowed_share, corrector::velocity_norm, terms, trial};
use crate::solver::{equilibrium::evaluate, retry::try_step, run_context::RunContext, state::State, step::Step};
use nalgebra::{Matrix3, Vector3};
use std::array::from_fn;

/// Errors are of sums that cancel, and of functions that iterate.
const CHECKS: [Check; 9] = [
    (&[1, 2, 3, 16, 18, 19, 33], element, 1e-9),
    (&[5, 6, 7, 10, 8, 9, 23, 24, 25], flow, 1e-9),
    (&[11, 12, 13, 14, 15], yielding, 1e-9),
    (&[4, 17, 20, 22], sheet, 1e-9),
    (&[5, 21], predictor, 1e-12),
    (&[26, 27], increment, 1e-12),
    (&[28], surface, 1e-12),
    (&[29, 30], contact, 1e-9),
    (&[31, 32], elastic, 1e-8),
];

fn flow(u: Random) -> Symbols {
    let hardening = Hardening::Swift(Swift::new(u(300.0, 600.0), u(0.1, 0.3), u(1e-3, 1e-2)).expect("valid"));
    let rate = Rate::PowerRate(PowerRate { exponent: u(0.01, 0.1), reference: 1e-3 });
    let thermal = ThermalLaw::Exponential(Exponential { coefficient: 0.003, reference: 293.0 });
    let surroundings = Surroundings { exponent: u(1e-3, 5e-3), increment: u(1e-3, 2e-3), floor: u(1e-5, 1e-4) };
    let ([dt, before], cutoff, start) = ([u(0.05, 0.2), u(0.05, 0.2)], u(1e-4, 1e-3), u(0.01, 0.3));
    let [e, last, past] = [0; 3].map(|_| [0; 5].map(|_| u(2e-3, 8e-3)));
    let (weight, hill) = (dt / (dt + before), Hill48::default());
    let size = |e: [f64; 5]| hill.layer([e[0], e[1], e[4]], [e[2], e[3]], None).square.sqrt();
    let point = PointState { temperature: u(300.0, 400.0), surroundings, ..PointState::at(start) };
    let point = point.following([past[0], past[1], past[4]], [past[2], past[3]], weight, hill.into(), None);
    let respond = |matrix: Iteration, iterate: &mut Iterate, e: [f64; 5]| {
        let (softening, criterion, duration) = (Some(&thermal), hill.into(), dt);
        let hardening = &hardening;
        let law = FlowLaw { hardening, rate: Some(&rate), softening, criterion, voids: None, matrix, cutoff, duration };
        law.respond(&point, iterate, [e[0], e[1], e[4]], [e[2], e[3]])
    };
    let (update, secant) = respond(Iteration::Secant, &mut Iterate::default(), e);
    let newton = respond(Iteration::Newton, &mut Iterate::default(), e).1;
    let mut iterate = Iterate::start([u(100.0, 300.0), u(100.0, 300.0), 0.0]);
    let (first, first_matrix) = respond(Iteration::PrimalDual, &mut iterate, last);
    let dual = respond(Iteration::PrimalDual, &mut iterate, e).1;
    let steep = 1.0 + weight;
    let flow: [f64; 5] = from_fn(|i| steep * e[i] - weight * past[i]);
    let regular = size(flow).hypot(cutoff);
    // The two matrices differ by f g − w, over the square of the rate.
    let [[g, n], [_, d]] = [newton.outer, dual.outer];
    let apart = |i: usize| 2.0 * (n[i] - d[i]) / steep * regular * regular;
    let carried: [f64; 5] = from_fn(|i| update.yield_stress / regular * g[i] + apart(i));
    let along = |matrix: &Tangent| (column(&flow).transpose() * tangent(matrix) * column(&flow))[0];
    let (hardened, factor) = (hardening.at(start + update.increment), rate.at(regular / dt));
    let mut known = Symbols::default();
    known.numbers(r"\Delta t, \Delta t_-, \omega, c_T", [dt, before, weight, thermal.at(point.temperature)]);
    let Surroundings { exponent, increment, floor } = surroundings;
    let rates = [cutoff, increment, floor].map(|e| e / dt);
    known.numbers(r"\dot\varepsilon_0, \dot\varepsilon_n, \dot\varepsilon_{\min}", rates);
    known.numbers(r"m_n, \bar\varepsilon_b, \bar\varepsilon", [exponent, start, start + update.increment]);
    known.numbers(r"\dot{\bar\varepsilon}_-, \sigma_y", [size(past) / dt, update.yield_stress]);
    known.numbers(r"\sigma_h, \sigma_h'", [hardened.stress, hardened.slope]);
    known.numbers(r"c_{\dot\varepsilon}, c_{\dot\varepsilon}'", [factor.value, factor.slope]);
    known.numbers(r"\lambda", [1.0 - along(&newton) / along(&secant)]);
    known.column(r"\Delta\mathbf e", &e);
    known.column(r"\dot{\mathbf e}_-", &past.map(|e| e / dt));
    known.column(r"\delta\mathbf e", &from_fn::<f64, 5, _>(|i| e[i] - last[i]));
    known.column(r"\mathbf w", &carried);
    known.set(r"\boldsymbol\sigma", [stress(&update)]);
    known.set(r"\boldsymbol\sigma_-", [stress(&first)]);
    for (name, matrix) in [("S", secant), ("N", newton), ("P", dual), ("-", first_matrix)] {
        known.set(&format!(r"\mathbf C_{name}"), [tangent(&matrix)]);
    }
    known
}

fn yielding(u: Random) -> Symbols {
    let (r, exponent, strength, porosity) = (u(0.5, 2.0), u(4.0, 9.0), u(200.0, 400.0), u(0.0, 0.1));
    let (hill, hosford) = (Hill48::new(r), Hosford::new(r, exponent));
    let voids =
        Gtn { q1: u(1.0, 1.5), q2: u(0.8, 1.2), q3: u(1.0, 2.0), initial: 0.01, nucleation: None, coalescence: None };
    let s = voids.condition(hill, porosity).stress([u(0.5, 1.0), u(0.0, 1.0), 0.0]).map(|s| strength * s);
    let tear = FractureStress::new(&hosford.into(), s, 0.0);
    let (increment, a, rate, temperature) = (u(0.01, 0.1), u(0.2, 0.6), u(0.01, 10.0), u(300.0, 500.0));
    let power = PowerRate { exponent: u(0.01, 0.5), reference: u(0.01, 1.0) };
    let cowper = CowperSymonds { rate: u(10.0, 50.0), exponent: u(2.0, 6.0) };
    let soft = Exponential { coefficient: u(1e-3, 5e-3), reference: u(280.0, 300.0) };
    let (critical, mut known) = (1.0, Symbols::default());
    let damage = |law: Fracture| increment * law.at(tear);
    known.numbers(r"\bar r, M, \sigma_s, \sigma_\theta, \sigma_y", [r, exponent, s[0], s[1], strength]);
    known.numbers("f, q_1, q_2, q_3", [voids.effective(porosity), voids.q1, voids.q2, voids.q3]);
    known.numbers(r"\bar\sigma_H, \bar\sigma", [hill.equivalent_stress(s), hosford.equivalent_stress(s)]);
    let [direct, coupled, _] = hill.apply([1.0, 0.0, 0.0]);
    known.numbers(r"A_{11}, A_{12}, \sigma_1, \sigma_m", [direct, coupled, tear.largest, tear.mean]);
    known.numbers(r"b_O, \Delta\bar\varepsilon, \dot\varepsilon_r, T", [a, increment, rate, temperature]);
    known.numbers(r"\dot\varepsilon_P, m_P, \dot\varepsilon_S", [power.reference, power.exponent, cowper.rate]);
    known.numbers(r"m_S, b_T, T_0", [cowper.exponent, soft.coefficient, soft.reference]);
    known.numbers("c_P, c_S", [Rate::PowerRate(power), Rate::CowperSymonds(cowper)].map(|law| law.at(rate).value));
    known.numbers("c_T", [ThermalLaw::Exponential(soft).at(temperature)]);
    known.numbers(r"\Omega_C", [damage(Fracture::CockcroftLatham(CockcroftLatham { critical }))]);
    known.numbers(r"\Omega_B", [damage(Fracture::Brozzo(Brozzo { critical }))]);
    known.numbers(r"\Omega_O", [damage(Fracture::Oyane(Oyane { a, critical }))]);
    known.numbers(r"\Omega_R", [damage(Fracture::RiceTracey(RiceTracey { critical }))]);
    known
}

/// A clamped disk of four elements with a gas above it.
fn disk(tools: Vec<Tool>) -> (Model, State) {
    let gas = vec![Gas { face: Face::Upper, pressure: 3.0.into(), within: 20.0 }];
    let mut model = Model { tools, gas, ..bare(Geometry::Axisymmetric, Theory::Bending, 20.0, 1.0, 4) };
    model.blank.edge = Edge::Clamped;
    let state = State::initial(&model, (0..=4).map(|i| 5.0 * f64::from(i)).collect());
    (model, state)
}

/// Free unknowns of the disk, on the axis only z: their node and freedom.
const FREE: [(usize, usize); 10] = [(0, 1), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2), (3, 0), (3, 1), (3, 2)];

fn dense(system: &System) -> (Matrix, Matrix) {
    let block = |i: usize, j: usize| match i as isize - j as isize {
        -1 => system.upper[i],
        0 => system.diagonal[i],
        1 => system.lower[i],
        _ => Matrix3::zeros(),
    };
    let entries = FREE.map(|(i, d)| FREE.map(|(j, c)| block(i, j)[(d, c)]));
    (column(&FREE.map(|(i, d)| system.rhs[i][d])), Matrix::from_row_slice(10, 10, &entries.concat()))
}

fn sheet(u: Random) -> Symbols {
    let (model, state) = disk(vec![]);
    let context = RunContext::new(&model, &state);
    let (mut trial, mut out) = (trial::Trial::new(&context, &state), Evaluation::new(&context, &state));
    let mut step = Step::new(&context, &state, 0.05, 2);
    trial.predict(&step, true);
    trial.moves = (0..5).map(|i| [u(0.0, 0.1) * f64::from(i.min(1)), u(-0.1, 0.1), 0.0]).collect();
    assert!(evaluate(&step, &mut trial, &NEWTON, &mut out));
    let mut known = Symbols::default();
    known.list("t_b", state.thickness.clone());
    known.list("t", out.thickness.clone());
    known.list(r"\Delta\varepsilon_s", out.membrane_increment.iter().map(|e| e[0]));
    known.list(r"\Delta\varepsilon_\theta", out.membrane_increment.iter().map(|e| e[1]));
    let (forces, matrix) = dense(&out.system);
    known.set(r"\mathbf R", [-forces]);
    known.set(r"\mathbf H", [matrix]);
    assert!(out.system.solve());
    known.set(r"\delta\mathbf a", [dense(&out.system).0]);
    let gas = |out: &Evaluation| nalgebra::DVector::from_fn(10, |k, _| out.gas_force[FREE[k].0].push(0.0)[FREE[k].1]);
    known.column(r"\mathbf F_X", gas(&out).as_slice());
    // Central differences of a function of second degree.
    let columns = FREE.map(|(i, d)| {
        let [plus, minus] = [1e-3, -2e-3].map(|h| {
            trial.moves[i][d] += h;
            assert!(evaluate(&step, &mut trial, &NEWTON, &mut out));
            gas(&out)
        });
        trial.moves[i][d] += 1e-3;
        (plus - minus) / 2e-3
    });
    known.set(r"\partial\mathbf F_X", [Matrix::from_columns(&columns)]);
    known.numbers(r"\partial\mathbf a", [1.0]);
    // One element at a time.
    let volume = std::mem::take(&mut step.volume);
    let elements = [0, 1, 2, 3].map(|e| {
        step.volume = (0..4).map(|i| if i == e { volume[i] } else { 0.0 }).collect();
        out.system.clear();
        assert!(terms::sheet::add(&step, &mut trial, &NEWTON, &mut out));
        dense(&out.system)
    });
    known.set(r"\mathbf F_I", elements.each_ref().map(|(forces, _)| -forces));
    known.set(r"\mathbf K", elements.map(|(_, matrix)| matrix));
    known
}

fn predictor(u: Random) -> Symbols {
    let (model, state) = disk(vec![]);
    let mut model = Model { gas: vec![], geometry: Geometry::PlaneStrain, ..model };
    model.blank.edge = Edge::Pulled { speed: 1.0 };
    let before = try_step(&model, &state, u(0.02, 0.05), 1, &mut ()).expect("equilibrium");
    let after = try_step(&model, &before, u(0.02, 0.05), 2, &mut ()).expect("equilibrium");
    let mut known = Symbols::default();
    known.numbers(r"\Delta t, \Delta t_-", [after.last_step, before.last_step]);
    known.column(r"\dot{\mathbf a}", after.velocity.as_flattened());
    known.column(r"\dot{\mathbf a}_-", before.velocity.as_flattened());
    known.column(r"\dot{\mathbf a}_P", after.end_velocity.as_flattened());
    known
}

fn increment(u: Random) -> Symbols {
    let (model, state) = disk(vec![]);
    with_step(&model, &state, (0.05, true), |step, trial, _| {
        let mut known = Symbols::default();
        for (d, name) in ["r_j", "z_j", r"\theta_j"].into_iter().enumerate() {
            trial.moves.iter_mut().for_each(|x| x[d] = u(-0.1, 0.1));
            trial.line.direction.iter_mut().for_each(|x| x[d] = u(-0.1, 0.1));
            known.list(&format!(r"\Delta {name}"), trial.moves.iter().map(|x| x[d]));
            known.list(&format!(r"\delta {name}"), trial.line.direction.iter().map(|x| x[d]));
        }
        known.numbers(r"t_0, \psi", [model.blank.thickness, velocity_norm(&model, trial, 1.0)]);
        trial.line.direction.fill(Vector3::zeros());
        trial.line.direction[2] = Vector3::new(u(-0.8, 0.8), u(-0.8, 0.8), u(-0.6, 0.6));
        known.column(r"\delta\mathbf x", trial.line.direction[2].xy().as_slice());
        known.numbers(r"\delta\theta, \beta", [trial.line.direction[2].z, allowed_share(step.context, trial)]);
        known
    })
}

fn contact(u: Random) -> Symbols {
    let (friction, profile) = (u(0.01, 0.2), Profile::flat_punch(18.0, 4.0, 1.0));
    let tool = Tool { role: Role::Punch, profile, friction: friction.into(), motion: Motion::Fixed };
    let (model, mut state) = disk(vec![tool]);
    state.nodes.iter_mut().for_each(|x| x[2] = u(-0.1, 0.1));
    with_step(&model, &state, (0.05, true), |step, trial, out| {
        trial.moves.iter_mut().skip(1).for_each(|x| x[0] = u(0.0, 1e-3));
        assert!(evaluate(step, trial, &NEWTON, out));
        // The first point of the second element comes near the face that it has below.
        let (e, i) = (1, STATIONS);
        let ContactPosition { position, thickness } = out.contact_positions[i];
        trial.tools[0].y += out.contacts[(0, i)].gap + u(-2e-3, 2e-3);
        assert!(evaluate(step, trial, &NEWTON, out));
        let (at, distance) =
            (out.contacts[(0, i)], step.context.tools[0].profile.closest(position - trial.tools[0]).distance);
        let Penalty { stiffness, smoothing } = step.context.penalty;
        let mut known = Symbols::default();
        known.numbers("d, t, t_b, k_c, g_0", [distance, thickness, state.thickness[e], stiffness, smoothing]);
        known.numbers("S, S_f, p", [step.areas[i], step.areas[i] * step.faces[e][0], at.pressure.value]);
        known.numbers("F_n, F_u, F_t", [at.normal, at.tangential, out.contact_sums[i].0.z]);
        known.numbers(r"u, u_0, \mu_C", [at.slip, step.slip_scale, friction]);
        known
    })
}

fn elastic(u: Random) -> Symbols {
    let hardening = Hardening::Swift(Swift::new(u(300.0, 600.0), 0.2, 1e-3).expect("valid"));
    let elastic = Elastic { young: u(7e4, 2e5), poisson: u(0.2, 0.4) };
    let back = BackStress { modulus: u(500.0, 3000.0), dynamic_recovery: u(5.0, 30.0) };
    let (hill, [start, shift]) = (Hill48::default(), [0; 2].map(|_| [0; 3].map(|_| u(-30.0, 30.0))));
    let (operators, kinematic) = (Operators::new(elastic, hill.into()), Some([back, BackStress::default()]));
    let (hardening, rate, softening) = (Some(&hardening), None, None);
    let law = ElastoplasticLaw { hardening, operators, kinematic, rate, softening, secant: false, duration: 0.1 };
    let mut point = Carried { strain: u(0.01, 0.1), stress: start, back: [shift, [0.0; 3]], ..Carried::default() };
    point.yield_stress = law.yield_stress(&point);
    let (e, mut trial) = ([0; 3].map(|_| u(3e-3, 1e-2)), Trial::default());
    let update = law.respond(&point, &mut trial, e, [0.0; 2]).0;
    let mut known = Symbols::default();
    known.numbers(r"E, \nu, c_\alpha, b_\alpha", [elastic.young, elastic.poisson, back.modulus, back.dynamic_recovery]);
    known.numbers(r"\Delta\bar\varepsilon, \sigma_y", [update.increment, update.yield_stress]);
    known.column(r"\Delta\mathbf e", &e);
    known.column(r"\boldsymbol\sigma", &update.stress);
    known.column(r"\boldsymbol\sigma_b", &start);
    known.column(r"\boldsymbol\alpha", &trial.back[0]);
    known.column(r"\boldsymbol\alpha_b", &shift);
    let columns = [0, 1, 2].map(|j| hill.apply(from_fn(|i| f64::from(u8::from(i == j)))));
    known.set(r"\mathbf A", [Matrix::from_column_slice(3, 3, &columns.concat())]);
    known
}

/// Trust: `.ci/equations.py` evaluates the page with them. A number that is not finite is none in JSON.
#[test]
fn the_symbols_of_every_equation_are_finite_and_written() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("target");
    std::fs::create_dir_all(&folder).expect("writable");
    let samples = samples(&CHECKS).to_string();
    assert!(!samples.contains("null"));
    std::fs::write(folder.join("equations.json"), samples).expect("writable");
}
