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
//! A membrane is solved with one point in the middle of the thickness, at the mean equivalent strain of its thickness points.
//! All of them then take its stress and its strain increment, and what they differed by stays.
//!
//! # References
//! E. Oñate, C. Agelet de Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577–1593.

use crate::geometry::{Arc, Point};
use crate::model::{Edge, Model, Theory, Tool};
use crate::numerics::lobatto::ThicknessPoint;
use crate::solver::state::State;

/// How far an element lies from a curved node at most to bend with it, along the sheet, over the thickness \[–\]: some
/// lengths √(t R) over which bending at an edge dies out. With 2 the load of the shipped cups is up to 2.5 % off that of full
/// bending, with 4 1.3 %, with 8 0.6 %.
const RING: f64 = 8.0;
/// Gap to a tool corner below which the sheet is about to come onto it, over the thickness \[–\].
const NEAR: f64 = 0.5;
/// Meridional stress, mean over the thickness, that holds a membrane, over the largest flow stress in the sheet \[–\]: with a
/// tenth the bottom of a flat cup, hardly taut in the first steps, finds no equilibrium on some meshes.
const SLACK: f64 = 0.2;
/// What bends, or is a membrane, goes on until t/R, or the tension, is below this share of its limit \[–\]: no flicker.
const HYSTERESIS: f64 = 0.7;

/// What the choice needs of a model's tools.
pub(super) struct Selection {
    /// Tool corners that bend the sheet, and the tool of each.
    corners: Vec<(usize, Arc)>,
}

impl Selection {
    /// Of a model that is run.
    pub fn new(model: &Model) -> Self {
        let (t, limit) = (model.blank.thickness, model.settings.bend_ratio);
        let sharp = |tool: &Tool| tool.profile.corners().filter(|arc| t > limit * (arc.radius + 0.5 * t)).collect();
        let corners = model.tools.iter().map(sharp).enumerate();
        let of_tool = |(j, arcs): (usize, Vec<Arc>)| arcs.into_iter().map(move |arc| (j, arc));
        Self { corners: corners.flat_map(of_tool).collect() }
    }

    /// Which elements bend in a step from `state`.
    pub fn bending(&self, model: &Model, state: &State, rule: &[ThicknessPoint]) -> Vec<bool> {
        if model.blank.theory != Theory::Selective {
            return vec![model.blank.theory == Theory::Bending; state.thickness.len()];
        }
        let last = state.nodes.len() - 1;
        let curved = |i: usize| {
            let before = state.bends[i.max(1) - 1] || state.bends[i.min(last - 1)];
            let limit = model.settings.bend_ratio * if before { HYSTERESIS } else { 1.0 };
            state.thickness_at(i) * curvature(model, state, i) > limit || self.is_near_corner(state, i)
        };
        let curved: Vec<bool> = (0..=last).map(curved).collect();
        let ring = RING * model.blank.thickness;
        let mut bends = slack(model, state, rule);
        let (mut from, mut back) = (f64::INFINITY, f64::INFINITY);
        for e in 0..last {
            let f = last - 1 - e;
            let length =
                |e: usize| (state.nodes[e + 1][0] - state.nodes[e][0]).hypot(state.nodes[e + 1][1] - state.nodes[e][1]);
            from = if curved[e] { 0.0 } else { from };
            back = if curved[f + 1] { 0.0 } else { back };
            bends[e] |= from < ring;
            bends[f] |= back < ring;
            from += length(e);
            back += length(f);
        }
        bends
    }

    fn is_near_corner(&self, state: &State, i: usize) -> bool {
        let t = state.thickness_at(i);
        self.corners.iter().any(|(tool, arc)| {
            let x = state.in_frame_of(*tool, i);
            let gap = (x - arc.center).norm() - arc.radius - 0.5 * t;
            gap < NEAR * t && arc.faces(x)
        })
    }
}

/// At which nodes an element resists their rotation.
pub(super) fn rotating(bends: &[bool]) -> Vec<bool> {
    let last = bends.len();
    (0..=last).map(|i| bends[i.max(1) - 1] || bends[i.min(last - 1)]).collect()
}

/// Elements without tension.
fn slack(model: &Model, state: &State, rule: &[ThicknessPoint]) -> Vec<bool> {
    let anisotropy = &model.material.yield_criterion;
    let strongest = state.points.iter().map(|p| anisotropy.equivalent_stress(p.stress)).fold(0.0, f64::max);
    let slack = state.points.rows().zip(&state.bends).map(|(points, bends)| {
        let tension: f64 = points.iter().zip(rule).map(|(p, at)| at.weight * p.stress[0]).sum();
        tension <= if *bends { 1.0 } else { HYSTERESIS } * SLACK * strongest
    });
    slack.collect()
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
            depth: None,
            blank: Blank {
                length: 100.0,
                thickness: T,
                elements: 100,
                grading: Grading::Uniform,
                theory: Theory::Selective,
                layers: 5,
                rule: Default::default(),
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
            timed: true,
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
        for point in state.points.iter_mut() {
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
        let bends = Selection::new(model).bending(model, state, &model.blank.points());
        (0..100).filter(|&e| bends[e]).collect()
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

    /// Trust: 20 % of the largest flow stress, 173 to 200 MPa, is 35 to 40 MPa: that is what a membrane needs.
    #[test]
    fn an_element_without_tension_bends() {
        let model = strip();
        assert_eq!(bending(&model, &State::flat(&model, crate::model::mesh::nodes(&model))).len(), 100);
        let mut state = tight(&model);
        for (e, tension) in [(70, 33.0), (71, 45.0), (72, -200.0)] {
            for point in state.points.row_mut(e) {
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
