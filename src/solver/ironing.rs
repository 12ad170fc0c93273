//! Ironing of a wall between two tools.

use super::*;

/// Least pressure on each face over the yield stress \[–\]: that of a holder or over a radius stays below.
const PRESSED: f64 = 0.1;
/// Largest cosine between the normals of two tools that press on opposite faces \[–\].
const OPPOSED: f64 = -0.5;

pub(super) fn add(converged: &Converged, next: &mut State, record: &mut StepRecord) {
    let Converged { step, evaluation, .. } = converged;
    let (mut most, times) = (0, step.model.extent().times());
    for e in 0..next.ironed.len() {
        if is_between_walls(step, evaluation, e) {
            next.ironed[e] = next.ironed[e].map(|ironed| ironed + (step.state.thickness[e] / next.thickness[e]).ln());
            for (j, tool) in step.context.tools.iter().enumerate() {
                for contact in &evaluation.contacts.row(j)[STATIONS * e..STATIONS * (e + 1)] {
                    record.ironing_pressure = record.ironing_pressure.max(contact.pressure.value);
                    if tool.role == Role::Die {
                        let friction = contact.tangential * turned(contact.facing).y;
                        record.ironing_friction -= times * friction;
                        record.ironing_force -= times * (contact.normal * contact.facing.y + friction);
                    }
                }
            }
        }
        most = if next.ironed[e][0] > next.ironed[most][0] { e } else { most };
    }
    record.ironing = (-(-next.ironed[most][0]).exp_m1()).max(0.0);
    record.ironing_s0 = next.middle(most);
}

/// True if two tools of given position press both faces of an element at one contact point.
pub(super) fn is_between_walls(step: &Step, evaluation: &Evaluation, e: usize) -> bool {
    let tools = &step.context.tools;
    let updates = evaluation.updates.row(e);
    let least = PRESSED * updates.iter().map(|update| update.yield_stress).sum::<f64>() / updates.len() as f64;
    let pressing = |i: usize| {
        let contacts = tools.iter().zip(evaluation.contacts.rows()).map(move |(tool, contacts)| (tool, &contacts[i]));
        let held = contacts.filter(move |(tool, contact)| tool.shared.is_none() && contact.pressure.value > least);
        held.map(|(_, contact)| contact.facing)
    };
    (STATIONS * e..STATIONS * (e + 1)).any(|i| pressing(i).any(|a| pressing(i).any(|b| a.dot(&b) < OPPOSED)))
}
