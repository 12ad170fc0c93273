//! Selective bending: elements bend near curved nodes and tool corners, and where no tension holds them; the others are
//! membranes with one point in the middle of the thickness.
//!
//! The state at the start of a step decides. An element bends within [`RING`] thicknesses of a node with t/R above the limit, R
//! from the angle between its elements, or about to come onto a tool corner with t/R above it.
//!
//! # References
//! E. Oñate, C. Agelet de Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577–1593.

use super::*;
use crate::geometry::Arc;

/// Distance from a curved node within which elements bend, over the thickness \[–\]: some lengths √(t R). With 2 the load of
/// the shipped cups is up to 2.5 % off that of full bending, with 4 1.3 %, with 8 0.6 %.
const RING: f64 = 8.0;
/// Gap to a tool corner below which elements bend, over the thickness \[–\].
const NEAR: f64 = 0.5;
/// Mean meridional stress that holds a membrane, over the largest flow stress \[–\]: with a tenth the bottom of a flat cup
/// finds no equilibrium on some meshes.
const SLACK: f64 = 0.2;
/// Share of the limit below which an element changes back \[–\].
const HYSTERESIS: f64 = 0.7;

pub(super) struct Selection {
    corners: Vec<(usize, Arc)>,
}

impl Selection {
    pub fn new(model: &Model) -> Self {
        let (t, limit) = (model.blank.thickness, model.settings.bend_ratio);
        let corners = |(j, tool): (usize, &Tool)| tool.profile.corners().map(|arc| (j, arc)).collect::<Vec<_>>();
        let corners = model.tools.iter().enumerate().flat_map(corners);
        Self { corners: corners.filter(|(_, arc)| t > limit * (arc.radius + 0.5 * t)).collect() }
    }

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
        let length = |e: usize| state.along(e).x.hypot(state.along(e).y);
        for e in 0..last {
            let f = last - 1 - e;
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

/// Flags of the nodes whose rotation an element resists.
pub(super) fn rotating(bends: &[bool]) -> Vec<bool> {
    let last = bends.len();
    (0..=last).map(|i| bends[i.max(1) - 1] || bends[i.min(last - 1)]).collect()
}

fn slack(model: &Model, state: &State, rule: &[ThicknessPoint]) -> Vec<bool> {
    let anisotropy = &model.material.yield_criterion;
    let strongest = state.points.iter().map(|p| anisotropy.equivalent_stress(p.stress)).fold(0.0, f64::max);
    let slack = state.points.rows().zip(&state.bends).map(|(points, bends)| {
        let tension: f64 = points.iter().zip(rule).map(|(p, at)| at.weight * p.stress[0]).sum();
        tension <= if *bends { 1.0 } else { HYSTERESIS } * SLACK * strongest
    });
    slack.collect()
}

/// Curvature of the meridian at a node \[1/mm\]; mirrored at the axis, flat beyond a held edge, zero at a free one.
fn curvature(model: &Model, state: &State, i: usize) -> f64 {
    let (along, last) = (|e: usize| state.along(e), state.thickness.len());
    let (a, b) = match i {
        0 => (Point::new(along(0).x, -along(0).y), along(0)),
        i if i < last => (along(i - 1), along(i)),
        _ if model.blank.edge == Edge::Free => return 0.0,
        _ => (along(last - 1), Point::new(along(last - 1).norm(), 0.0)),
    };
    let angle = (a.x * b.y - a.y * b.x).atan2(a.dot(&b));
    angle.abs() / (0.5 * (a.norm() + b.norm()))
}
