//! Where beads hold the sheet and seals cut it, as it stands at the start of a step.

use crate::model::{Bead, Model};
use crate::state::State;
use std::cmp::Ordering;

/// A bead's restraint fades over the last stretch of the sheet that passes it, this many thicknesses long.
const FADE: f64 = 3.0;

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
        let fade = (beyond / (FADE * model.blank.thickness)).min(1.0);
        let length = fade * bead.line(model.geometry);
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
