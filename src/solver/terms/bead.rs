//! Draw beads across the flange: a line restraint against the sheet's move, regularised like friction.

use crate::contact::friction::direction;
use crate::model::{Bead, Model};
use crate::solver::equilibrium::Evaluation;
use crate::solver::step::Step;
use crate::solver::trial::Trial;
use crate::state::State;

/// A bead's restraint fades over the last stretch of the sheet that passes it, this many thicknesses long.
const FADE: f64 = 3.0;

/// Where a bead acts in a step: on the two nodes around it, by these shares of its force.
#[derive(Clone, Copy, Debug)]
pub struct BeadPlace {
    element: usize,
    weights: [f64; 2],
    /// Length of the line times the share of the bead that still holds the sheet \[mm, or – per depth\].
    length: f64,
}

/// Force of a bead on the sheet along r \[N, or N/mm\], and the sheet's slip through it in the step \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub struct BeadForce {
    pub force: f64,
    pub slip: f64,
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

/// What the beads take from the holder's force to stay closed \[N, or N/mm\].
pub fn closing_force(step: &Step) -> f64 {
    let beads = step.beads.iter().zip(&step.model.beads);
    beads.map(|(place, bead)| place.map_or(0.0, |place| place.length * bead.closing)).sum()
}

/// The beads' forces and their matrix.
pub fn add(step: &Step, trial: &Trial, out: &mut Evaluation) {
    let system = &mut out.system;
    for (acting, (place, bead)) in out.bead_force.iter_mut().zip(step.beads.iter().zip(&step.model.beads)) {
        *acting = BeadForce::default();
        let Some(place) = place else { continue };
        let [a, b] = [place.element, place.element + 1];
        let [wa, wb] = place.weights;
        let slip = wa * trial.moves[a][0] + wb * trial.moves[b][0];
        let phi = direction(slip, step.slip_scale);
        let full = place.length * bead.restraining;
        let force = -full * phi.value;
        *acting = BeadForce { force, slip };
        let stiffness = full * phi.slope;
        system.rhs[a].x += wa * force;
        system.rhs[b].x += wb * force;
        system.diagonal[a][(0, 0)] += wa * wa * stiffness;
        system.diagonal[b][(0, 0)] += wb * wb * stiffness;
        system.upper[a][(0, 0)] += wa * wb * stiffness;
        system.lower[b][(0, 0)] += wa * wb * stiffness;
    }
}
