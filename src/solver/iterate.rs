//! View of an evaluation of the corrector, and its owned copy.

use super::evaluation::Evaluation;
use super::step::{CUT_OFF_ZONE, Step};
use crate::element::Node;
use crate::geometry::turned;
use nalgebra::Vector3;

/// Sheet and forces of one evaluation of the corrector.
pub struct Iterate<'a> {
    pub(super) step: &'a Step<'a>,
    pub(super) evaluation: &'a Evaluation,
    /// Δε₀ of the pass \[–\]; 0 for elastoplastic metal.
    pub(super) cutoff: f64,
}

/// Owned copy of an [`Iterate`].
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct IterateSnapshot {
    /// Nodes from the axis outward \[mm, rad\].
    pub nodes: Vec<Node>,
    /// Forces out of balance at the nodes along r and z, and moments \[N, N mm, or per mm of depth\].
    pub imbalance: Vec<[f64; 3]>,
    /// Largest strain increment of each element \[–\] and the yield stress there \[MPa\].
    pub increments: Vec<[f64; 2]>,
    /// Flags of the elements that strain by less than ten cut-offs.
    pub cut_off: Vec<bool>,
    /// Contact points under pressure, tool by tool.
    pub contacts: Vec<IterateContact>,
}

/// Contact point under the pressure of a tool.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct IterateContact {
    /// Position on the mid-surface, r and z \[mm\].
    pub position: [f64; 2],
    /// Force of the tool on the sheet with friction, along r and z \[N, or N/mm\].
    pub force: [f64; 2],
    /// True below the regularisation speed of friction.
    pub sticks: bool,
}

impl Iterate<'_> {
    /// Nodes from the axis outward \[mm, rad\].
    pub fn nodes(&self) -> &[Node] {
        &self.evaluation.nodes
    }

    /// Forces out of balance at the nodes, −r; 0 at held freedoms \[N, N mm, or per mm of depth\].
    pub fn imbalance(&self) -> &[Vector3<f64>] {
        &self.evaluation.system.rhs
    }

    /// Contact points under pressure, tool by tool.
    pub fn contacts(&self) -> impl Iterator<Item = IterateContact> {
        let (step, penalty) = (self.step, &self.step.context.penalty);
        let pairs = self.evaluation.contacts.rows().flat_map(|row| row.iter().zip(&self.evaluation.contact_positions));
        pairs.filter(move |(contact, _)| contact.is_active(penalty)).map(move |(contact, place)| IterateContact {
            position: place.position.into(),
            force: (contact.facing * contact.normal + turned(contact.facing) * contact.tangential).into(),
            sticks: contact.slip.abs() < step.slip_scale,
        })
    }

    /// Largest strain increment of each element \[–\] and the yield stress there \[MPa\].
    pub fn increments(&self) -> impl Iterator<Item = [f64; 2]> {
        self.evaluation.updates.rows().zip(&self.step.bends).map(|(updates, bends)| {
            let points = if *bends { updates } else { &updates[..1] };
            let larger = |most: [f64; 2], increment: f64, stress: f64| {
                if increment > most[0] { [increment, stress] } else { most }
            };
            points.iter().fold([0.0; 2], |most, point| larger(most, point.increment, point.yield_stress))
        })
    }

    /// True for a largest strain increment of an element below ten cut-offs, where the stress is not the metal's.
    pub fn is_cut_off(&self, increment: f64) -> bool {
        increment < CUT_OFF_ZONE * self.cutoff
    }

    /// Copies the view.
    pub fn snapshot(&self) -> IterateSnapshot {
        IterateSnapshot {
            nodes: self.nodes().to_vec(),
            imbalance: self.imbalance().iter().map(|force| (*force).into()).collect(),
            cut_off: self.increments().map(|[increment, _]| self.is_cut_off(increment)).collect(),
            increments: self.increments().collect(),
            contacts: self.contacts().collect(),
        }
    }
}
