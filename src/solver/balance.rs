//! The balance of power: external = plastic + friction + contact.
//!
//! Each term is integrated over the step by the trapezoidal rule from forces and stresses at both ends, along the
//! path that was really taken. The corrector never uses these sums, so what they miss measures the steps.

use super::assembly::Workspace;
use super::contacts::Contact;
use crate::model::{Edge, Model};
use crate::record::Energy;
use crate::state::State;

/// A point's plastic power counts as cut off when its strain increment is below this many cut-offs.
const CUT_OFF_ZONE: f64 = 10.0;

/// Forces at the end of the last accepted step.
pub(super) struct Balance {
    contacts: Vec<Contact>,
    tool_force: Vec<f64>,
    edge_force: f64,
}

impl Balance {
    /// At the start of a run: the tools' distances, nothing pressing yet.
    pub fn new(work: &Workspace) -> Self {
        Self { contacts: work.contacts.clone(), tool_force: vec![0.0; work.tool_force.len()], edge_force: 0.0 }
    }

    /// Forgets contacts that have been released: what their springs stored is lost.
    pub fn forget(&mut self, contacts: std::ops::Range<usize>) {
        for contact in &mut self.contacts[contacts] {
            (contact.normal, contact.tangential) = (0.0, 0.0);
        }
    }

    /// Work of the converged step in `work` that starts at `state` and lasts `dt` \[s\]; moves on to its end.
    pub fn work_of_step(&mut self, work: &Workspace, model: &Model, state: &State, dt: f64) -> Energy {
        let mut done = Energy::default();
        for (j, &force) in work.tool_force.iter().enumerate() {
            done.external += 0.5 * (self.tool_force[j] + force) * (work.tool_position[j] - state.tools[j]);
        }
        if let Edge::Pulled { speed } = model.blank.edge {
            done.external += 0.5 * (self.edge_force + work.edge_reaction.x) * speed * model.speed * dt;
        }
        let layers = work.layers.len();
        for (i, (iterate, response)) in work.iterates.iter().zip(&work.responses).enumerate() {
            let e = iterate.strain();
            let before = state.layers[i].stress;
            let power: f64 = (0..3).map(|k| 0.5 * (before[k] + response.stress[k]) * e[k]).sum();
            let plastic = state.volume[i / layers] * work.layers[i % layers].share * power;
            done.plastic += plastic;
            if response.increment < CUT_OFF_ZONE * work.cutoff {
                done.cutoff += plastic;
            }
        }
        for (before, now) in self.contacts.iter().zip(&work.contacts) {
            done.friction -= 0.5 * (before.tangential + now.tangential) * now.slip;
            if before.normal + now.normal > 0.0 {
                done.contact -= 0.5 * (before.normal + now.normal) * (now.distance - before.distance);
            }
        }
        self.contacts.copy_from_slice(&work.contacts);
        self.tool_force.copy_from_slice(&work.tool_force);
        self.edge_force = work.edge_reaction.x;
        done
    }
}
