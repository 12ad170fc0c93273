//! Forces of all tools on the sheet, put into the system element by element.

use crate::element::surface::{MotionForces, STATIONS, difference, of_node, stations};
use crate::solver::evaluation::{Evaluation, Linearisation};
use crate::solver::push::{FIRST, Push, SECOND};
use crate::solver::step::Step;
use nalgebra::{Matrix3, Vector3};

/// Adds the contact forces of all elements that tools press.
pub fn assemble(step: &Step, at: &Linearisation, out: &mut Evaluation) {
    for e in 0..step.bends.len() {
        let pushes = [out.pushes[STATIONS * e], out.pushes[STATIONS * e + 1]];
        if !pushes.iter().any(Push::acts) {
            continue;
        }
        let stations = stations(step.bends[e]);
        let difference = difference(&out.nodes[e], &out.nodes[e + 1]);
        let slopes = [stations[0].slope(difference), stations[1].slope(difference)];
        let thinning = &out.thickness_rows[e];
        let mut sheet = MotionForces { force: [0.0; 5], matrix: [[0.0; 5]; 5] };
        for k in 0..STATIONS {
            pushes[k].load(&slopes[k], thinning, &mut sheet.force);
        }
        for (node, side) in [(e, FIRST), (e + 1, SECOND)] {
            out.system.rhs[node] += Vector3::from(of_node(side, &sheet.force));
        }
        if at.residual_alone {
            continue;
        }
        for k in 0..STATIONS {
            pushes[k].stiffen(&stations[k], &slopes[k], thinning, &mut sheet.matrix);
        }
        let squeeze = pushes[0].squeeze + pushes[1].squeeze;
        thin(squeeze / out.thickness[e], thinning, &mut sheet.matrix);
        let block = |i, j| Matrix3::from_column_slice(&sheet.block(i, j));
        out.system.diagonal[e] -= block(FIRST, FIRST);
        out.system.diagonal[e + 1] -= block(SECOND, SECOND);
        out.system.upper[e] -= block(FIRST, SECOND);
        out.system.lower[e + 1] -= block(SECOND, FIRST);
    }
}

/// Adds Q ∂²t, ∂²t = ∂t ∂tᵀ/t − t ∂²(ε_s + ε_θ), by ∂t = −t ∂(ε_s + ε_θ); `share` is Q/t.
fn thin(share: f64, [hoop, r, z]: &[f64; 3], m: &mut [[f64; 5]; 5]) {
    m[0][0] += 2.0 * share * hoop * hoop;
    m[2][2] += share * (2.0 * r * r - z * z);
    m[3][3] += share * (2.0 * z * z - r * r);
    for (i, j, value) in [(0, 2, hoop * r), (0, 3, hoop * z), (2, 3, 3.0 * r * z)] {
        m[i][j] += share * value;
        m[j][i] += share * value;
    }
}
