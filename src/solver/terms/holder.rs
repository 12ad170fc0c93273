//! The equations of tools that are pressed by a force: their positions are shared unknowns.
//!
//! ```text
//! φ(b) (F₀(travel) − c w − F_beads) − F_blocks(w) − F_sheet = 0
//! ```
//!
//! of what is solved, of a plane section one half of the force that is given; with the tool's move w towards the die, springs or a cushion of stiffness c, and what its distance blocks bear; φ falls
//! from 1 to 0 as the width b of the sheet under the tool runs out.

use super::bead;
use super::sheet::STABILISATION;
use crate::model::{Motion, Role};
use crate::solver::evaluation::Evaluation;
use crate::solver::places::Grip;
use crate::solver::state::waiting_displacement;
use crate::solver::step::Step;
use crate::solver::trial::Trial;

/// The holder's equation and its matrix; what its blocks bear.
pub fn add(step: &Step, trial: &Trial, out: &mut Evaluation) {
    let (process, model) = (step.process, step.model);
    let closing = bead::closing_force(step);
    // The blocks stand on the die and go with it.
    let die = model.tools.iter().position(|tool| tool.role == Role::Die);
    let die = die.map_or(0.0, |j| trial.tools[j].y - waiting_displacement(model, &model.tools[j]));
    let times = model.extent().times();
    let block_area = model.geometry.area(model.blank.length);
    let system = &mut out.system;
    for (j, tool) in process.tools.iter().enumerate() {
        let (Some(k), Motion::Pressed(press)) = (tool.shared, &tool.motion) else { continue };
        if tool.released.is_some() {
            out.block_force = 0.0;
            system.corner[(k, k)] = 1.0;
            continue;
        }
        let moved = trial.tools[j].y;
        let springs = press.stiffness / times;
        let mut force = press.force.at(step.travel()) / times - springs * moved;
        if tool.role == Role::Holder {
            force -= closing;
        }
        let grip = Grip::new(tool.inner, trial.tools[j], &out.nodes, &step.bends);
        let share = grip.share(model.blank.thickness);
        system.corner[(k, k)] += share.value * springs;
        for (i, weight) in (out.nodes.len() - 2..).zip(grip.weights) {
            system.rows[i][k].x -= share.slope * weight * force;
        }
        let block = process.blocks.map(|height| process.penalty.at(height + die - moved));
        out.block_force = block.map_or(0.0, |block| block_area * block.value);
        if let Some(block) = block {
            system.corner_rhs[k] -= block_area * block.value;
            system.corner[(k, k)] -= block_area * block.slope;
        }
        let stabilisation = STABILISATION * block_area * process.penalty.stiffness;
        system.corner_rhs[k] -= stabilisation * (moved - step.state.tools[j].y);
        system.corner[(k, k)] += stabilisation;
        system.corner_rhs[k] -= out.tool_force[j].y - share.value * force;
    }
}
