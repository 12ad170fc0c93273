//! Where beads and pressed tools hold the sheet and seals cut it.

use crate::contact::penalty::ValueAndSlope;
use crate::element::Node;
use crate::element::surface::stations;
use crate::geometry::Point;
use crate::model::{Bead, Model};
use crate::solver::state::State;
use std::cmp::Ordering;

/// What holds the sheet fades over the last stretch of it that passes, this many thicknesses long \[–\].
const FADE: f64 = 3.0;

/// Share of its force with which something still holds a sheet that reaches so far beyond it \[mm\], and its slope \[1/mm\].
fn fading(beyond: f64, thickness: f64) -> ValueAndSlope {
    let share = beyond / (FADE * thickness);
    ValueAndSlope {
        value: share.clamp(0.0, 1.0),
        slope: if (0.0..1.0).contains(&share) { 1.0 / (FADE * thickness) } else { 0.0 },
    }
}

/// How much of the sheet is left under a pressed tool whose inner end it runs out from: up to the outermost place at which
/// it can touch.
///
/// A force that stayed would press on that last place until the sheet snaps from under it.
#[derive(Clone, Copy, Debug)]
pub struct Grip {
    /// Width under the tool \[mm\]; negative when the sheet has left it.
    pub width: f64,
    /// Its derivatives by the distances of the last two nodes from the axis \[–\].
    pub weights: [f64; 2],
}

impl Grip {
    /// Of a tool whose inner edge is drawn at `inner` \[mm\] at its displacement on a sheet with these nodes.
    pub fn new(inner: f64, displacement: Point, nodes: &[Node], bends: &[bool]) -> Self {
        let [.., a, b] = nodes else { return Self { width: 0.0, weights: [0.0; 2] } };
        let weights = stations(bends[bends.len() - 1])[1].shape;
        let outermost = weights[0] * a[0] + weights[1] * b[0];
        Self { width: outermost - inner - displacement.x, weights }
    }

    /// Share of its force with which the tool still presses \[–\], and its slope by the width \[1/mm\].
    pub fn share(&self, thickness: f64) -> ValueAndSlope {
        fading(self.width, thickness)
    }
}

/// Where a bead acts in a step: on the two nodes around it, by these shares of its force.
#[derive(Clone, Copy, Debug)]
pub struct BeadPlace {
    pub element: usize,
    pub weights: [f64; 2],
    /// Length of the line times the share of the bead that still holds the sheet \[mm, or – per depth\].
    pub length: f64,
}

impl BeadPlace {
    /// The bead on the sheet at the start of a step; `None` when the sheet has left it.
    pub fn find(bead: &Bead, model: &Model, state: &State) -> Option<Self> {
        let nodes = &state.nodes;
        let element = (0..nodes.len() - 1).rev().find(|&e| (nodes[e][0]..nodes[e + 1][0]).contains(&bead.at))?;
        let share = (bead.at - nodes[element][0]) / (nodes[element + 1][0] - nodes[element][0]);
        let beyond = nodes[nodes.len() - 1][0] - bead.at;
        let length = fading(beyond, model.blank.thickness).value * bead.line(model.geometry);
        Some(Self { element, weights: [1.0 - share, share], length })
    }
}

/// Where a seal cuts the sheet as it stands at the start of a step: looked for from the edge inward, for a dome may bulge
/// out over its seal.
#[derive(Clone, Copy, Debug)]
pub struct Seal {
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
