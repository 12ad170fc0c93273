//! Contact of the sheet with its tools.
//!
//! Contact acts at points inside the elements ([`Station`](crate::element::surface::Station)), on the sheet's face:
//!
//! ```text
//! g = d(x(ξ)) − t/2,   t = t₀ exp(−Δε_s − Δε_θ)
//! δW = F·δx(ξ) + Q δt,   Q = −N/2,   δt = −t (δε_s + δε_θ)
//! ```
//!
//! Q acts as a force N t/2 on the membrane strains: the in-plane stress is lower by the mean normal stress p/2. Without friction
//! F and Q are the gradient of one potential, and the matrix is symmetric.

mod assembly;

use crate::contact::penalty::ValueAndSlope;
use crate::contact::{ContactLaw, ContactPoint};
use crate::element::surface::{STATIONS, stations};
use crate::geometry::Point;
use crate::model::Iteration;
use crate::solver::contact_force_tangent::{ContactCandidate, ContactForceTangent, ContactPosition, slope};
use crate::solver::evaluation::{Contact, Evaluation, Linearisation};
use crate::solver::step::Step;
use crate::solver::trial::Trial;

/// Adds contact and friction of all tools; returns the largest force on a point.
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> f64 {
    locate(step, out);
    out.contact_tangents.fill(ContactForceTangent::default());
    out.active_contacts = 0;
    let mut largest: f64 = 0.0;
    for j in 0..step.context.tools.len() {
        if step.context.tools[j].is_absent() {
            out.tool_force[j] = Point::zeros();
            out.contacts.row_mut(j).fill(Contact::free());
        } else {
            largest = largest.max(press(step, trial, at, j, out));
        }
    }
    assembly::assemble(step, at, out);
    largest
}

fn locate(step: &Step, out: &mut Evaluation) {
    for (e, places) in out.contact_positions.chunks_exact_mut(STATIONS).enumerate() {
        for (place, station) in places.iter_mut().zip(stations(step.bends[e])) {
            *place = ContactPosition::new(
                station,
                &out.nodes[e],
                &out.nodes[e + 1],
                out.thickness[e],
                step.half_thickness_difference[e],
            );
        }
    }
}

/// Forces of tool `j` on the points of the sheet; returns the largest.
fn press(step: &Step, trial: &mut Trial, at: &Linearisation, j: usize, out: &mut Evaluation) -> f64 {
    gather(step, trial, at, j, out);
    let (context, tool) = (step.context, &step.context.tools[j]);
    let law = ContactLaw {
        penalty: &context.penalty,
        friction: &tool.friction,
        slip_scale: step.slip_scale,
        duration: step.dt,
    };
    let (contacts, memories) = (out.contacts.row_mut(j), trial.contacts.row_mut(j));
    let (mut largest, mut whole): (f64, Point) = (0.0, Point::zeros());
    for ContactCandidate { index: i, point, by_thickness } in &out.near {
        let force = law.force(point);
        let (e, tangent) = (i / STATIONS, ContactForceTangent::new(&force, *by_thickness));
        let contact = &mut contacts[*i];
        (contact.normal, contact.tangential, contact.slip) = (force.normal, force.tangential, force.slip);
        (contact.pressure, memories[*i].pressure) = (force.pressure, force.pressure);
        let force = tangent.force.xy();
        largest = largest.max(force.norm());
        whole += force;
        out.active_contacts += usize::from(point.gap < 0.0);
        let sum = &mut out.contact_tangents[*i];
        sum.force += tangent.force;
        sum.matrix += tangent.matrix;
        if let Some(shared) = tool.shared.filter(|_| !at.residual_alone) {
            let station = &stations(step.bends[e])[i % STATIONS];
            let slope = slope(station, &out.nodes[e], &out.nodes[e + 1], &out.thickness_rows[e]);
            tangent.follow(e, &slope, shared, &mut out.system);
        }
    }
    out.tool_force[j] = whole;
    largest
}

/// Measures the gaps of the points that tool `j` may reach.
fn gather(step: &Step, trial: &mut Trial, at: &Linearisation, j: usize, out: &mut Evaluation) {
    let Step { context, state, .. } = *step;
    let (tool, displacement) = (&context.tools[j], trial.tools[j]);
    let moved = displacement - state.tools[j];
    let reach = context.penalty.reach();
    let memories = trial.contacts.row_mut(j).iter_mut().zip(state.pressure.row(j));
    let points = out.contacts.row_mut(j).iter_mut().zip(memories).zip(&out.contact_positions);
    out.near.clear();
    for (i, ((contact, (memory, pressure)), place)) in points.enumerate() {
        let ContactPosition { position: x, thickness } = *place;
        let position = x - displacement;
        // A distance changes no faster than the point moves: far away it need not be measured again.
        let free = memory.carried == 0.0 && memory.pressure.slope == 0.0 && *pressure == 0.0;
        let shift = memory.shift;
        let way = (position - memory.position).norm();
        let away = memory.distance - way;
        if free && away > 0.5 * thickness + reach - shift {
            if contact.gap < f64::INFINITY {
                *contact = Contact::free();
                memory.gap = f64::INFINITY;
            }
            continue;
        }
        let closest = tool.profile.closest_after(position, way, &mut memory.nearest);
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
        let station = &stations(step.bends[e])[k];
        let relative = x - station.position(&state.nodes[e], &state.nodes[e + 1]) - moved;
        let point = ContactPoint {
            facing: closest.normal,
            curvature: closest.curvature,
            gap,
            relative,
            area: step.areas[i] * face,
            carried: memory.carried,
            shift,
            shear_yield: step.shear_yield[e],
        };
        *contact =
            Contact { gap: gap + 0.5 * going, closing: 0.5 * going, facing: closest.normal, ..Contact::default() };
        memory.gap = gap;
        out.near.push(ContactCandidate { index: i, point, by_thickness: -0.5 * share });
    }
}

/// Measures the gaps that the iterations did not need, for the length of the next step and the contact share.
pub fn measure_far(step: &Step, trial: &mut Trial, out: &mut Evaluation) {
    for (j, tool) in step.context.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
        let pairs = out.contacts.row_mut(j).iter_mut().zip(trial.contacts.row_mut(j)).zip(&out.contact_positions);
        for ((contact, memory), place) in pairs.filter(|((contact, _), _)| contact.gap.is_infinite()) {
            let position = place.position - trial.tools[j];
            let moved = (position - memory.position).norm();
            memory.distance = tool.profile.closest_after(position, moved, &mut memory.nearest).distance;
            memory.position = position;
            contact.gap = place.gap(memory.distance);
        }
    }
}
