//! Balance of power: external = plastic + elastic + friction + contact.
//!
//! Each term is integrated over the step by the trapezoidal rule from forces and stresses at both ends along the computed path,
//! each force in its own direction. The corrector never uses these sums, so their imbalance measures the step length.

use super::{evaluation::Contact, step::CUT_OFF_ZONE, *};
use crate::solver::solution::Energy;

/// Work of a converged step, and plastic work of each element \[mJ, or per mm of depth\]; `before` is the step before.
pub(super) fn work(before: &Evaluation, converged: &Converged) -> (Energy, Vec<f64>) {
    let Converged { step, trial, evaluation: now, .. } = *converged;
    let (model, state) = (step.model, step.state);
    let mut done = Energy::default();
    for (j, moved) in trial.tools.iter().enumerate() {
        let (force, way) = (before.tool_force[j] + now.tool_force[j], moved - state.tools[j]);
        done.external += 0.5 * force.y * way.y;
        done.external += 0.5 * force.x * way.x;
    }
    if let (Edge::Pulled { .. } | Edge::Fed, Some(moved)) = (model.blank.edge, trial.moves.last()) {
        done.external += 0.5 * (before.edge_reaction + now.edge_reaction).dot(&Vector3::from(*moved));
    }
    for ((before, now), u) in before.gas_force.iter().zip(&now.gas_force).zip(&trial.moves) {
        done.external += 0.5 * (before + now).dot(&Point::new(u[0], u[1]));
    }
    let fading = 0.5 * (step.unloading_left(state.time) + step.unloading_left(step.end()));
    for (force, u) in state.unloading.iter().zip(&trial.moves) {
        done.external += fading * force.dot(&Vector3::from(*u));
    }
    let cutoff = step.cutoff(trial.softening);
    let is_elastic = model.mode != Mode::Flow;
    let mut plastic_of = vec![0.0; now.thickness.len()];
    for (e, (updates, points)) in now.updates.rows().zip(state.points.rows()).enumerate() {
        let (shrinks, volume) = (1.0 / step.growth[e], step.volume[e]);
        for (k, ((update, point), at)) in updates.iter().zip(points).zip(&step.context.rule).enumerate() {
            // Work per volume of the step's end; a porous sheet began with less of it.
            let strain = trial.strain(e, k);
            let [s, t, shear] = point.stress;
            let before = [s * shrinks, t * shrinks, shear * shrinks];
            // Metal that is not elastic bears its flow stress from the first on.
            let before = if !is_elastic && before == [0.0; 3] { update.stress } else { before };
            let along: f64 = (0..3).map(|d| 0.5 * (before[d] + update.stress[d]) * strain[d]).sum();
            let volume = volume * at.weight;
            let elastic = if is_elastic { model.stored(update.stress) - model.stored(before) } else { 0.0 };
            let plastic = volume * (along + update.work_across - elastic);
            done.elastic += volume * elastic;
            done.plastic += plastic;
            plastic_of[e] += plastic;
            if !is_elastic && update.increment < CUT_OFF_ZONE * cutoff {
                done.cutoff += plastic;
            }
        }
    }
    for (j, rows) in before.contacts.rows().zip(now.contacts.rows()).enumerate() {
        let tool = trial.tools[j] - state.tools[j];
        for (i, (before, after)) in rows.0.iter().zip(rows.1).enumerate() {
            let pressing = 0.5 * (before.normal + after.normal);
            if pressing == 0.0 {
                continue;
            }
            let (e, k) = (i / STATIONS, i % STATIONS);
            let place = |nodes: &[Node]| step.stations()[k].position(&nodes[e], &nodes[e + 1]);
            let moved = place(&now.nodes) - place(&state.nodes) - tool;
            let across = |contact: &Contact| contact.normal * contact.facing.dot(&moved);
            let along = |contact: &Contact| contact.tangential * turned(contact.facing).dot(&moved);
            let thickness = now.thickness[e];
            let thinned = 0.5 * (state.thickness[e] - thickness) - after.closing;
            done.contact -= 0.5 * (across(before) + across(after)) + pressing * thinned;
            done.friction -= 0.5 * (along(before) + along(after));
            // Voids grow against the normal stress, half of the pressure: the metal does not use that work up.
            let swelling = 0.5 * pressing * thickness * (1.0 - 1.0 / step.growth[e]);
            done.plastic -= swelling;
            plastic_of[e] -= swelling;
        }
    }
    for (before, now) in before.bead_force.iter().zip(&now.bead_force) {
        done.friction -= 0.5 * (before.force + now.force) * now.slip;
    }
    (done, plastic_of)
}
