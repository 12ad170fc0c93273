//! Loads that are no contact: gas pressure on the faces and draw beads across the flange.

use super::assembly::Workspace;
use crate::contact::friction::direction;
use crate::geometry::Point;
use crate::model::{Bead, Face, Geometry, Model};
use crate::state::State;
use nalgebra::Matrix3;
use std::f64::consts::TAU;

/// A bead's restraint fades over the last stretch of the sheet that passes it, this many thicknesses long.
const FADE: f64 = 3.0;

/// Where a bead acts in a step: on the two nodes around it, by these shares of its force.
#[derive(Clone, Copy, Debug)]
pub(super) struct BeadPlace {
    element: usize,
    weights: [f64; 2],
    /// Length of the line times the share of the bead that still holds the sheet \[mm, or – per depth\].
    length: f64,
    /// Friction-like work of the last assembly: force along r \[N, or N/mm\] and slip \[mm\].
    pub force: f64,
    pub slip: f64,
}

impl BeadPlace {
    /// The bead on the sheet at the start of a step; `None` when the sheet has left it.
    fn find(bead: &Bead, model: &Model, state: &State) -> Option<Self> {
        let nodes = &state.nodes;
        let element = (0..nodes.len() - 1).rev().find(|&e| (nodes[e][0]..nodes[e + 1][0]).contains(&bead.at))?;
        let share = (bead.at - nodes[element][0]) / (nodes[element + 1][0] - nodes[element][0]);
        let beyond = nodes[nodes.len() - 1][0] - bead.at;
        let fade = (beyond / (FADE * model.blank.thickness)).min(1.0);
        let length = fade * bead.line(model.geometry);
        Some(Self { element, weights: [1.0 - share, share], length, force: 0.0, slip: 0.0 })
    }
}

impl Workspace {
    /// Finds the beads at the start of a step.
    pub(super) fn place_beads(&mut self, model: &Model, state: &State) {
        for (place, bead) in self.beads.iter_mut().zip(&model.beads) {
            *place = BeadPlace::find(bead, model, state);
        }
    }

    /// What the beads take from the holder's force to stay closed \[N, or N/mm\].
    pub(super) fn closing_force(&self, model: &Model) -> f64 {
        let forces =
            self.beads.iter().zip(&model.beads).map(|(place, bead)| place.map_or(0.0, |p| p.length * bead.closing));
        forces.sum()
    }

    /// Restraint of the beads against the sheet's move along the flange, regularised like friction.
    pub(super) fn restrain(&mut self, model: &Model, dt: f64) {
        let scale = model.settings.slip_speed * model.speed * dt;
        for (place, bead) in self.beads.iter_mut().zip(&model.beads) {
            let Some(place) = place else { continue };
            let [a, b] = [place.element, place.element + 1];
            let [wa, wb] = place.weights;
            place.slip = wa * self.moves[a][0] + wb * self.moves[b][0];
            let phi = direction(place.slip, scale);
            let full = place.length * bead.restraining;
            place.force = -full * phi.value;
            let stiffness = full * phi.slope;
            self.system.rhs[a].x += wa * place.force;
            self.system.rhs[b].x += wb * place.force;
            self.system.diagonal[a][(0, 0)] += wa * wa * stiffness;
            self.system.diagonal[b][(0, 0)] += wb * wb * stiffness;
            self.system.upper[a][(0, 0)] += wa * wb * stiffness;
            self.system.lower[b][(0, 0)] += wa * wb * stiffness;
        }
    }

    /// Gas pressure at the end of the step on the current area, normal to the current meridian.
    ///
    /// ```text
    /// f = p ∫ N n dA,  n l = (−Δz, Δr): exact on straight elements; 2π r inside the integral when axisymmetric
    /// ```
    pub(super) fn inflate(&mut self, model: &Model, state: &State, time: f64) {
        self.gas_force.fill(Point::zeros());
        for gas in &model.gas {
            let sign = match gas.face {
                Face::Lower => 1.0,
                Face::Upper => -1.0,
            };
            let pressure = sign * gas.pressure.at(time);
            for e in 0..self.thickness.len() {
                // The seal cuts elements where they stand at the start of the step.
                let (from, to) = (state.nodes[e][0], state.nodes[e + 1][0]);
                let inside = if to <= gas.within { 1.0 } else { ((gas.within - from) / (to - from)).max(0.0) };
                if inside <= 0.0 || pressure == 0.0 {
                    continue;
                }
                self.press_element(model.geometry, e, pressure * inside);
            }
        }
    }

    fn press_element(&mut self, geometry: Geometry, e: usize, pressure: f64) {
        let [a, b] = [self.nodes[e], self.nodes[e + 1]];
        let m = Point::new(a[1] - b[1], b[0] - a[0]); // n l
        // Shares of both nodes and their derivatives by r of both.
        let (share, by_r) = match geometry {
            Geometry::Axisymmetric => {
                let c = TAU * pressure / 6.0;
                ([c * (2.0 * a[0] + b[0]), c * (a[0] + 2.0 * b[0])], [[2.0 * c, c], [c, 2.0 * c]])
            }
            Geometry::PlaneStrain => ([0.5 * pressure; 2], [[0.0; 2]; 2]),
        };
        for i in 0..2 {
            let force = m * share[i];
            self.gas_force[e + i] += force;
            let rhs = &mut self.system.rhs[e + i];
            rhs.x += force.x;
            rhs.y += force.y;
            for j in 0..2 {
                // ∂m/∂x of node j: first node (0, 1; −1, 0), second its negative.
                let turn = if j == 0 { share[i] } else { -share[i] };
                let mut block = Matrix3::zeros();
                block[(0, 0)] = m.x * by_r[i][j];
                block[(1, 0)] = m.y * by_r[i][j] - turn;
                block[(0, 1)] = turn;
                match (i, j) {
                    (0, 0) | (1, 1) => self.system.diagonal[e + i] -= block,
                    (0, 1) => self.system.upper[e] -= block,
                    _ => self.system.lower[e + 1] -= block,
                }
            }
        }
    }
}
