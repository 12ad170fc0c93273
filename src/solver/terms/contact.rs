//! Contact of the sheet with its tools: which node touches which tool, with what pressure, and what that adds.

use crate::contact::penalty::ValueAndSlope;
use crate::contact::{ContactNode, touch};
use crate::geometry::Point;
use crate::model::Iteration;
use crate::solver::evaluation::{Contact, Evaluation, Linearisation};
use crate::solver::process::Process;
use crate::solver::step::Step;
use crate::solver::trial::{ContactMemory, Trial};
use crate::state::thickness_at;
use nalgebra::{Matrix3, Vector3};

/// Contact and friction of every tool with every node it reaches; returns the largest force of one on one.
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> f64 {
    let Step { process, state, dt, .. } = *step;
    let mut largest: f64 = 0.0;
    out.active_contacts = 0;
    let last = out.nodes.len() - 1;
    let system = &mut out.system;
    for (j, tool) in process.tools.iter().enumerate() {
        out.tool_force[j] = Point::zeros();
        let contacts = out.contacts.row_mut(j);
        if tool.is_absent() {
            contacts.fill(Contact::free());
            continue;
        }
        let (memories, pressures) = (trial.contacts.row_mut(j), state.pressure.row(j));
        let displacement = trial.tools[j];
        let moved = displacement - state.tools[j];
        for i in 0..=last {
            let (before, after) = (i.max(1) - 1, i.min(last - 1));
            let thickness = thickness_at(&out.thickness, i);
            let x = &out.nodes[i];
            let position = Point::new(x[0] - displacement.x, x[1] - displacement.y);
            let (contact, memory) = (&mut contacts[i], &mut memories[i]);
            // A distance changes no faster than the node moves: far away it need not be measured again.
            let free = memory.carried == 0.0 && memory.pressure.slope == 0.0 && pressures[i] == 0.0;
            let shift = memory.shift;
            let reach = 0.5 * thickness + process.penalty.reach() - shift;
            if free && memory.distance - (position - memory.position).norm() > reach {
                *contact = Contact::free();
                memory.gap = f64::INFINITY;
                continue;
            }
            let closest = tool.profile.closest(position);
            (memory.position, memory.distance) = (position, closest.distance);
            let gap = closest.distance - 0.5 * thickness;
            if at.matrix != Iteration::PrimalDual {
                memory.carried = 0.0;
            } else if at.iteration > 0 {
                let ValueAndSlope { value, slope } = memory.pressure;
                memory.carried = (value + slope * (gap - memory.gap)).max(0.0);
            }
            let node = ContactNode {
                carried: memory.carried,
                position,
                relative: Point::new(trial.moves[i][0], trial.moves[i][1]) - moved,
                thickness,
                area: step.areas[i],
                shift,
                slip_scale: step.slip_scale,
                duration: dt,
                shear_yield: step.shear_yield[i],
            };
            *contact = Contact { distance: closest.distance, gap, facing: closest.normal, ..Contact::default() };
            (memory.gap, memory.pressure) = (gap, ValueAndSlope::default());
            let Some(touch) = touch(&closest, &process.penalty, &tool.friction, &node) else { continue };
            contact.normal = touch.normal;
            contact.tangential = touch.tangential;
            contact.slip = touch.slip;
            contact.pressure = touch.pressure;
            memory.pressure = touch.pressure;

            system.rhs[i].x += touch.force.x;
            system.rhs[i].y += touch.force.y;
            let mut own = Matrix3::zeros();
            own.fixed_view_mut::<2, 2>(0, 0).copy_from(&touch.by_position);
            system.diagonal[i] -= own;
            if let Some(k) = tool.shared {
                let by_tool = touch.by_position.column(1);
                system.columns[i][k] += Vector3::new(by_tool.x, by_tool.y, 0.0);
                system.rows[i][k] += own.row(1).transpose();
                system.corner[(k, k)] -= by_tool.y;
            }
            // The sheet thins as its elements stretch: ∂F/∂t ∂t/∂x reaches both neighbours.
            let by_thickness = Vector3::new(touch.by_thickness.x, touch.by_thickness.y, 0.0) * 0.5;
            for e in [before, after] {
                let row = &out.thickness_rows[e];
                let first = Vector3::new(row[0], row[1], row[2]);
                let second = Vector3::new(row[3], row[4], row[5]);
                let (first_block, second_block) = if e == i {
                    (&mut system.diagonal[i], &mut system.upper[i])
                } else {
                    (&mut system.lower[i], &mut system.diagonal[i])
                };
                *first_block -= by_thickness * first.transpose();
                *second_block -= by_thickness * second.transpose();
                if let Some(k) = tool.shared {
                    system.rows[e][k] += first * by_thickness.y;
                    system.rows[e + 1][k] += second * by_thickness.y;
                }
            }

            largest = largest.max(touch.force.norm());
            out.tool_force[j] += touch.force;
            out.active_contacts += usize::from(touch.gap < 0.0);
        }
    }
    largest
}

/// Measures the distances that the iterations of a converged step did not need; the balance of work does.
pub fn measure_far(process: &Process, trial: &mut Trial, out: &mut Evaluation) {
    for (j, tool) in process.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
        let pairs = out.contacts.row_mut(j).iter_mut().zip(trial.contacts.row_mut(j));
        for ((contact, memory), x) in pairs.zip(&out.nodes).filter(|((contact, _), _)| contact.distance.is_infinite()) {
            let ContactMemory { position, distance, .. } = memory;
            *position = Point::new(x[0] - trial.tools[j].x, x[1] - trial.tools[j].y);
            *distance = tool.profile.closest(*position).distance;
            contact.distance = *distance;
        }
    }
}
