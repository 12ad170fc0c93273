//! What a converged step says of the run's health: shares, flips, the sharpest bend, what the tools do to the sheet.

use super::assembly::Workspace;
use super::attempt::Step;
use super::contacts::Contact;
use super::loads::Seal;
use crate::model::{Model, Role};
use crate::solution::StepRecord;
use crate::state::State;

/// Pressure over that of touching above which a node counts as in contact \[–\].
const LIGHT: f64 = 0.01;

impl Workspace {
    fn in_contact(&self, contact: &Contact) -> bool {
        contact.pressure.value > LIGHT * self.penalty.at_touch()
    }

    /// Whether the sheet lies on a tool, however lightly it is pressed.
    pub(super) fn lies_on(&self, contact: &Contact) -> bool {
        contact.gap < self.penalty.lying()
    }

    /// The figures of a step that has come to equilibrium; `before` holds its contacts at the start.
    pub(super) fn diagnosis(&self, step: &Step, before: &[Contact]) -> StepRecord {
        let model = step.model;
        let n = self.nodes.len();
        let t0 = model.blank.thickness;
        let slow = model.settings.slip_speed * model.speed * model.nominal(step.state.time, step.dt);
        let rim = model.blank.length - StepRecord::RIM * t0;

        let (mut touching, mut sticking, mut flips) = (0_usize, 0_usize, 0_usize);
        let (mut held, mut on_rim) = (0.0, 0.0);
        for (pair, (now, then)) in self.contacts.iter().zip(before).enumerate() {
            let active = self.in_contact(now);
            flips += usize::from(active != self.in_contact(then));
            touching += usize::from(active);
            sticking += usize::from(active && now.slip.abs() < slow);
            if self.tools[pair / n].role == Role::Holder {
                held += now.normal;
                on_rim += if step.state.s0[pair % n] >= rim { now.normal } else { 0.0 };
            }
        }
        let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        let pressure = model.gas.iter().zip(&self.gas_pressure);
        let pressure = pressure.map(|(gas, p)| gas.face.sign() * p);
        let holder = self.tools.iter().position(|tool| tool.role == Role::Holder && model.release.is_none());
        StepRecord {
            held_rate: model.rate_control().map_or(0.0, |control| control.target * self.held_norm),
            on_cap: self.on_cap,
            contact_share: self.contact_share(model, step.state),
            pole_height: self.nodes[0][1],
            pressure: pressure.sum(),
            holder_move: holder.map_or(0.0, |j| self.tool_position[j]),
            block_force: self.block_force,
            penetration: self.penetration(),
            squeeze: (0..n).filter_map(|i| Some(self.squeeze(i)? / self.thickness_at(i))).fold(0.0, f64::max),
            rim_share: share(on_rim, held),
            sticking: share(sticking as f64, touching as f64),
            flips,
            strain_increment: self.strain_increment(),
            sharpest_bend: self.sharpest_bend(),
            bending: self.selection.bends.iter().filter(|bends| **bends).count(),
            ..StepRecord::default()
        }
    }

    /// Share of the current area inside the seal that lies on the punch or the die \[–\]; an element lies there by halves,
    /// with each of its nodes.
    fn contact_share(&self, model: &Model, state: &State) -> f64 {
        let n = self.nodes.len();
        let within = model.gas.iter().map(|gas| gas.within).reduce(f64::max).unwrap_or(f64::INFINITY);
        let seal = Seal::find(state, within);
        let forms = |j: usize| matches!(self.tools[j].role, Role::Punch | Role::Die);
        let touches = |i: usize| (0..self.tools.len()).any(|j| forms(j) && self.lies_on(&self.contacts[j * n + i]));
        let (mut touching, mut whole) = (0.0, 0.0);
        for e in 0..n - 1 {
            // Volume over thickness is the current area.
            let area = seal.inside(e) * state.volume[e] / self.thickness[e];
            whole += area;
            touching += 0.5 * area * f64::from(u8::from(touches(e)) + u8::from(touches(e + 1)));
        }
        touching / whole
    }

    /// Largest equivalent strain that the step adds at a layer point \[–\].
    pub(super) fn strain_increment(&self) -> f64 {
        self.responses.iter().map(|r| r.increment).fold(0.0, f64::max)
    }

    /// Thickness over the smallest radius of the mid-surface, from the angle between neighbouring elements \[–\].
    fn sharpest_bend(&self) -> f64 {
        let bends = self.nodes.windows(3).enumerate().map(|(e, w)| {
            let (a, b) = ([w[1][0] - w[0][0], w[1][1] - w[0][1]], [w[2][0] - w[1][0], w[2][1] - w[1][1]]);
            let (la, lb) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
            let sine = ((a[0] * b[1] - a[1] * b[0]) / (la * lb)).clamp(-1.0, 1.0);
            sine.abs().asin() / (0.5 * (la + lb)) * self.thickness[e]
        });
        bends.fold(0.0, f64::max)
    }
}
