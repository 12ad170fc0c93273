//! Contact of the sheet with its tools: which point of the sheet touches which tool, with what pressure, and what that adds.
//!
//! Contact acts at points inside the elements ([`Station`]), on the sheet's face, with the element's own thickness:
//!
//! ```text
//! g = d(x(ξ)) − t/2,   t = t₀ exp(−Δε_s − Δε_θ)
//! δW = F·δx(ξ) + Q δt,   Q = −N/2,   δt = −t (δε_s + δε_θ)
//! ```
//!
//! The second part is a force N t/2 on the membrane strains: the stress that equilibrium sees in the plane of the sheet is
//! lower by p/2, which is the mean normal stress −p/2 of a sheet pressed on one face in the plane-stress flow law. Between
//! two walls both parts add up to −p: the sheet is ironed. Without friction F and Q are the gradient of one potential, and
//! the matrix is symmetric.

use crate::contact::penalty::ValueAndSlope;
use crate::contact::{ContactForce, ContactPoint, touch};
use crate::element::kinematics::Current;
use crate::element::surface::{MotionForces, STATIONS, Slope, Station, stations};
use crate::geometry::{Point, turned};
use crate::model::Iteration;
use crate::numerics::block_tridiagonal::System;
use crate::solver::evaluation::{Contact, Evaluation, Linearisation};
use crate::solver::step::Step;
use crate::solver::trial::{ContactMemory, Trial};

/// Contact and friction of every tool with every point it reaches; returns the largest force of one on one.
pub fn add(step: &Step, trial: &mut Trial, at: &Linearisation, out: &mut Evaluation) -> f64 {
    let Step { process, state, dt, .. } = *step;
    let mut largest: f64 = 0.0;
    out.active_contacts = 0;
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
        for e in 0..out.thickness.len() {
            let [a, b] = [out.nodes[e], out.nodes[e + 1]];
            let (mut pressed, mut touched) = (Pressed::default(), false);
            for (k, station) in stations(step.bends[e]).iter().enumerate() {
                let i = STATIONS * e + k;
                let thickness = out.thickness[e] + station.xi * step.rise[e];
                let x = station.position(&a, &b);
                let position = x - displacement;
                let (contact, memory) = (&mut contacts[i], &mut memories[i]);
                // A distance changes no faster than the point moves: far away it need not be measured again.
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
                let above = closest.normal.dot(&turned(Point::new(b[0] - a[0], b[1] - a[1]))) < 0.0;
                let face = step.faces[e][usize::from(above)];
                // Half the thickness that goes in the step goes with a force on the face, by the ratio of the areas.
                let going = (1.0 / face - 1.0) * (out.thickness[e] - state.thickness[e]);
                let gap = closest.distance - 0.5 * (thickness + going);
                if at.matrix != Iteration::PrimalDual {
                    memory.carried = 0.0;
                } else if at.iteration > 0 {
                    let ValueAndSlope { value, slope } = memory.pressure;
                    memory.carried = (value + slope * (gap - memory.gap)).max(0.0);
                }
                let point = ContactPoint {
                    carried: memory.carried,
                    position,
                    relative: x - station.position(&state.nodes[e], &state.nodes[e + 1]) - moved,
                    thickness: thickness + going,
                    area: step.areas[i] * face,
                    shift,
                    slip_scale: step.slip_scale,
                    duration: dt,
                    shear_yield: step.shear_yield[e],
                };
                *contact = Contact {
                    gap: gap + 0.5 * going,
                    closing: 0.5 * going,
                    facing: closest.normal,
                    ..Contact::default()
                };
                (memory.gap, memory.pressure) = (gap, ValueAndSlope::default());
                let Some(touch) = touch(&closest, &process.penalty, &tool.friction, &point) else { continue };
                contact.normal = touch.normal;
                contact.tangential = touch.tangential;
                contact.slip = touch.slip;
                contact.pressure = touch.pressure;
                memory.pressure = touch.pressure;
                let force = touch.force();
                largest = largest.max(force.norm());
                out.tool_force[j] += force;
                out.active_contacts += usize::from(touch.gap < 0.0);
                let (slope, follows) = (station.slope(&a, &b), tool.shared.is_some());
                let thinning = out.thickness_rows[e].map(|by| by / face);
                pressed.add(station, &slope, out.thickness[e] / face, &thinning, &touch, follows);
                touched = true;
            }
            if touched {
                pressed.stiffen(&out.currents[e]);
                pressed.assemble(e, tool.shared, &mut out.system);
            }
        }
    }
    largest
}

/// What a tool adds to an element.
#[derive(Default)]
struct Pressed {
    /// Forces on the sheet and their derivatives.
    sheet: MotionForces,
    /// Their derivatives by the tool's displacement along z, but for the sign.
    by_tool: [f64; 5],
    /// Derivatives of the tool's force along z by the motions, and by its own displacement but for the sign.
    tool_by: [f64; 5],
    tool_by_tool: f64,
    /// Σ N t/2, the tension that the squeeze amounts to \[N mm\].
    tension: f64,
}

impl Pressed {
    /// Adds the force at one point, whose position has the derivatives `slope`, and the thickness the derivatives `thinning`;
    /// `follows` where the tool's position is an unknown.
    ///
    /// ```text
    /// G = n·∂x − ½ ∂t,  S = τ·∂x          rows of the gap and of a move along τ by the motions
    /// f = N G + T S
    /// ∂f = ∂N/∂g G⊗G + S⊗(∂T/∂g G + (∂T/∂s + N c) S) − T c (n·∂x)⊗S + F·∂²x + Q ∂²t
    /// ```
    #[inline]
    fn add(
        &mut self,
        station: &Station,
        slope: &Slope,
        thickness: f64,
        thinning: &[f64; 3],
        touch: &ContactForce,
        follows: bool,
    ) {
        let (n, tau, c) = (touch.facing, touch.along(), touch.curvature);
        let (normal, along) = (slope.of(n), slope.of(tau));
        let t = [thinning[0], 0.0, thinning[1], thinning[2], 0.0];
        let (slip, turning) = (touch.drag_by_slip * touch.slip_turn + touch.normal * c, -touch.tangential * c);
        // ∂²t = t tᵀ/thickness − thickness ∂²(ε_s + ε_θ), of which the last is left to `stiffen`.
        let squeeze = -0.5 * touch.normal / thickness;
        let (mut gap, mut drag) = ([0.0; 5], [0.0; 5]);
        for i in 0..5 {
            gap[i] = normal[i] - 0.5 * t[i];
            drag[i] = touch.drag_by_gap * gap[i] + slip * along[i];
            self.sheet.force[i] += touch.normal * gap[i] + touch.tangential * along[i];
        }
        for i in 0..5 {
            let (pressing, sliding) = (touch.by_gap * gap[i], turning * normal[i]);
            let row = &mut self.sheet.matrix[i];
            for j in 0..5 {
                row[j] += pressing * gap[j] + along[i] * drag[j] + sliding * along[j] + squeeze * t[i] * t[j];
            }
        }
        let second = station.second(touch.force());
        for d in 0..2 {
            self.sheet.matrix[4][2 + d] += second[d];
            self.sheet.matrix[2 + d][4] += second[d];
        }
        self.tension += 0.5 * touch.normal * thickness;
        if follows {
            // Along z the tool takes n_z of the gap and τ_z of the slip.
            let (pressing, dragging) = (touch.by_gap * n.y, touch.drag_by_gap * n.y + slip * tau.y);
            for i in 0..5 {
                self.by_tool[i] += pressing * gap[i] + dragging * along[i] + turning * tau.y * normal[i];
                self.tool_by[i] += pressing * gap[i] + tau.y * drag[i] + turning * n.y * along[i];
            }
            self.tool_by_tool += pressing * n.y + dragging * tau.y + turning * n.y * tau.y;
        }
    }

    /// The geometric stiffness of the squeeze.
    fn stiffen(&mut self, current: &Current) {
        let stiffness = current.geometric_stiffness(&[self.tension, self.tension, 0.0, 0.0, 0.0]);
        let [rr, rz, zz] = stiffness.difference;
        let m = &mut self.sheet.matrix;
        m[0][0] += stiffness.hoop;
        m[2][2] += rr;
        m[2][3] += rz;
        m[3][2] += rz;
        m[3][3] += zz;
    }

    /// Adds to the system; `shared` is the index of the tool's position where that is an unknown.
    fn assemble(&self, e: usize, shared: Option<usize>, system: &mut System) {
        let (first, second) = (-1.0, 1.0);
        system.diagonal[e] -= self.sheet.block(first, first);
        system.upper[e] -= self.sheet.block(first, second);
        system.lower[e + 1] -= self.sheet.block(second, first);
        system.diagonal[e + 1] -= self.sheet.block(second, second);
        for (i, node) in [(e, first), (e + 1, second)] {
            system.rhs[i] += MotionForces::of_node(node, &self.sheet.force);
            if let Some(k) = shared {
                system.columns[i][k] += MotionForces::of_node(node, &self.by_tool);
                system.rows[i][k] += MotionForces::of_node(node, &self.tool_by);
            }
        }
        if let Some(k) = shared {
            system.corner[(k, k)] -= self.tool_by_tool;
        }
    }
}

/// Measures the gaps that the iterations of a converged step did not need; the balance of work does.
pub fn measure_far(step: &Step, trial: &mut Trial, out: &mut Evaluation) {
    for (j, tool) in step.process.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
        for e in 0..out.thickness.len() {
            for (k, station) in stations(step.bends[e]).iter().enumerate() {
                let i = STATIONS * e + k;
                let contact = &mut out.contacts[(j, i)];
                if contact.gap.is_infinite() {
                    let ContactMemory { position, distance, .. } = &mut trial.contacts[(j, i)];
                    *position = station.position(&out.nodes[e], &out.nodes[e + 1]) - trial.tools[j];
                    *distance = tool.profile.closest(*position).distance;
                    contact.gap = *distance - 0.5 * out.thickness[e];
                }
            }
        }
    }
}
