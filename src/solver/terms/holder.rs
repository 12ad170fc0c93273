//! Equations of tools pressed by a force, whose positions are shared unknowns.
//!
//! ```text
//! φ(b) (F₀(travel) − c w − F_beads) − F_blocks(w) − F_sheet = 0
//! ```
//!
//! of the solved half of a plane section, with the move w towards the sheet, the stiffness c of springs or cushion and the force of
//! the distance blocks; φ falls from 1 to 0 as the width b of the sheet under the tool runs out.

use super::{bead, sheet::STABILISATION};
use crate::solver::{restraints::Grip, restraints::fade, restraints::fading, *};

pub fn add(step: &Step, trial: &Trial, out: &mut Evaluation) {
    let (context, model) = (step.context, step.model);
    let closing = bead::closing_force(step);
    let die = model.tool_index(Role::Die);
    let die = die.map_or(0.0, |j| trial.tools[j].y - waiting_displacement(model, &model.tools[j]));
    let times = model.extent().times();
    let block_area = model.geometry.area(model.blank.length);
    let system = &mut out.system;
    out.block_force = 0.0;
    for (j, tool) in context.tools.iter().enumerate() {
        let (Some(k), Motion::Pressed(press)) = (tool.shared, &tool.motion) else { continue };
        if tool.released.is_some() {
            system.corner[(k, k)] = 1.0;
            continue;
        }
        let moved = trial.tools[j].y;
        let springs = press.stiffness / times;
        let mut force = -tool.role.side() * press.force.at(step.travel()) / times - springs * moved;
        if tool.role == Role::Holder {
            force -= closing;
        }
        let grip = Grip::new(tool.inner, trial.tools[j], &out.nodes, step.model.blank.theory);
        let share = fading(grip.width, fade(model, tool.inner));
        system.corner[(k, k)] += share.value * springs;
        for (i, weight) in (out.nodes.len() - 2..).zip(grip.weights) {
            system.rows[i][k].x -= share.slope * weight * force;
        }
        let blocks = context.blocks.filter(|_| tool.role == Role::Holder);
        if let Some(block) = blocks.map(|height| context.penalty.at(height + die - moved)) {
            out.block_force = block_area * block.value;
            system.corner_rhs[k] -= block_area * block.value;
            system.corner[(k, k)] -= block_area * block.slope;
        }
        let stabilisation = STABILISATION * block_area * context.penalty.stiffness;
        // The punch takes the pad along.
        let along = match tool.role {
            Role::Pad => step.travel() - step.state.travel,
            Role::Upper(_) | Role::Lower(_) => step.state.tool_velocity[j] * step.dt,
            _ => 0.0,
        };
        system.corner_rhs[k] -= stabilisation * (moved - step.state.tools[j].y - along);
        system.corner[(k, k)] += stabilisation;
        system.corner_rhs[k] -= out.tool_force[j].y - share.value * force;
    }
}
