//! Evaluation of a trial: residual, matrix, stress, contacts.

use super::{run_context::references, step::half_thickness_difference, *};
use crate::element::{Vector6, surface::Station};
use crate::material::flow::StressUpdate;
use crate::model::PressureCap;
use nalgebra::{Matrix3, SMatrix};

/// Least pressure of a point in contact, over that of touching \[–\].
const LIGHT: f64 = 0.01;

#[derive(Clone, Copy, Debug)]
pub(super) struct Linearisation {
    pub matrix: Iteration,
    pub residual_alone: bool,
    pub iteration: usize,
    /// Velocity norm of the last iteration \[–\].
    pub velocity_norm: f64,
}

/// Position of a contact point \[mm\], and the thickness of the sheet there \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactPosition {
    pub position: Point,
    pub thickness: f64,
}

impl ContactPosition {
    /// Position of a station between two nodes; `rise` is half the thickness difference between them.
    pub fn new(station: &Station, [a, b]: [&Node; 2], thickness: f64, rise: f64) -> Self {
        Self { position: station.position(a, b), thickness: thickness + station.xi * rise }
    }
}

/// Contact of a point with a tool; forces are zero out of reach.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Contact {
    /// Gap between the tool and the sheet's face \[mm\]; infinite if not measured.
    pub gap: f64,
    /// Move of the face by thinning in the step beyond the gap \[mm\].
    pub closing: f64,
    /// Normal force and friction \[N, or N/mm\], and slip \[mm\].
    pub normal: f64,
    pub tangential: f64,
    pub slip: f64,
    /// Pressure \[MPa\] and slope.
    pub pressure: ValueAndSlope,
    /// Normal from the tool to the sheet.
    pub facing: Point,
}

impl Contact {
    pub fn free() -> Self {
        Self { gap: f64::INFINITY, ..Self::default() }
    }

    pub fn is_active(&self, penalty: &Penalty) -> bool {
        self.pressure.value > LIGHT * penalty.at(0.0).value
    }
}

/// Force of a bead along r \[N, or N/mm\], and slip through it in the step \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BeadForce {
    pub force: f64,
    pub slip: f64,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct HeldRate {
    /// Norm of the strain rate over its target \[–\].
    pub norm: f64,
    /// Active cap, and the relative distance from it \[–\].
    pub on_cap: Option<PressureCap>,
    pub beyond_cap: f64,
}

#[derive(Default)]
pub(super) struct Evaluation {
    /// H with −r on its right-hand side.
    pub system: System,
    pub nodes: Vec<Node>,
    /// Elements by thickness points.
    pub updates: Grid<StressUpdate>,
    /// Thickness of each element \[mm\], and its derivatives.
    pub thickness: Vec<f64>,
    pub thickness_rows: Vec<Vector6>,
    /// Membrane strains Δε_s, Δε_θ of each element \[–\].
    pub membrane_increment: Vec<[f64; 2]>,
    /// Their derivatives by the element's freedoms; empty where no gas holds a strain rate.
    pub membrane_rows: Vec<SMatrix<f64, 2, 6>>,
    pub contact_positions: Vec<ContactPosition>,
    /// Sums over the tools at each contact point of F_r, F_z, Q \[N, or N/mm\] and their derivatives.
    pub contact_sums: Vec<(Vector3<f64>, Matrix3<f64>)>,
    /// Tools by contact points.
    pub contacts: Grid<Contact>,
    /// Force of each tool on the sheet \[N, or N/mm\].
    pub tool_force: Vec<Point>,
    pub active_contacts: usize,
    pub bead_force: Vec<BeadForce>,
    /// Force of the gas on every node \[N, or N/mm\].
    pub gas_force: Vec<Point>,
    pub held_rate: HeldRate,
    /// Force of the holder on its distance blocks \[N, or N/mm\].
    pub block_force: f64,
    /// Residual of the edge before boundary conditions: its reaction.
    pub edge_reaction: Vector3<f64>,
    /// Largest nodal residual over the largest nodal force, at least the least force, and its node.
    pub residual_norm: f64,
    pub worst_node: usize,
}

/// Largest force in the plane of the section \[N, or N/mm\].
pub(super) fn largest(forces: &[Vector3<f64>]) -> f64 {
    forces.iter().map(|f| f.xy().norm()).fold(0.0, f64::max)
}

impl Evaluation {
    /// Evaluation of a state at rest: contact pressures without friction.
    pub fn new(context: &RunContext, state: &State) -> Self {
        let (n, elements) = (state.nodes.len(), state.thickness.len());
        let mut start = Self {
            system: System::new(n, context.shared),
            nodes: state.nodes.clone(),
            updates: Grid::new(elements, context.rule.len(), StressUpdate::default()),
            thickness: state.thickness.clone(),
            thickness_rows: vec![Vector6::zeros(); elements],
            membrane_increment: vec![[0.0; 2]; elements],
            membrane_rows: vec![SMatrix::zeros(); if context.holds_rate() { elements } else { 0 }],
            contact_positions: vec![ContactPosition::default(); state.contact_points()],
            contact_sums: vec![(Vector3::zeros(), Matrix3::zeros()); state.contact_points()],
            contacts: Grid::new(context.tools.len(), state.contact_points(), Contact::free()),
            tool_force: vec![Point::zeros(); context.tools.len()],
            bead_force: vec![BeadForce::default(); context.model.beads.len()],
            gas_force: vec![Point::zeros(); n],
            ..Self::default()
        };
        let references: Vec<Reference> = references(context.model, state).collect();
        let areas: Vec<f64> = references.iter().flat_map(Reference::contact_areas).collect();
        let rise = half_thickness_difference(&references, &state.thickness);
        let stations = stations(context.model.blank.theory == Theory::Bending);
        for (j, tool) in context.acting_tools() {
            for (i, contact) in start.contacts.row_mut(j).iter_mut().enumerate() {
                let e = i / STATIONS;
                let (station, ends) = (&stations[i % STATIONS], [&state.nodes[e], &state.nodes[e + 1]]);
                let place = ContactPosition::new(station, ends, state.thickness[e], rise[e]);
                let closest = tool.profile.closest(place.position - state.tools[j]);
                contact.gap = closest.distance - 0.5 * place.thickness;
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

    pub fn release(&mut self, tool: usize) {
        self.contacts.row_mut(tool).iter_mut().for_each(|own| (own.normal, own.tangential) = (0.0, 0.0));
    }

    /// Largest penetration of an element over its thickness \[–\].
    pub fn penetration(&self) -> f64 {
        let rows = self.contacts.rows().map(|row| row.chunks_exact(STATIONS).zip(&self.thickness));
        rows.flatten().filter_map(|(contacts, thickness)| Some(-mean_gap(contacts)? / thickness)).fold(0.0, f64::max)
    }
}

/// Pressure-weighted mean gap of an element \[mm\]; `None` without pressure.
pub(super) fn mean_gap(contacts: &[Contact]) -> Option<f64> {
    let pressed = contacts.iter().filter(|contact| contact.pressure.value > 0.0);
    let (sum, weight) = pressed.fold((0.0, 0.0), |(sum, weight), contact| {
        let p = contact.pressure.value;
        (sum + p * contact.gap, weight + p)
    });
    (weight > 0.0).then(|| sum / weight)
}
