//! Positions of beads, pressed tools and seals on the sheet.

use super::*;
use crate::model::Bead;
use std::cmp::Ordering;

/// Length over which a restraint fades as the edge passes, over the thickness \[–\].
const FADE: f64 = 3.0;
/// Length of fading over the width that a narrower flange has at first \[–\]: its outermost contact point lies inside the edge.
const NARROW: f64 = 0.9;

/// Length over which the force of a tool fades that lies on the sheet from `inner` to its edge \[mm\].
pub fn fade(model: &Model, inner: f64) -> f64 {
    let (usual, width) = (FADE * model.blank.thickness, model.blank.length - inner);
    if width > 0.0 { usual.min(NARROW * width) } else { usual }
}

/// Share of the force on a sheet that reaches so far beyond \[mm\], and its slope \[1/mm\]; it fades over a length \[mm\].
pub fn fading(beyond: f64, over: f64) -> ValueAndSlope {
    let share = beyond / over;
    ValueAndSlope { value: share.clamp(0.0, 1.0), slope: if (0.0..1.0).contains(&share) { 1.0 / over } else { 0.0 } }
}

/// Width of the sheet left under a pressed tool that it runs out from.
///
/// An undiminished force would press on the last place until the sheet snaps from under it.
#[derive(Clone, Copy, Debug)]
pub struct Grip {
    /// Width up to the outermost contact point \[mm\]; negative when the sheet has left the tool.
    pub width: f64,
    /// Derivatives of the width by r of the last two nodes \[–\].
    pub weights: [f64; 2],
}

impl Grip {
    /// Grip of a tool whose inner edge is drawn at `inner` \[mm\].
    pub fn new(inner: f64, displacement: Point, nodes: &[Node], theory: Theory) -> Self {
        let [.., a, b] = nodes else { return Self { width: 0.0, weights: [0.0; 2] } };
        let weights = stations(theory == Theory::Bending)[1].shape;
        Self { width: weights[0] * a[0] + weights[1] * b[0] - inner - displacement.x, weights }
    }
}

/// Element that a bead acts on, and the shares of its nodes.
#[derive(Clone, Copy, Debug)]
pub struct BeadPosition {
    pub element: usize,
    pub weights: [f64; 2],
    /// Length of the line times the share of the bead that still holds the sheet \[mm, or – per depth\].
    pub length: f64,
}

impl BeadPosition {
    pub fn find(bead: &Bead, model: &Model, state: &State) -> Option<Self> {
        let nodes = &state.nodes;
        let element = (0..nodes.len() - 1).rev().find(|&e| (nodes[e][0]..nodes[e + 1][0]).contains(&bead.at))?;
        let share = (bead.at - nodes[element][0]) / (nodes[element + 1][0] - nodes[element][0]);
        let beyond = nodes[nodes.len() - 1][0] - bead.at;
        let length = fading(beyond, fade(model, bead.at)).value * bead.line(model.geometry);
        Some(Self { element, weights: [1.0 - share, share], length })
    }
}

/// Position of a seal, searched from the edge inward because a dome may bulge out over its seal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seal {
    /// Element that the seal cuts; those before it are inside.
    element: usize,
    /// Share of that element's flat area inside \[–\], and its derivatives by r of both ends \[1/mm\].
    share: f64,
    slopes: [f64; 2],
}

impl Seal {
    /// Seal at the distance `within` from the axis or symmetry plane \[mm\].
    pub fn find(nodes: &[Node], within: f64, geometry: Geometry) -> Self {
        let begins_inside = |ends: &[Node]| ends[1][0] <= within || ends[0][0] < within;
        let last = nodes.windows(2).rposition(begins_inside);
        let Some(element) = last else { return Self::default() };
        let [from, to] = [element, element + 1].map(|i| nodes[i][0]);
        let [inside, whole] = [within, to].map(|r| geometry.area(r) - geometry.area(from));
        if to <= within {
            return Self { element: element + 1, ..Self::default() };
        }
        let share = inside / whole;
        let slopes = [(share - 1.0) * geometry.line(from) / whole, -share * geometry.line(to) / whole];
        Self { element, share, slopes }
    }

    /// Derivatives of [`inside`](Self::inside) by r of the element's ends \[1/mm\].
    pub fn slopes(&self, e: usize) -> [f64; 2] {
        if e == self.element { self.slopes } else { [0.0; 2] }
    }

    /// Share of an element inside the seal \[–\].
    pub fn inside(&self, e: usize) -> f64 {
        match e.cmp(&self.element) {
            Ordering::Less => 1.0,
            Ordering::Equal => self.share,
            Ordering::Greater => 0.0,
        }
    }
}
