//! Selective bending: which elements of the sheet bend in a step, and which are membranes.
//!
//! The choice is made from the state at the start of a step, so that a step that is tried again keeps it. An element
//! bends within [`RING`] thicknesses of a node
//!
//! | where | why |
//! |---|---|
//! | with t/R above the limit | R from the angle between the neighbouring elements over their length |
//! | about to come onto a tool corner with t/R above the limit | the corner bends it before it is curved |
//!
//! so that the edges of a radius, where the sheet is bent and bent back, are inside. An element that no tension holds bends
//! as well: a slack membrane, as at the start of a run or in a free flange, has no transverse stiffness at all.
//!
//! A membrane is solved with one point in the middle of the thickness, at the mean equivalent strain of the layers. All
//! layers then take its stress and its strain increment, and what they differed by stays.
//!
//! # References
//! E. Oñate, C. Agelet de Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577–1593.

use super::assembly::Workspace;
use crate::element::kinematics::Reference;
use crate::geometry::{Arc, Point};
use crate::material::flow::{Iterate, PointState};
use crate::model::{Edge, Model, Theory, Tool};
use crate::numerics::lobatto::{self, ThicknessPoint};
use crate::state::State;

/// How far an element lies from a curved node at most to bend with it, along the sheet, over the thickness \[–\]: some
/// lengths √(t R) over which bending at an edge dies out. With 2 the load of the shipped cups is up to 2.5 % off that of full
/// bending, with 4 1.3 %, with 8 0.6 %.
const RING: f64 = 8.0;
/// Gap to a tool corner below which the sheet is about to come onto it, over the thickness \[–\].
const NEAR: f64 = 0.5;
/// Meridional stress, mean over the thickness, that holds a membrane, over the largest flow stress in the sheet \[–\].
const SLACK: f64 = 0.05;
/// What bends, or is a membrane, goes on until t/R, or the tension, is below this share of its limit \[–\]: no flicker.
const HYSTERESIS: f64 = 0.7;

/// Which elements bend and which nodes rotate, step by step.
#[derive(Clone, Debug)]
pub(super) struct Selection {
    /// Of each element.
    pub bends: Vec<bool>,
    /// Of each node: whether an element there resists its rotation.
    pub rotates: Vec<bool>,
    /// Tool corners that bend the sheet, and the tool of each.
    corners: Vec<(usize, Arc)>,
    layers: Vec<ThicknessPoint>,
    /// Of each node: whether it is curved, or about to be.
    curved: Vec<bool>,
}

impl Selection {
    pub fn new(model: &Model, elements: usize) -> Self {
        let bends = model.blank.theory == Theory::Bending;
        let t = model.blank.thickness;
        let limit = model.settings.bend_ratio;
        let sharp = |tool: &Tool| tool.profile.corners().filter(|arc| t > limit * (arc.radius + 0.5 * t)).collect();
        let corners = model.tools.iter().map(sharp).enumerate();
        Self {
            bends: vec![bends; elements],
            rotates: vec![bends; elements + 1],
            corners: corners.flat_map(|(j, arcs): (_, Vec<Arc>)| arcs.into_iter().map(move |arc| (j, arc))).collect(),
            layers: lobatto::rule(model.blank.layers),
            curved: vec![false; elements + 1],
        }
    }

    /// Chooses for a step from `state`.
    pub fn choose(&mut self, model: &Model, state: &State) {
        if model.blank.theory != Theory::Selective {
            return;
        }
        let last = state.nodes.len() - 1;
        for i in 0..=last {
            let before = state.bends[i.max(1) - 1] || state.bends[i.min(last - 1)];
            let limit = model.settings.bend_ratio * if before { HYSTERESIS } else { 1.0 };
            self.curved[i] =
                state.thickness_at(i) * curvature(model, state, i) > limit || self.is_near_corner(state, i);
        }
        let ring = RING * model.blank.thickness;
        self.choose_slack(model, state);
        let (mut from, mut back) = (f64::INFINITY, f64::INFINITY);
        for e in 0..last {
            let f = last - 1 - e;
            let length =
                |e: usize| (state.nodes[e + 1][0] - state.nodes[e][0]).hypot(state.nodes[e + 1][1] - state.nodes[e][1]);
            from = if self.curved[e] { 0.0 } else { from };
            back = if self.curved[f + 1] { 0.0 } else { back };
            self.bends[e] |= from < ring;
            self.bends[f] |= back < ring;
            from += length(e);
            back += length(f);
        }
        for i in 0..=last {
            self.rotates[i] = self.bends[i.max(1) - 1] || self.bends[i.min(last - 1)];
        }
    }

    /// Elements without tension bend.
    fn choose_slack(&mut self, model: &Model, state: &State) {
        let anisotropy = &model.material.anisotropy;
        let strongest = state.layers.iter().map(|p| anisotropy.equivalent_stress(p.stress)).fold(0.0, f64::max);
        for (e, points) in state.layers.chunks_exact(self.layers.len()).enumerate() {
            let tension: f64 = points.iter().zip(&self.layers).map(|(p, l)| l.weight * p.stress[0]).sum();
            let limit = if state.bends[e] { 1.0 } else { HYSTERESIS };
            self.bends[e] = tension <= limit * SLACK * strongest;
        }
    }

    fn is_near_corner(&self, state: &State, i: usize) -> bool {
        let t = state.thickness_at(i);
        self.corners.iter().any(|(tool, arc)| {
            let x = Point::new(state.nodes[i][0] - state.aside[*tool], state.nodes[i][1] - state.tools[*tool]);
            let gap = (x - arc.center).norm() - arc.radius - 0.5 * t;
            gap < NEAR * t && arc.faces(x)
        })
    }
}

/// Curvature of the meridian at a node \[1/mm\], from the angle between its elements; the sheet goes on beyond the axis
/// as its mirror image, beyond a held edge flat, and not beyond a free one.
fn curvature(model: &Model, state: &State, i: usize) -> f64 {
    let nodes = &state.nodes;
    let along = |a: usize| Point::new(nodes[a + 1][0] - nodes[a][0], nodes[a + 1][1] - nodes[a][1]);
    let last = nodes.len() - 1;
    let (a, b) = match i {
        0 => (Point::new(along(0).x, -along(0).y), along(0)),
        i if i < last => (along(i - 1), along(i)),
        _ if model.blank.edge == Edge::Free => return 0.0,
        _ => (along(last - 1), Point::new(along(last - 1).norm(), 0.0)),
    };
    let angle = (a.x * b.y - a.y * b.x).atan2(a.dot(&b));
    angle.abs() / (0.5 * (a.norm() + b.norm()))
}

impl Workspace {
    /// ThicknessPoint points of element `e`.
    fn points(&self, e: usize) -> std::ops::Range<usize> {
        e * self.layers.len()..(e + 1) * self.layers.len()
    }

    /// Membranes of a layered sheet.
    fn membranes(&self) -> Vec<usize> {
        let layered = self.layers.len() > 1;
        (0..self.starts.len()).filter(|&e| layered && !self.selection.bends[e]).collect()
    }

    /// ε̄ and porosity of membranes at the start of a step: the mean of their layers'.
    pub(super) fn average_strains(&mut self) {
        for e in self.membranes() {
            let points = self.points(e);
            let mean = |of: fn(&PointState) -> f64| {
                self.before[points.clone()].iter().zip(&self.layers).map(|(b, l)| l.weight * of(b)).sum()
            };
            let temperature = self.before[points.start].temperature;
            let mean = PointState { strain: mean(|b| b.strain), porosity: mean(|b| b.porosity), temperature };
            self.before[points].fill(mean);
        }
    }

    /// First iterates of membranes: the mean of their layers', without the transverse shear, which they do not feel. Nodes
    /// that nothing turns wait for the end of the step.
    pub(super) fn average_iterates(&mut self, model: &Model, state: &State) {
        for e in self.membranes() {
            let points = self.points(e);
            let mut carried = [0.0; 3];
            for (point, layer) in state.layers[points.clone()].iter().zip(&self.layers) {
                carried[0] += layer.weight * point.carried[0];
                carried[1] += layer.weight * point.carried[1];
            }
            self.iterates[points.start] = Iterate::start(carried);
        }
        if model.blank.theory == Theory::Selective {
            for (u, _) in self.moves.iter_mut().zip(&self.selection.rotates).filter(|(_, rotates)| !**rotates) {
                u[2] = 0.0;
            }
        }
    }

    /// After a step has come to equilibrium: the layers of membranes take what their one point found, and fibres that
    /// nothing resists turn with the sheet, so that an element that bends later starts with its fibres upright.
    pub(super) fn settle(&mut self, model: &Model, state: &State) {
        if model.blank.theory != Theory::Selective {
            return;
        }
        for e in self.membranes() {
            let points = self.points(e);
            let (iterate, response) = (self.iterates[points.start], self.responses[points.start]);
            self.iterates[points.clone()].fill(iterate);
            self.responses[points].fill(response);
        }
        let last = self.moves.len() - 1;
        let turn =
            |start: &Reference, e: usize| start.end(self.moves[e], self.moves[e + 1]).map_or(0.0, |end| end.turn());
        let turns: Vec<f64> = self.starts.iter().enumerate().map(|(e, start)| turn(start, e)).collect();
        let held = usize::from(model.blank.edge != Edge::Free);
        for i in 1..=last - held {
            if !self.selection.rotates[i] {
                self.moves[i][2] = 0.5 * (turns[i - 1] + turns[i.min(last - 1)]);
                self.nodes[i][2] = state.nodes[i][2] + self.moves[i][2];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Geometry;
    use crate::material::hardening::Swift;
    use crate::material::{Hardening, Material};
    use crate::model::{Blank, Grading, Mode, Settings, StopRules};

    const T: f64 = 1.05;

    /// 100 elements of 1 mm without tools.
    fn strip() -> Model {
        Model {
            title: "strip".into(),
            notes: vec![],
            geometry: Geometry::PlaneStrain,
            blank: Blank {
                length: 100.0,
                thickness: T,
                elements: 100,
                grading: Grading::Uniform,
                theory: Theory::Selective,
                layers: 5,
                edge: Edge::Free,
            },
            material: Material::plain(Hardening::Swift(Swift::new(500.0, 0.2, 1e-3).expect("valid"))),
            tools: vec![],
            beads: vec![],
            gas: vec![],
            heat: None,
            schedule: None,
            travel: 1.0,
            speed: 1.0,
            duration: 1.0,
            stop: StopRules::default(),
            frames: vec![1.0],
            settings: Settings::default(),
            mode: Mode::default(),
            release: None,
            forming_limit: None,
        }
    }

    /// Flat and in tension.
    fn tight(model: &Model) -> State {
        let mut state = State::flat(model, crate::model::mesh::nodes(model));
        for point in &mut state.layers {
            point.stress = [200.0, 100.0, 0.0];
        }
        state
    }

    /// Flat up to 40 mm, then ten elements on a radius, then straight on.
    fn bent(model: &Model, radius: f64) -> State {
        let mut state = tight(model);
        for i in 41..=100 {
            let angle = (i as f64 - 40.5).clamp(0.0, 10.0) / radius;
            let [r, z, _] = state.nodes[i - 1];
            state.nodes[i] = [r + angle.cos(), z + angle.sin(), 0.0];
        }
        state
    }

    fn bending(model: &Model, state: &State) -> Vec<usize> {
        let mut selection = Selection::new(model, 100);
        selection.choose(model, state);
        (0..100).filter(|&e| selection.bends[e]).collect()
    }

    /// Trust: nodes 41 to 49 are curved; the ring of eight thicknesses, 8.4 mm, reaches nine elements from them on either side.
    #[test]
    fn elements_bend_around_a_radius_and_nowhere_else() {
        let model = strip();
        assert_eq!(bending(&model, &bent(&model, T / 0.06)), (32..58).collect::<Vec<_>>());
        assert!(bending(&model, &bent(&model, T / 0.04)).is_empty());
    }

    #[test]
    fn what_bends_goes_on_below_the_limit() {
        let model = strip();
        let mut state = bent(&model, T / 0.04);
        state.bends[20..90].fill(true);
        assert_eq!(bending(&model, &state), (32..58).collect::<Vec<_>>());
        let mut flatter = bent(&model, T / 0.03);
        flatter.bends[20..90].fill(true);
        assert!(bending(&model, &flatter).is_empty());
    }

    /// Trust: 5 % of the largest flow stress, 173 MPa, is 8.7 MPa: that is what a membrane needs.
    #[test]
    fn an_element_without_tension_bends() {
        let model = strip();
        assert_eq!(bending(&model, &State::flat(&model, crate::model::mesh::nodes(&model))).len(), 100);
        let mut state = tight(&model);
        for (e, tension) in [(70, 8.0), (71, 9.5), (72, -200.0)] {
            for point in &mut state.layers[5 * e..5 * e + 5] {
                point.stress[0] = tension;
            }
        }
        assert_eq!(bending(&model, &state), [70, 72]);
    }

    /// A clamped sheet bends at its edge, a free one does not: the last element stands up by 0.1 over 1 mm.
    #[test]
    fn a_clamped_edge_bends_the_sheet() {
        let mut model = strip();
        let mut state = tight(&model);
        for node in &mut state.nodes {
            node[1] = 0.1 * (100.0 - node[0]);
        }
        state.nodes[0][1] = state.nodes[1][1];
        let at_edge = |model: &Model| bending(model, &state).contains(&99);
        assert!(!at_edge(&model));
        model.blank.edge = Edge::Clamped;
        assert!(at_edge(&model));
    }
}
