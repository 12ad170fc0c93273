//! Equilibrium at the end of a step: the residual r = p − f and its matrix H (Sosnowski 1994, equations 7 to 9), the sum of
//! the [`terms`](super::terms).

use super::process::Process;
use super::step::{Step, nodal_areas, references};
use super::terms::bead::BeadForce;
use super::terms::contact::Contact;
use super::terms::gas::HeldRate;
use super::terms::{bead, contact, gas, holder, sheet, unloading};
use super::trial::Trial;
use crate::element::Node;
use crate::geometry::Point;
use crate::material::flow::StressUpdate;
use crate::model::{Edge, Iteration};
use crate::numerics::Grid;
use crate::numerics::block_tridiagonal::System;
use crate::state::{State, thickness_at};
use nalgebra::Vector3;

/// How an iteration linearises the equilibrium.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linearisation {
    pub matrix: Iteration,
    /// Counts from 0.
    pub iteration: usize,
    /// Of the last iteration \[–\].
    pub velocity_norm: f64,
}

/// Residual, matrix and all that goes with a trial: a function of the step and the trial. Allocated once for a run.
pub(super) struct Evaluation {
    /// H, and −r on its right-hand side: ready for δx = −H⁻¹ r.
    pub system: System,
    pub nodes: Vec<Node>,
    /// Elements by thickness points.
    pub updates: Grid<StressUpdate>,
    /// Of each element \[mm\], and its derivative by r, z, θ of both nodes.
    pub thickness: Vec<f64>,
    pub thickness_rows: Vec<[f64; 6]>,
    /// Membrane strains Δε_s, Δε_θ of each element \[–\].
    pub membrane_increment: Vec<[f64; 2]>,
    /// Their derivatives by r, z of both nodes; empty where no gas holds a strain rate.
    pub membrane_rows: Vec<[[f64; 4]; 2]>,
    /// Tools by nodes.
    pub contacts: Grid<Contact>,
    /// Force of each tool on the sheet \[N, or N/mm\].
    pub tool_force: Vec<Point>,
    /// Pairs of node and tool that penetrate.
    pub active_contacts: usize,
    pub bead_force: Vec<BeadForce>,
    /// Force of the gas on every node \[N, or N/mm\].
    pub gas_force: Vec<Point>,
    pub held_rate: HeldRate,
    /// What of the holder's force its distance blocks bear \[N, or N/mm\].
    pub block_force: f64,
    /// Residual of the edge before boundary conditions: the reaction where a freedom is held.
    pub edge_reaction: Vector3<f64>,
    /// Largest nodal residual over the largest internal or contact force of a node, and the node where it sits.
    pub residual_norm: f64,
    pub worst_node: usize,
}

/// The largest force in the plane of the section \[N, or N/mm\].
pub(super) fn largest(forces: &[Vector3<f64>]) -> f64 {
    forces.iter().map(|f| f.xy().norm()).fold(0.0, f64::max)
}

impl Evaluation {
    /// What a state begins with: its pressures, and what they push with; friction has to set in anew.
    pub fn new(process: &Process, state: &State) -> Self {
        let (n, elements) = (state.nodes.len(), state.thickness.len());
        let blank = StressUpdate { stress: [0.0; 3], tangent: [0.0; 6], increment: 0.0, yield_stress: 0.0 };
        let mut start = Self {
            system: System::new(n, process.shared),
            nodes: state.nodes.clone(),
            updates: Grid::new(elements, process.rule.len(), blank),
            thickness: state.thickness.clone(),
            thickness_rows: vec![[0.0; 6]; elements],
            membrane_increment: vec![[0.0; 2]; elements],
            membrane_rows: vec![[[0.0; 4]; 2]; if process.holds_rate() { elements } else { 0 }],
            contacts: Grid::new(process.tools.len(), n, Contact::free(f64::INFINITY)),
            tool_force: vec![Point::zeros(); process.tools.len()],
            active_contacts: 0,
            bead_force: vec![BeadForce::default(); process.model.beads.len()],
            gas_force: vec![Point::zeros(); n],
            held_rate: HeldRate::default(),
            block_force: 0.0,
            edge_reaction: Vector3::zeros(),
            residual_norm: 0.0,
            worst_node: 0,
        };
        let areas = nodal_areas(references(process.model, state, &state.bends), n);
        for (j, tool) in process.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
            for (i, contact) in start.contacts.row_mut(j).iter_mut().enumerate() {
                let closest = tool.profile.closest(state.in_frame_of(j, i));
                contact.distance = closest.distance;
                let pressure = state.pressure[(j, i)];
                if pressure > 0.0 {
                    contact.pressure.value = pressure;
                    contact.normal = areas[i] * pressure;
                    contact.facing = closest.normal;
                    start.tool_force[j] += closest.normal * contact.normal;
                }
            }
        }
        start
    }

    /// Thickness that contact sees at node `i` \[mm\].
    pub fn thickness_at(&self, i: usize) -> f64 {
        thickness_at(&self.thickness, i)
    }

    /// A tool that lets go: what its springs stored is lost.
    pub fn release(&mut self, tool: usize) {
        for contact in self.contacts.row_mut(tool) {
            (contact.normal, contact.tangential) = (0.0, 0.0);
        }
    }

    /// Evaluates a trial; `false` when an element has collapsed.
    #[must_use]
    pub fn update(&mut self, step: &Step, trial: &mut Trial, at: &Linearisation) -> bool {
        for (x, (start, u)) in self.nodes.iter_mut().zip(step.state.nodes.iter().zip(&trial.moves)) {
            for d in 0..3 {
                x[d] = start[d] + u[d];
            }
        }
        self.system.clear();
        if !sheet::add(step, trial, at, self) {
            return false;
        }
        let internal = largest(&self.system.rhs);
        let contact = contact::add(step, trial, at, self);
        bead::add(step, trial, self);
        sheet::stabilise(step, trial, self);
        let gas = gas::add(step, trial, self);
        let unloading = unloading::add(step, self);
        if let Some(kept) = &mut trial.kept {
            if at.iteration == 0 { kept.take_matrix(&self.system) } else { self.system.take_matrix(kept) }
        }
        gas::hold_rate(step, trial, self);
        holder::add(step, trial, self);
        self.constrain(step);
        self.measure_residual(step, internal.max(contact).max(gas).max(unloading));
        true
    }

    /// Symmetry on the axis, the held edge, and no rotations where no element resists them.
    fn constrain(&mut self, step: &Step) {
        let (last, edge) = (self.nodes.len() - 1, step.model.blank.edge);
        self.edge_reaction = -self.system.rhs[last];
        self.system.fix(0, 0);
        self.system.fix(0, 2);
        for (i, _) in step.rotates.iter().enumerate().filter(|(_, rotates)| !**rotates) {
            self.system.fix(i, 2);
        }
        if step.model.release.is_some() && edge == Edge::Free {
            // Nothing else holds the sheet up; what fades is in balance, so that this bears nothing.
            self.system.fix(0, 1);
        }
        if edge != Edge::Free {
            for freedom in 0..3 {
                self.system.fix(last, freedom);
            }
        }
    }

    fn measure_residual(&mut self, step: &Step, largest_force: f64) {
        let residuals = self.system.rhs.iter().map(|f| f.xy().norm()).enumerate();
        let (worst, residual) = residuals.fold((0, 0.0), |worst, now| if now.1 > worst.1 { now } else { worst });
        self.worst_node = worst;
        self.residual_norm = match largest_force > 0.0 {
            true => residual / largest_force,
            // A sheet that all tools have left is at rest; one that none has reached yet says nothing.
            false if step.model.has_paths() => 0.0,
            false => f64::INFINITY,
        };
    }
}

#[cfg(test)]
mod tests;
