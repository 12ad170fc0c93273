//! Forces of all tools on the sheet, put into the system element by element.

use crate::element::kinematics::Matrix6;
use crate::element::surface::{STATIONS, stations, thickness_second};
use crate::solver::contact_force_tangent::{ContactForceTangent, slope};
use crate::solver::evaluation::{Evaluation, Linearisation};
use crate::solver::step::Step;

/// Adds Gᵀ f and Gᵀ K G of every contact point, and the second derivatives of its position and thickness.
pub fn assemble(step: &Step, at: &Linearisation, out: &mut Evaluation) {
    for e in 0..step.bends.len() {
        let tangents = &out.contact_tangents[STATIONS * e..STATIONS * (e + 1)];
        if !tangents.iter().any(ContactForceTangent::acts) {
            continue;
        }
        let (mut matrix, mut squeeze) = (Matrix6::zeros(), 0.0);
        for (tangent, station) in tangents.iter().zip(stations(step.bends[e])) {
            let g = slope(station, &out.nodes[e], &out.nodes[e + 1], &out.thickness_rows[e]);
            let force = g.transpose() * tangent.force;
            out.system.rhs[e] += force.fixed_rows::<3>(0);
            out.system.rhs[e + 1] += force.fixed_rows::<3>(3);
            if !at.residual_alone {
                matrix += g.transpose() * (tangent.matrix * g) + station.second([tangent.force.x, tangent.force.y]);
                squeeze += tangent.force.z;
            }
        }
        if at.residual_alone {
            continue;
        }
        matrix += squeeze * thickness_second(&out.thickness_rows[e], out.thickness[e]);
        out.system.diagonal[e] -= matrix.fixed_view::<3, 3>(0, 0);
        out.system.diagonal[e + 1] -= matrix.fixed_view::<3, 3>(3, 3);
        out.system.upper[e] -= matrix.fixed_view::<3, 3>(0, 3);
        out.system.lower[e + 1] -= matrix.fixed_view::<3, 3>(3, 0);
    }
}
