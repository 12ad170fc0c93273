//! Draw beads: line restraints across the flange, regularised like friction.

use crate::contact::friction::direction;
use crate::solver::{evaluation::BeadForce, *};

/// Closing force of the beads, taken from the holder's \[N, or N/mm\].
pub fn closing_force(step: &Step) -> f64 {
    let beads = step.beads.iter().zip(&step.model.beads);
    beads.map(|(place, bead)| place.map_or(0.0, |place| place.length * bead.closing)).sum()
}

pub fn add(step: &Step, trial: &Trial, out: &mut Evaluation) {
    let system = &mut out.system;
    for (acting, (place, bead)) in out.bead_force.iter_mut().zip(step.beads.iter().zip(&step.model.beads)) {
        *acting = BeadForce::default();
        let Some(place) = place else { continue };
        let [a, b] = [place.element, place.element + 1];
        let [wa, wb] = place.weights;
        let slip = wa * trial.moves[a][0] + wb * trial.moves[b][0];
        let phi = direction(slip, step.slip_scale);
        let full = place.length * bead.restraining.at(step.travel());
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
