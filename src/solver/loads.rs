//! Loads that are no contact: gas pressure on the faces and draw beads across the flange.

use super::assembly::Workspace;
use super::attempt::Step;
use crate::contact::friction::direction;
use crate::geometry::Point;
use crate::model::{Bead, Geometry, Model, Pressure};
use crate::state::State;
use nalgebra::{Matrix3, Vector3};
use std::cmp::Ordering;
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

/// Where a seal cuts the sheet as it stands at the start of a step: looked for from the edge inward, for a dome may bulge
/// out over its seal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seal {
    /// All elements before this one are inside, all after it outside.
    element: usize,
    /// Share of it that is inside \[–\].
    share: f64,
}

impl Seal {
    /// The seal at the distance `within` from the axis or symmetry plane \[mm\].
    pub fn find(state: &State, within: f64) -> Self {
        for (e, w) in state.nodes.windows(2).enumerate().rev() {
            let (from, to) = (w[0][0], w[1][0]);
            if to <= within {
                return Self { element: e + 1, share: 0.0 };
            }
            if from < within {
                return Self { element: e, share: (within - from) / (to - from) };
            }
        }
        Self { element: 0, share: 0.0 }
    }

    /// Share of an element that is inside \[–\].
    pub fn inside(&self, e: usize) -> f64 {
        match e.cmp(&self.element) {
            Ordering::Less => 1.0,
            Ordering::Equal => self.share,
            Ordering::Greater => 0.0,
        }
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
    pub(super) fn restrain(&mut self, model: &Model, state: &State, dt: f64) {
        let scale = model.settings.slip_speed * model.speed * model.nominal(state.time, dt);
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
        for (k, gas) in model.gas.iter().enumerate() {
            if let Some(given) = gas.pressure.given(time) {
                self.gas_pressure[k] = given;
            }
            let seal = Seal::find(state, gas.within);
            for e in 0..self.thickness.len() {
                let inside = seal.inside(e);
                if inside > 0.0 {
                    self.press_element(model.geometry, e, gas.face.sign() * inside, k);
                }
            }
        }
    }

    /// A shallow dome that strains at about the rate that is held: where the first step starts from.
    pub(super) fn guess_dome(&mut self, step: &Step) {
        let Some((gas, control)) = step.model.held_gas() else { return };
        let a = gas.within.min(step.model.blank.length);
        let height = a * (control.target * step.dt).sqrt() * gas.face.sign();
        for (u, x) in self.moves.iter_mut().zip(&step.state.nodes) {
            let x = (x[0] / a).min(1.0);
            *u = [0.0, height * (1.0 - x * x), if x < 1.0 { -2.0 * height * x / a } else { 0.0 }];
        }
    }

    /// The equations of pressures that hold a strain rate: max(‖Δε̄‖/(target Δt) − 1, p/cap − 1) = 0, of which the larger
    /// one is solved (semi-smooth): either the rate is at its target, or it is below and the pressure on its cap.
    ///
    /// Δε̄ is that of the mid-surface, regularised like the flow law's, so that its derivative is finite in rigid zones.
    pub(super) fn hold_rate(&mut self, model: &Model, state: &State, dt: f64) {
        let anisotropy = &model.material.anisotropy;
        for (k, gas) in model.gas.iter().enumerate() {
            let (Some(row), Pressure::Rate(control)) = (self.gas_shared[k], &gas.pressure) else { continue };
            let (q, wanted) = (control.exponent, control.target * dt);
            let total: f64 = state.volume.iter().sum();
            // In units of the target, so that large powers stay in range.
            let share = |e: &[f64; 2]| {
                let strain = [e[0], e[1], 0.0];
                let regular = anisotropy.equivalent_increment(strain).hypot(self.cutoff);
                (regular / wanted, anisotropy.apply(strain).map(|a| a / (regular * wanted)))
            };
            let sum: f64 =
                self.membrane_increment.iter().zip(&state.volume).map(|(e, v)| v / total * share(e).0.powf(q)).sum();
            let norm = sum.powf(1.0 / q);
            self.held_norm = norm;
            self.on_cap = None;
            self.beyond_cap = 0.0;
            if let Some((cap, which)) = control.cap(state.gas[k], dt) {
                let beyond = self.gas_pressure[k] / cap - 1.0;
                self.beyond_cap = beyond.max(0.0);
                if beyond >= norm - 1.0 {
                    self.on_cap = Some(which);
                    self.beyond_cap = beyond.abs();
                    self.system.corner_rhs[row] = -beyond;
                    self.system.corner[(row, row)] += 1.0 / cap;
                    continue;
                }
            }
            self.system.corner_rhs[row] = 1.0 - norm;
            for e in 0..self.thickness.len() {
                let (value, slope) = share(&self.membrane_increment[e]);
                let weight = norm.powf(1.0 - q) * state.volume[e] / total * value.powf(q - 1.0);
                let rows = &self.membrane_rows[e];
                for node in 0..2 {
                    for d in 0..2 {
                        let by = slope[0] * rows[0][2 * node + d] + slope[1] * rows[1][2 * node + d];
                        self.system.rows[e + node][row][d] += weight * by;
                    }
                }
            }
        }
    }

    fn press_element(&mut self, geometry: Geometry, e: usize, side: f64, k: usize) {
        let pressure = side * self.gas_pressure[k];
        let [a, b] = [self.nodes[e], self.nodes[e + 1]];
        let m = Point::new(a[1] - b[1], b[0] - a[0]); // n l
        // Areas of both nodes, over l, and their derivatives by r of both.
        let (share, by_r) = match geometry {
            Geometry::Axisymmetric => {
                let c = TAU / 6.0;
                ([c * (2.0 * a[0] + b[0]), c * (a[0] + 2.0 * b[0])], [[2.0 * c, c], [c, 2.0 * c]])
            }
            Geometry::PlaneStrain => ([0.5; 2], [[0.0; 2]; 2]),
        };
        for i in 0..2 {
            let force = m * (pressure * share[i]);
            if let Some(column) = self.gas_shared[k] {
                let by_pressure = m * (side * share[i]);
                self.system.columns[e + i][column] -= Vector3::new(by_pressure.x, by_pressure.y, 0.0);
            }
            self.gas_force[e + i] += force;
            let rhs = &mut self.system.rhs[e + i];
            rhs.x += force.x;
            rhs.y += force.y;
            for j in 0..2 {
                // ∂m/∂x of node j: first node (0, 1; −1, 0), second its negative.
                let turn = pressure * if j == 0 { share[i] } else { -share[i] };
                let mut block = Matrix3::zeros();
                block[(0, 0)] = pressure * m.x * by_r[i][j];
                block[(1, 0)] = pressure * m.y * by_r[i][j] - turn;
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
