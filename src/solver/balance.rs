//! The balance of power: external = plastic + elastic + friction + contact.
//!
//! Each term is integrated over the step by the trapezoidal rule from forces and stresses at both ends, along the
//! path that was really taken. The corrector never uses these sums, so what they miss measures the steps.

use super::assembly::Workspace;
use super::attempt::Step;
use super::contacts::Contact;
use crate::geometry::Point;
use crate::model::{Edge, Mode};
use crate::solution::Energy;
use nalgebra::Vector3;

/// A point's plastic power counts as cut off when its strain increment is below this many cut-offs.
const CUT_OFF_ZONE: f64 = 10.0;

/// Predicted penetration over the thickness that a step is kept from \[–\]: what one iteration may move a node by.
const TOO_FAR: f64 = 0.5;

/// Forces at the end of the last accepted step.
pub(super) struct Balance {
    contacts: Vec<Contact>,
    tool_force: Vec<f64>,
    tool_force_aside: Vec<f64>,
    edge_force: f64,
    gas_force: Vec<Point>,
    bead_force: Vec<f64>,
    /// Plastic work of the last step in each element \[mJ, per ring or per mm of depth\].
    pub plastic: Vec<f64>,
}

impl Balance {
    /// At the start of a run: the tools' distances and what presses then.
    pub fn new(work: &Workspace) -> Self {
        Self {
            contacts: work.contacts.clone(),
            tool_force: work.tool_force.clone(),
            tool_force_aside: work.tool_force_aside.clone(),
            edge_force: 0.0,
            gas_force: work.gas_force.clone(),
            bead_force: vec![0.0; work.beads.len()],
            plastic: vec![0.0; work.thickness.len()],
        }
    }

    /// Contacts at the end of the last accepted step.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Time after which, at the speed of this step, a free node would stand [`TOO_FAR`] thicknesses inside a tool \[s\].
    pub fn approach(&self, work: &Workspace, dt: f64) -> f64 {
        let n = work.nodes.len();
        let pairs = self.contacts.iter().zip(&work.contacts).enumerate();
        let times = pairs.filter(|(_, (_, now))| now.normal == 0.0).map(|(pair, (before, now))| {
            let closing = (before.distance - now.distance) / dt;
            let thickness = work.thickness_at(pair % n);
            let room = now.distance - 0.5 * thickness + TOO_FAR * thickness;
            if closing > 0.0 { room / closing } else { f64::INFINITY }
        });
        times.fold(f64::INFINITY, f64::min)
    }

    /// Forgets contacts that have been released: what their springs stored is lost.
    pub fn forget(&mut self, contacts: std::ops::Range<usize>) {
        for contact in &mut self.contacts[contacts] {
            (contact.normal, contact.tangential) = (0.0, 0.0);
        }
    }

    /// Work of the converged step in `work`; moves on to its end.
    pub fn work_of_step(&mut self, work: &Workspace, step: &Step) -> Energy {
        let Step { model, state, dt, .. } = *step;
        let mut done = Energy::default();
        for (j, &force) in work.tool_force.iter().enumerate() {
            done.external += 0.5 * (self.tool_force[j] + force) * (work.tool_position[j] - state.tools[j]);
            let aside = self.tool_force_aside[j] + work.tool_force_aside[j];
            done.external += 0.5 * aside * (work.tool_aside[j] - state.aside[j]);
        }
        if let Edge::Pulled { speed } = model.blank.edge {
            done.external +=
                0.5 * (self.edge_force + work.edge_reaction.x) * speed * model.speed * model.nominal(state.time, dt);
        }
        for (i, (before, now)) in self.gas_force.iter().zip(&work.gas_force).enumerate() {
            done.external += 0.5 * (before + now).dot(&Point::new(work.moves[i][0], work.moves[i][1]));
        }
        let left = |time: f64| 1.0 - time / model.duration;
        let fading = 0.5 * (left(state.time) + left(state.time + dt));
        for (force, u) in work.held.iter().zip(&work.moves) {
            done.external += fading * force.dot(&Vector3::from(*u));
        }
        let layers = work.layers.len();
        self.plastic.fill(0.0);
        for (i, response) in work.responses.iter().enumerate() {
            let e = work.strain_of(i);
            let before = state.layers[i].stress;
            let power: f64 = (0..3).map(|k| 0.5 * (before[k] + response.stress[k]) * e[k]).sum();
            let volume = work.volume[i / layers] * work.layers[i % layers].weight;
            let elastic = model.stored(response.stress) - model.stored(before);
            let plastic = volume * (power - elastic);
            done.elastic += volume * elastic;
            done.plastic += plastic;
            self.plastic[i / layers] += plastic;
            if model.mode == Mode::Flow && response.increment < CUT_OFF_ZONE * work.cutoff {
                done.cutoff += plastic;
            }
        }
        for (before, now) in self.contacts.iter().zip(&work.contacts) {
            done.friction -= 0.5 * (before.tangential + now.tangential) * now.slip;
            if before.normal + now.normal > 0.0 {
                done.contact -= 0.5 * (before.normal + now.normal) * (now.distance - before.distance);
            }
        }
        for (before, place) in self.bead_force.iter_mut().zip(&work.beads) {
            let (force, slip) = place.map_or((0.0, 0.0), |p| (p.force, p.slip));
            done.friction -= 0.5 * (*before + force) * slip;
            *before = force;
        }
        self.gas_force.copy_from_slice(&work.gas_force);
        self.contacts.copy_from_slice(&work.contacts);
        self.tool_force.copy_from_slice(&work.tool_force);
        self.tool_force_aside.copy_from_slice(&work.tool_force_aside);
        self.edge_force = work.edge_reaction.x;
        done
    }
}
