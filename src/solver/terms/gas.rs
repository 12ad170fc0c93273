//! Gas pressure on the faces of the sheet, given over time or controlled by a strain rate.

use crate::element::{Vector6, kinematics::Matrix6};
use crate::material::flow::{Metric, YieldCondition};
use crate::solver::{evaluation::HeldRate, restraints::Seal, *};
use std::f64::consts::TAU;

/// Adds the gas pressure on the current sheet; returns the largest force on a node.
///
/// ```text
/// f = p ∫ N n dA,  n l = (−Δz, Δr): exact on straight elements; 2π r inside the integral when axisymmetric
/// ```
pub fn add(step: &Step, trial: &Trial, out: &mut Evaluation) -> f64 {
    out.gas_force.fill(Point::zeros());
    for (k, gas) in step.model.gas.iter().enumerate() {
        let seal = Seal::find(&out.nodes, gas.within, step.model.geometry);
        for e in 0..out.thickness.len() {
            let inside = seal.inside(e);
            if inside > 0.0 {
                let (sign, column) = (gas.face.sign(), step.context.gas_shared[k]);
                let side = (sign * inside, seal.slopes(e).map(|slope| sign * slope));
                press_element(step.model.geometry, e, side, trial.gas[k], column, out);
            }
        }
    }
    out.gas_force.iter().map(|f| f.norm()).fold(0.0, f64::max)
}

/// Adds the pressure `gas` \[MPa\] on element `e`; `side` is ±1 times the share inside the seal, with its derivatives by r
/// of both nodes, `column` the index of an unknown.
fn press_element(
    geometry: Geometry, e: usize, (side, by_ends): (f64, [f64; 2]), gas: f64, column: Option<usize>,
    out: &mut Evaluation,
) {
    let pressure = side * gas;
    let [a, b] = [out.nodes[e], out.nodes[e + 1]];
    let m = Point::new(a[1] - b[1], b[0] - a[0]); // n l
    // Areas of both nodes, over l, and their derivatives by r of both.
    let (share, by_r) = match geometry {
        Geometry::Axisymmetric => {
            let c = TAU / 6.0;
            ([c * (2.0 * a[0] + b[0]), c * (a[0] + 2.0 * b[0])], [[2.0 * c, c], [c, 2.0 * c]])
        }
        Geometry::PlaneStrain => ([0.5; 2], [[0.0; 2]; 2]),
    };
    let (mut forces, mut matrix) = (Vector6::zeros(), Matrix6::zeros());
    for i in 0..2 {
        let force = m * (pressure * share[i]);
        out.gas_force[e + i] += force;
        forces.fixed_rows_mut::<2>(3 * i).copy_from(&force);
        if let Some(column) = column {
            let by_pressure = m * (side * share[i]);
            out.system.columns[e + i][column] -= Vector3::new(by_pressure.x, by_pressure.y, 0.0);
        }
        for j in 0..2 {
            // ∂m/∂x of node j: first node (0, 1; −1, 0), second its negative.
            let turn = pressure * if j == 0 { share[i] } else { -share[i] };
            let growth = pressure * by_r[i][j] + gas * by_ends[j] * share[i];
            matrix[(3 * i, 3 * j)] = -(growth * m.x);
            matrix[(3 * i + 1, 3 * j)] = -(growth * m.y - turn);
            matrix[(3 * i, 3 * j + 1)] = -turn;
        }
    }
    out.system.add_forces(e, &forces);
    out.system.add_element(e, &matrix);
}

/// Adds the equations of controlled pressures, max(‖Δε̄‖/(target Δt) − 1, p/cap − 1) = 0, with Δε̄ of the mid-surface.
pub fn hold_rate(step: &Step, trial: &Trial, out: &mut Evaluation) {
    let Step { context, model, state, dt, .. } = *step;
    for (k, gas) in model.gas.iter().enumerate() {
        let (Some(row), Pressure::Rate(control)) = (context.gas_shared[k], &gas.pressure) else { continue };
        let (q, wanted) = (control.exponent, control.target * dt);
        let total: f64 = state.volume.iter().sum();
        // In units of the target, so that large powers stay in range.
        let share = |e: &[f64; 2]| {
            let Metric { gradient, square, .. } = model.material.yield_criterion.metric([e[0], e[1], 0.0]);
            let regular = square.sqrt().hypot(step.cutoff(trial.softening));
            (regular / wanted, gradient.map(|a| a / (regular * wanted)))
        };
        let elements = out.membrane_increment.iter().zip(&state.volume);
        let sum: f64 = elements.map(|(e, v)| v / total * share(e).0.powf(q)).sum();
        let norm = sum.powf(1.0 / q);
        let system = &mut out.system;
        out.held_rate = HeldRate { norm, ..HeldRate::default() };
        if let Some((cap, which)) = control.cap(state.gas[k], dt) {
            let beyond = trial.gas[k] / cap - 1.0;
            out.held_rate.beyond_cap = beyond.max(0.0);
            if beyond >= norm - 1.0 {
                out.held_rate = HeldRate { norm, on_cap: Some(which), beyond_cap: beyond.abs() };
                system.corner_rhs[row] = -beyond;
                system.corner[(row, row)] += 1.0 / cap;
                continue;
            }
        }
        system.corner_rhs[row] = 1.0 - norm;
        for (e, increment) in out.membrane_increment.iter().enumerate() {
            let (value, slope) = share(increment);
            let weight = norm.powf(1.0 - q) * state.volume[e] / total * value.powf(q - 1.0);
            let rows = &out.membrane_rows[e];
            for node in 0..2 {
                for d in 0..2 {
                    let by = slope[0] * rows[(0, 3 * node + d)] + slope[1] * rows[(1, 3 * node + d)];
                    system.rows[e + node][row][d] += weight * by;
                }
            }
        }
    }
}
