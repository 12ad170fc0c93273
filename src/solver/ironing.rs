//! Ironing: what becomes of a wall that two tools press between them.

use super::converged::Converged;
use crate::element::surface::STATIONS;
use crate::geometry::turned;
use crate::model::Role;
use crate::solver::solution::StepRecord;
use crate::solver::state::State;

/// Pressure on each face over the yield stress from which two tools iron a wall and do not just touch it \[–\]: declared. A
/// holder's pressure, and that of a sheet drawn round a radius, stay below it; a wall that yields in a gap is pressed by more.
const PRESSED: f64 = 0.1;

/// Cosine between the normals of two tools below which they press on opposite faces \[–\].
const OPPOSED: f64 = -0.5;

/// Writes down how the sheet is ironed in a converged step, and adds the strain that it takes to the state after it.
pub(super) fn follow(converged: &Converged, next: &mut State, record: &mut StepRecord) {
    let Converged { step, evaluation, .. } = converged;
    let mut most = 0;
    for e in 0..next.ironed.len() {
        if is_between_walls(converged, e) {
            next.ironed[e] += (step.state.thickness[e] / next.thickness[e]).ln();
            for (j, tool) in step.process.tools.iter().enumerate() {
                for contact in &evaluation.contacts.row(j)[STATIONS * e..STATIONS * (e + 1)] {
                    record.ironing_pressure = record.ironing_pressure.max(contact.pressure.value);
                    if tool.role == Role::Die {
                        let friction = contact.tangential * turned(contact.facing).y;
                        record.ironing_friction -= friction;
                        record.ironing_force -= contact.normal * contact.facing.y + friction;
                    }
                }
            }
        }
        most = if next.ironed[e] > next.ironed[most] { e } else { most };
    }
    record.ironing = (-(-next.ironed[most]).exp_m1()).max(0.0);
    record.ironing_s0 = 0.5 * (next.s0[most] + next.s0[most + 1]);
}

/// Whether two tools whose places are given press both faces of an element at one of its contact points.
fn is_between_walls(converged: &Converged, e: usize) -> bool {
    let Converged { step, evaluation, .. } = converged;
    let tools = &step.process.tools;
    let updates = evaluation.updates.row(e);
    let least = PRESSED * updates.iter().map(|update| update.yield_stress).sum::<f64>() / updates.len() as f64;
    let pressing = |i: usize| {
        let contacts = tools.iter().zip(evaluation.contacts.rows()).map(move |(tool, contacts)| (tool, &contacts[i]));
        let held = contacts.filter(move |(tool, contact)| tool.shared.is_none() && contact.pressure.value > least);
        held.map(|(_, contact)| contact.facing)
    };
    let opposed = |i: usize| pressing(i).any(|a| pressing(i).any(|b| a.dot(&b) < OPPOSED));
    (STATIONS * e..STATIONS * (e + 1)).any(opposed)
}
