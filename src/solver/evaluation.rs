//! What follows from a step and a trial of it: residual, matrix, stress, contacts.

use super::contact_tangent::{ContactTangent, Near, Place};
use super::process::{Process, references};
use super::step::rise;
use crate::contact::penalty::{Penalty, ValueAndSlope};
use crate::element::Node;
use crate::element::Vector6;
use crate::element::kinematics::Reference;
use crate::element::surface::{STATIONS, stations};
use crate::geometry::Point;
use crate::material::flow::StressUpdate;
use crate::model::{Iteration, PressureCap};
use crate::numerics::Grid;
use crate::numerics::block_tridiagonal::System;
use crate::solver::state::State;
use nalgebra::Vector3;

/// Pressure over that of touching above which a point counts as in contact \[–\].
const LIGHT: f64 = 0.01;

/// How an iteration linearises the equilibrium.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linearisation {
    pub matrix: Iteration,
    /// Whether the residual alone is asked for, and the matrix may stay empty.
    pub residual_alone: bool,
    /// Counts from 0.
    pub iteration: usize,
    /// Of the last iteration \[–\].
    pub velocity_norm: f64,
}

/// One point of the sheet against one tool at the end of the step under trial; forces are zero when it is out of reach.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Contact {
    /// Gap between the tool and the sheet's face \[mm\]; infinite until measured when far away.
    pub gap: f64,
    /// By how much more than the gap a face has closed up in the step, as its force sees it \[mm\].
    pub closing: f64,
    /// Normal force and friction \[N, or N/mm\], and the slip that goes with it \[mm\].
    pub normal: f64,
    pub tangential: f64,
    pub slip: f64,
    /// Pressure \[MPa\] and slope.
    pub pressure: ValueAndSlope,
    /// Normal from the tool to the sheet.
    pub facing: Point,
}

impl Contact {
    /// A point far away that nothing presses.
    pub fn free() -> Self {
        Self { gap: f64::INFINITY, ..Self::default() }
    }

    /// Whether the tool presses at all, however lightly.
    pub fn is_active(&self, penalty: &Penalty) -> bool {
        self.pressure.value > LIGHT * penalty.at_touch()
    }

    /// Whether the sheet lies on the tool, pressed or not.
    pub fn lies_on(&self, penalty: &Penalty) -> bool {
        self.gap < penalty.lying()
    }
}

/// Force of a bead on the sheet along r \[N, or N/mm\], and the sheet's slip through it in the step \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BeadForce {
    pub force: f64,
    pub slip: f64,
}

/// How a pressure that holds a strain rate stands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct HeldRate {
    /// Norm of the strain rate over its target \[–\].
    pub norm: f64,
    /// The cap that the pressure sits on, and by what share it misses or exceeds it \[–\].
    pub on_cap: Option<PressureCap>,
    pub beyond_cap: f64,
}

/// All that goes with a trial: a function of the step and the trial. Allocated once for a run.
pub(super) struct Evaluation {
    /// H, and −r on its right-hand side: ready for δx = −H⁻¹ r.
    pub system: System,
    pub nodes: Vec<Node>,
    /// Elements by thickness points.
    pub updates: Grid<StressUpdate>,
    /// Of each element \[mm\], and its derivative by r₁+r₂, r₂−r₁, z₂−z₁.
    pub thickness: Vec<f64>,
    pub thickness_rows: Vec<Vector6>,
    /// Membrane strains Δε_s, Δε_θ of each element \[–\].
    pub membrane_increment: Vec<[f64; 2]>,
    /// Their derivatives by r, z of both nodes; empty where no gas holds a strain rate.
    pub membrane_rows: Vec<[[f64; 4]; 2]>,
    /// The contact points, and what all tools do to them.
    pub places: Vec<Place>,
    pub contact_tangents: Vec<ContactTangent>,
    /// The contact points within reach of the tool that was looked at last.
    pub near: Vec<Near>,
    /// Tools by contact points.
    pub contacts: Grid<Contact>,
    /// Force of each tool on the sheet \[N, or N/mm\].
    pub tool_force: Vec<Point>,
    /// Pairs of point and tool that penetrate.
    pub active_contacts: usize,
    pub bead_force: Vec<BeadForce>,
    /// Force of the gas on every node \[N, or N/mm\].
    pub gas_force: Vec<Point>,
    pub held_rate: HeldRate,
    /// What of the holder's force its distance blocks bear \[N, or N/mm\].
    pub block_force: f64,
    /// Residual of the edge before boundary conditions: the reaction where a freedom is held.
    pub edge_reaction: Vector3<f64>,
    /// Largest nodal residual over the largest internal or contact force of a node or the least that counts, and the node
    /// where it sits.
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
        let mut start = Self {
            system: System::new(n, process.shared),
            nodes: state.nodes.clone(),
            updates: Grid::new(elements, process.rule.len(), StressUpdate::default()),
            thickness: state.thickness.clone(),
            thickness_rows: vec![Vector6::zeros(); elements],
            membrane_increment: vec![[0.0; 2]; elements],
            membrane_rows: vec![[[0.0; 4]; 2]; if process.holds_rate() { elements } else { 0 }],
            places: vec![Place::default(); state.contact_points()],
            contact_tangents: vec![ContactTangent::default(); state.contact_points()],
            near: Vec::with_capacity(state.contact_points()),
            contacts: Grid::new(process.tools.len(), state.contact_points(), Contact::free()),
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
        let references: Vec<Reference> = references(process.model, state, &state.bends).collect();
        let areas: Vec<f64> = references.iter().flat_map(Reference::contact_areas).collect();
        let rise = rise(&references, &state.thickness);
        for (j, tool) in process.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
            for (i, contact) in start.contacts.row_mut(j).iter_mut().enumerate() {
                let (e, k) = (i / STATIONS, i % STATIONS);
                let station = &stations(state.bends[e])[k];
                let place = Place::new(station, &state.nodes[e], &state.nodes[e + 1], state.thickness[e], rise[e]);
                let closest = tool.profile.closest(place.position - state.tools[j]);
                contact.gap = place.gap(closest.distance);
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

    /// Thickness of the element of contact point `i` \[mm\].
    pub fn thickness_at(&self, i: usize) -> f64 {
        self.thickness[i / STATIONS]
    }

    /// A tool that lets go: what its springs stored is lost.
    pub fn release(&mut self, tool: usize) {
        for contact in self.contacts.row_mut(tool) {
            (contact.normal, contact.tangential) = (0.0, 0.0);
        }
    }

    /// Largest penetration of an element over its thickness \[–\]: what the contact method lets through.
    pub fn penetration(&self) -> f64 {
        let rows = self.contacts.rows().map(|row| row.chunks_exact(STATIONS).zip(&self.thickness));
        let deep = rows.flatten().filter_map(|(contacts, thickness)| Some(-mean_gap(contacts)? / thickness));
        deep.fold(0.0, f64::max)
    }
}

/// Gap of an element, the mean of its points' by their pressures \[mm\]; `None` where nothing presses.
pub(super) fn mean_gap(contacts: &[Contact]) -> Option<f64> {
    let pressed = contacts.iter().filter(|contact| contact.pressure.value > 0.0);
    let (sum, weight) = pressed.fold((0.0, 0.0), |(sum, weight), contact| {
        let p = contact.pressure.value;
        (sum + p * contact.gap, weight + p)
    });
    (weight > 0.0).then(|| sum / weight)
}
