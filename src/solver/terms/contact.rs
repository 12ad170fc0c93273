//! Contact of the sheet with its tools.
//!
//! Contact acts at points inside the elements ([`Station`](crate::element::surface::Station)), on the sheet's face. Q acts as a
//! force N t/2 on the membrane strains: the in-plane stress is lower by the mean normal stress p/2.

use crate::contact::{ContactForce, ContactPoint};
use crate::element::{Vector6, kinematics::Matrix6, surface::add_position_second, surface::add_thickness_second};
use crate::solver::{evaluation::Contact, evaluation::ContactPosition, evaluation::Linearisation, *};
use nalgebra::Matrix3;

/// Adds contact and friction of all tools; returns the largest force on a point.
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> f64 {
    for (e, places) in out.contact_positions.chunks_exact_mut(STATIONS).enumerate() {
        for (k, place) in places.iter_mut().enumerate() {
            let (ends, rise) = ([&out.nodes[e], &out.nodes[e + 1]], step.half_thickness_difference[e]);
            *place = ContactPosition::new(&step.stations()[k], ends, out.thickness[e], rise);
        }
    }
    out.contact_sums.fill((Vector3::zeros(), Matrix3::zeros()));
    out.active_contacts = 0;
    let mut largest: f64 = 0.0;
    for (j, tool) in step.context.tools.iter().enumerate() {
        out.tool_force[j] = Point::zeros();
        if tool.is_absent() {
            out.contacts.row_mut(j).fill(Contact::free());
        } else {
            largest = largest.max(press(step, trial, at, j, out));
        }
    }
    assemble(step, at, out);
    largest
}

fn press(step: &Step, trial: &mut Trial, at: &Linearisation, j: usize, out: &mut Evaluation) -> f64 {
    let Step { context, state, slip_scale, dt, .. } = *step;
    let (tool, displacement) = (&context.tools[j], trial.tools[j]);
    let reach = context.penalty.reach();
    let mut largest: f64 = 0.0;
    for i in 0..out.contact_positions.len() {
        let (contact, memory) = (&mut out.contacts[(j, i)], &mut trial.contacts[(j, i)]);
        let ContactPosition { position: x, thickness } = out.contact_positions[i];
        let position = x - displacement;
        // A distance changes no faster than the point moves: far away it need not be measured again.
        let free = memory.carried == 0.0 && memory.pressure.slope == 0.0 && state.pressure[(j, i)] == 0.0;
        let moved = (position - memory.position).norm();
        if free && memory.distance - moved > 0.5 * thickness + reach - memory.shift {
            if contact.gap < f64::INFINITY {
                *contact = Contact::free();
                memory.gap = f64::INFINITY;
            }
            continue;
        }
        let closest = tool.profile.closest_after(position, moved, &mut memory.nearest);
        (memory.position, memory.distance) = (position, closest.distance);
        let (e, k) = (i / STATIONS, i % STATIONS);
        let [a, b] = [&out.nodes[e], &out.nodes[e + 1]];
        // A tool above the sheet faces down: its normal crosses the element from left to right.
        let above = closest.normal.y * (b[0] - a[0]) < closest.normal.x * (b[1] - a[1]);
        let face = step.faces[e][usize::from(above)];
        // Thinning in the step moves the face by half of it, over the ratio of the areas.
        let share = 1.0 / face;
        let going = (share - 1.0) * (out.thickness[e] - state.thickness[e]);
        let gap = closest.distance - 0.5 * (thickness + going);
        if at.matrix != Iteration::PrimalDual {
            memory.carried = 0.0;
        } else if at.iteration > 0 {
            let ValueAndSlope { value, slope } = memory.pressure;
            memory.carried = (value + slope * (gap - memory.gap)).max(0.0);
        }
        let start = step.stations()[k].position(&state.nodes[e], &state.nodes[e + 1]);
        let point = ContactPoint {
            facing: closest.normal,
            curvature: closest.curvature,
            gap,
            by_thickness: -0.5 * share,
            relative: x - start - (displacement - state.tools[j]),
            area: step.areas[i] * face,
            // The residual does not feel the carried pressure.
            carried: if at.residual_alone { 0.0 } else { memory.carried },
            shift: memory.shift,
            shear_yield: step.shear_yield[e],
        };
        let force = point.force(&context.penalty, &tool.friction, slip_scale, dt);
        (memory.gap, memory.pressure) = (gap, force.pressure);
        let ContactForce { normal, tangential, slip, pressure, .. } = force;
        let (closing, facing) = (0.5 * going, closest.normal);
        *contact = Contact { gap: gap + closing, closing, normal, tangential, slip, pressure, facing };
        largest = largest.max(force.force.xy().norm());
        out.tool_force[j] += force.force.xy();
        out.active_contacts += usize::from(gap < 0.0);
        let sum = &mut out.contact_sums[i];
        (sum.0, sum.1) = (sum.0 + force.force, sum.1 + force.matrix);
        if let Some(shared) = tool.shared.filter(|_| !at.residual_alone) {
            // The forces depend on the tool's displacement as on the point's z, with the opposite sign.
            let (g, k) = (gradient(step, i, out), &force.matrix);
            let column = g[0] * k.m12 + g[1] * k.m22 + g[2] * k.m32;
            let row = g[0] * k.m21 + g[1] * k.m22 + g[2] * k.m23;
            let system = &mut out.system;
            for (node, first) in [(e, 0), (e + 1, 3)] {
                system.columns[node][shared] += column.fixed_rows::<3>(first);
                system.rows[node][shared] += row.fixed_rows::<3>(first);
            }
            system.corner[(shared, shared)] -= force.matrix.m22;
        }
    }
    largest
}

/// G: derivatives of r and z of contact point `i` and of its element's thickness by the element's freedoms.
fn gradient(step: &Step, i: usize, out: &Evaluation) -> [Vector6; 3] {
    let (e, station) = (i / STATIONS, &step.stations()[i % STATIONS]);
    let [r, z] = station.slopes(&out.nodes[e], &out.nodes[e + 1]);
    [r, z, out.thickness_rows[e]]
}

fn assemble(step: &Step, at: &Linearisation, out: &mut Evaluation) {
    for e in 0..step.references.len() {
        let (mut forces, mut matrix) = (Vector6::zeros(), Matrix6::zeros());
        let (mut bowed, mut squeeze, mut acts, thickness) = (Point::zeros(), 0.0, false, out.thickness[e]);
        for (i, station) in (STATIONS * e..).zip(step.stations()) {
            let (f, k) = &out.contact_sums[i];
            // The chord to a carried pressure has a slope beyond the reach too.
            if f.z == 0.0 && k.m33 == 0.0 {
                continue;
            }
            acts = true;
            let g = gradient(step, i, out);
            forces += g[0] * f.x + g[1] * f.y + g[2] * f.z;
            squeeze += f.z;
            if !at.residual_alone {
                bowed -= station.bow * f.xy();
                // With ∂t ∂tᵀ/t of the thickness' second derivative.
                let by_thickness = [k.m13, k.m23, k.m33 + f.z / thickness];
                let row = |i: usize| g[0] * k[(i, 0)] + g[1] * k[(i, 1)] + g[2] * by_thickness[i];
                let kg = [row(0), row(1), row(2)];
                for j in 0..6 {
                    for i in 0..6 {
                        matrix[(i, j)] -= g[0][i] * kg[0][j] + g[1][i] * kg[1][j] + g[2][i] * kg[2][j];
                    }
                }
            }
        }
        if !acts {
            continue;
        }
        out.system.add_forces(e, &forces);
        if !at.residual_alone {
            add_position_second(&mut matrix, bowed);
            add_thickness_second(&mut matrix, &out.thickness_rows[e], thickness, -squeeze);
            out.system.add_element(e, &matrix);
        }
    }
}

/// Measures the gaps that the iterations did not need, for the length of the next step and the contact share.
pub fn measure_far(step: &Step, trial: &mut Trial, out: &mut Evaluation) {
    for (j, tool) in step.context.acting_tools() {
        let pairs = out.contacts.row_mut(j).iter_mut().zip(trial.contacts.row_mut(j)).zip(&out.contact_positions);
        for ((contact, memory), place) in pairs.filter(|((contact, _), _)| contact.gap.is_infinite()) {
            let position = place.position - trial.tools[j];
            let moved = (position - memory.position).norm();
            memory.distance = tool.profile.closest_after(position, moved, &mut memory.nearest).distance;
            memory.position = position;
            contact.gap = memory.distance - 0.5 * place.thickness;
        }
    }
}
