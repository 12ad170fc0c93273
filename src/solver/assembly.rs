//! Equilibrium at the end of a step: the residual r = p − f and its matrix H (Sosnowski 1994, equations 7 to 9).

use super::block_tridiagonal::System;
use crate::contact::friction::Coulomb;
use crate::contact::penalty::{Penalty, Smooth};
use crate::contact::{Visitor, touch};
use crate::element::kinematics::Start;
use crate::element::lobatto::{self, Layer};
use crate::element::section::Law;
use crate::element::{Geometry, Node};
use crate::geometry::{Point, Profile};
use crate::material::flow::{Iterate, Response};
use crate::model::{Edge, Iteration, Model, Motion, Theory};
use crate::state::State;
use nalgebra::{Matrix3, Vector3};

/// Least tension of a membrane in its matrix, over its yield force \[–\]; it fades once the velocity norm is below [`SLACK_NORM`].
const SLACK_TENSION: f64 = 0.5;
const SLACK_NORM: f64 = 0.05;

/// A holder that has lost the sheet comes to rest on blocks of this height over the sheet thickness \[–\].
const DISTANCE_BLOCK: f64 = 0.5;

/// A tool as the solver uses it.
#[derive(Clone, Debug)]
pub(super) struct ActiveTool {
    profile: Profile,
    friction: f64,
    motion: Motion,
    /// Index among the shared unknowns, for a tool whose position is one.
    pub shared: Option<usize>,
    /// Travel at which the sheet left this tool's reach for good \[mm\]; it takes no part from then on.
    pub released: Option<f64>,
}

impl ActiveTool {
    /// Whether the tool takes part at all: a holder without force does not.
    fn is_absent(&self) -> bool {
        self.released.is_some() || (matches!(self.motion, Motion::Force(_)) && self.shared.is_none())
    }
}

/// One node against one tool at the end of the step under trial; forces are zero when it is out of reach.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Contact {
    /// Distance of the mid-surface from the tool \[mm\]; infinite until measured when far away.
    pub distance: f64,
    pub normal: f64,
    pub tangential: f64,
    pub slip: f64,
    /// Gap, pressure and slope of the last iteration, from which the carried pressure follows.
    gap: f64,
    pressure: Smooth,
}

/// Where a node was last measured against a tool, in the tool's frame, and how far away it was [mm].
#[derive(Clone, Copy, Debug)]
struct Far {
    position: Point,
    distance: f64,
}

/// Everything an iteration works on, allocated once for a run.
pub(super) struct Workspace {
    pub tools: Vec<ActiveTool>,
    pub layers: Vec<Layer>,
    /// Trial moves of the nodes in the step, the velocities times its duration, and where they lead.
    pub moves: Vec<Node>,
    pub nodes: Vec<Node>,
    /// Trial positions of the tools at the end of the step.
    pub tool_position: Vec<f64>,
    pub iterates: Vec<Iterate>,
    pub responses: Vec<Response>,
    pub thickness: Vec<f64>,
    pub membrane_increment: Vec<[f64; 2]>,
    pub system: System,
    /// Force of each tool on the sheet along z \[N, or N/mm\].
    pub tool_force: Vec<f64>,
    /// Residual of the equilibrium before boundary conditions: the reaction where a freedom is held.
    pub edge_reaction: Vector3<f64>,
    /// Every tool's contact with every node, tool by tool.
    pub contacts: Vec<Contact>,
    /// Where each pair was last measured.
    far: Vec<Far>,
    /// Their pressures carried from iteration to iteration \[MPa\].
    carried: Vec<f64>,
    pub penetration: f64,
    pub active_contacts: usize,
    /// Δε₀ of the step \[–\], raised by the factor `softening` ≥ 1 while a hard step looks for a start.
    pub cutoff: f64,
    pub softening: f64,
    /// Largest nodal residual over the largest internal or contact force of a node, and the node where it sits.
    pub residual_norm: f64,
    pub worst_node: usize,
    starts: Vec<Start>,
    thickness_rows: Vec<[f64; 6]>,
    areas: Vec<f64>,
    before: Vec<f64>,
    penalty: Penalty,
    block_area: f64,
}

impl Workspace {
    pub fn new(model: &Model, state: &State) -> Self {
        let mut shared = 0;
        let tools: Vec<ActiveTool> = model
            .tools
            .iter()
            .map(|tool| {
                let unknown = matches!(tool.motion, Motion::Force(force) if force > 0.0);
                let index = unknown.then_some(shared);
                shared += usize::from(unknown);
                ActiveTool {
                    profile: match model.settings.facets {
                        Some(n) if model.settings.round_facets => tool.profile.faceted(n).rounded(),
                        Some(n) => tool.profile.faceted(n),
                        None => tool.profile.clone(),
                    },
                    friction: tool.friction,
                    motion: tool.motion,
                    shared: index,
                    released: None,
                }
            })
            .collect();
        let (n, elements) = (state.nodes.len(), state.thickness.len());
        let t = model.blank.thickness;
        let points = state.layers.len();
        let contacts = tools
            .iter()
            .zip(&state.tools)
            .flat_map(|(tool, moved)| {
                state.nodes.iter().map(move |x| {
                    let distance = tool.profile.closest(Point::new(x[0], x[1] - moved)).distance;
                    Contact { distance, ..Contact::default() }
                })
            })
            .collect();
        let blank = Response { stress: [0.0; 3], tangent: [0.0; 6], increment: 0.0, yield_stress: 0.0 };
        Self {
            tool_position: state.tools.clone(),
            tool_force: vec![0.0; tools.len()],
            tools,
            layers: lobatto::rule(model.blank.layers),
            moves: vec![[0.0; 3]; n],
            nodes: state.nodes.clone(),
            iterates: vec![Iterate::default(); points],
            responses: vec![blank; points],
            thickness: state.thickness.clone(),
            membrane_increment: vec![[0.0; 2]; elements],
            system: System::new(n, shared),
            edge_reaction: Vector3::zeros(),
            far: vec![Far { position: Point::zeros(), distance: f64::NEG_INFINITY }; n * model.tools.len()],
            carried: vec![0.0; n * model.tools.len()],
            contacts,
            penetration: 0.0,
            active_contacts: 0,
            cutoff: 0.0,
            softening: 1.0,
            residual_norm: 0.0,
            worst_node: 0,
            starts: Vec::with_capacity(elements),
            thickness_rows: vec![[0.0; 6]; elements],
            areas: vec![0.0; n],
            before: vec![0.0; points],
            penalty: Penalty {
                stiffness: model.settings.contact_stiffness / t,
                smoothing: model.settings.contact_smoothing * t,
            },
            block_area: match model.geometry {
                Geometry::Axisymmetric => std::f64::consts::PI * model.blank.length * model.blank.length,
                Geometry::PlaneStrain => model.blank.length,
            },
        }
    }

    /// Takes the start of a step: reference lengths, areas, hardening.
    pub fn begin(&mut self, model: &Model, state: &State) {
        self.starts.clear();
        self.areas.fill(0.0);
        for (e, pair) in state.nodes.windows(2).enumerate() {
            let start = Start::new(model.geometry, model.blank.theory, pair[0], pair[1]);
            let [a, b] = start.tributary();
            self.areas[e] += a;
            self.areas[e + 1] += b;
            self.starts.push(start);
        }
        for (before, point) in self.before.iter_mut().zip(&state.layers) {
            *before = point.strain;
        }
    }

    /// Lifts a pressed tool off once the blank's edge has run out from under it: what is left to press on is a corner,
    /// from which the sheet would snap. Returns the contacts that end.
    pub fn release(&mut self, state: &State) -> Option<std::ops::Range<usize>> {
        let edge = state.nodes[state.nodes.len() - 1][0];
        let n = state.nodes.len();
        let lost = self.tools.iter_mut().enumerate().find(|(_, tool)| {
            let inner = tool.profile.pieces().iter().map(|p| p.first().x.min(p.last().x)).fold(f64::INFINITY, f64::min);
            !tool.is_absent() && tool.shared.is_some() && edge < inner
        });
        lost.map(|(j, tool)| {
            tool.released = Some(state.travel);
            j * n..(j + 1) * n
        })
    }

    /// Measures the distances that the iterations did not need; the balance of work does.
    pub fn measure_far(&mut self) {
        let n = self.nodes.len();
        for (pair, contact) in self.contacts.iter_mut().enumerate().filter(|(_, c)| c.distance.is_infinite()) {
            let (tool, x) = (pair / n, self.nodes[pair % n]);
            let position = Point::new(x[0], x[1] - self.tool_position[tool]);
            contact.distance = self.tools[tool].profile.closest(position).distance;
            self.far[pair] = Far { position, distance: contact.distance };
        }
    }

    /// Pressure of every tool on every node at the end of the step \[MPa\].
    pub fn pressures(&self) -> impl Iterator<Item = f64> {
        self.contacts.iter().map(|c| c.pressure.value)
    }

    /// Takes a predictor: trial positions after `dt` \[s\] at `velocity`, prescribed motions imposed, layers rewound.
    pub fn predict(&mut self, model: &Model, state: &State, dt: f64, from_rest: bool) {
        self.carried.copy_from_slice(&state.pressure);
        let share = if from_rest { 0.0 } else { dt };
        for (i, x) in self.moves.iter_mut().enumerate() {
            for d in 0..3 {
                x[d] = share * state.velocity[i][d];
            }
        }
        let last = self.moves.len() - 1;
        match model.blank.edge {
            Edge::Free => {}
            Edge::Clamped => self.moves[last] = [0.0; 3],
            Edge::Pulled { speed } => self.moves[last] = [speed * model.speed * dt, 0.0, 0.0],
        }
        self.moves[0][0] = 0.0;
        for (j, tool) in self.tools.iter().enumerate() {
            self.tool_position[j] = state.tools[j]
                + match tool.motion {
                    Motion::Fixed => 0.0,
                    Motion::Travel => dt * model.speed,
                    Motion::Force(_) => share * state.tool_velocity[j],
                };
        }
        for (iterate, point) in self.iterates.iter_mut().zip(&state.layers) {
            *iterate = Iterate::start(point.carried);
        }
    }

    /// Residual and matrix at the trial positions; `false` when an element has collapsed.
    ///
    /// `iteration` counts from 0, `velocity_norm` is the last one's. The system's right-hand side is −r, ready for δx = −H⁻¹ r.
    #[must_use]
    pub fn assemble(&mut self, model: &Model, state: &State, dt: f64, iteration: usize, velocity_norm: f64) -> bool {
        let settings = &model.settings;
        let matrix = settings.iteration;
        let longest = settings.max_step * model.travel / model.speed;
        self.cutoff = self.softening * settings.cutoff_strain * (dt / longest).min(1.0);
        let law = Law {
            hardening: &model.material.hardening,
            matrix,
            theory: model.blank.theory,
            layers: &self.layers,
            cutoff: self.cutoff,
            slack_tension: SLACK_TENSION * (velocity_norm / SLACK_NORM).min(1.0),
        };
        for (x, (start, u)) in self.nodes.iter_mut().zip(state.nodes.iter().zip(&self.moves)) {
            for d in 0..3 {
                x[d] = start[d] + u[d];
            }
        }
        let system = &mut self.system;
        system.clear();

        // Internal forces p and their matrix.
        let n_layers = self.layers.len();
        for (e, start) in self.starts.iter().enumerate() {
            let Some(end) = start.end(self.moves[e], self.moves[e + 1]) else { return false };
            let points = e * n_layers..(e + 1) * n_layers;
            let internal = law.internal(
                &end,
                state.volume[e],
                state.thickness[e],
                &self.before[points.clone()],
                &mut self.iterates[points.clone()],
                &mut self.responses[points],
            );
            system.diagonal[e] += internal.matrix[0][0];
            system.upper[e] += internal.matrix[0][1];
            system.lower[e + 1] += internal.matrix[1][0];
            system.diagonal[e + 1] += internal.matrix[1][1];
            system.rhs[e] -= internal.force.fixed_rows::<3>(0);
            system.rhs[e + 1] -= internal.force.fixed_rows::<3>(3);
            self.thickness[e] = internal.thickness;
            self.thickness_rows[e] = internal.thickness_row;
            self.membrane_increment[e] = [end.strain[0], end.strain[1]];
        }
        let largest_force = system.rhs.iter().map(|f| f.xy().norm()).fold(0.0, f64::max);

        let largest_force = largest_force.max(self.contact(model, state, dt, iteration));

        // Shared unknowns: a tool pressed by a force.
        for (j, tool) in self.tools.iter().enumerate() {
            let (Some(k), Motion::Force(force)) = (tool.shared, tool.motion) else { continue };
            if tool.released.is_some() {
                self.system.corner[(k, k)] = 1.0;
                continue;
            }
            let gap = (1.0 - DISTANCE_BLOCK) * model.blank.thickness - self.tool_position[j];
            if let Some(block) = self.penalty.at(gap) {
                self.system.corner_rhs[k] -= self.block_area * block.value;
                self.system.corner[(k, k)] -= self.block_area * block.slope;
            }
            self.system.corner_rhs[k] -= self.tool_force[j] - force;
        }

        self.constrain(model);
        let (worst, residual) = self
            .system
            .rhs
            .iter()
            .map(|f| f.xy().norm())
            .enumerate()
            .fold((0, 0.0), |worst, now| if now.1 > worst.1 { now } else { worst });
        self.worst_node = worst;
        self.residual_norm = if largest_force > 0.0 { residual / largest_force } else { f64::INFINITY };
        true
    }

    /// Contact and friction of every tool with every node it reaches; returns the largest force of one on one.
    fn contact(&mut self, model: &Model, state: &State, dt: f64, iteration: usize) -> f64 {
        let mut largest: f64 = 0.0;
        self.penetration = 0.0;
        self.active_contacts = 0;
        let last = self.nodes.len() - 1;
        let system = &mut self.system;
        for (j, tool) in self.tools.iter().enumerate() {
            self.tool_force[j] = 0.0;
            if tool.is_absent() {
                for i in 0..=last {
                    self.contacts[j * (last + 1) + i] = Contact { distance: f64::INFINITY, ..Contact::default() };
                }
                continue;
            }
            let friction = Coulomb { coefficient: tool.friction, slip: model.settings.slip_speed * model.speed * dt };
            let moved = self.tool_position[j] - state.tools[j];
            for i in 0..=last {
                let (before, after) = (i.max(1) - 1, i.min(last - 1));
                let thickness = 0.5 * (self.thickness[before] + self.thickness[after]);
                let x = &self.nodes[i];
                let position = Point::new(x[0], x[1] - self.tool_position[j]);
                let pair = j * (last + 1) + i;
                let contact = &mut self.contacts[pair];
                let carried = &mut self.carried[pair];
                // A distance changes no faster than the node moves: far away it need not be measured again.
                let far = &mut self.far[pair];
                let free = *carried == 0.0 && contact.pressure.slope == 0.0 && state.pressure[pair] == 0.0;
                if free && far.distance - (position - far.position).norm() > 0.5 * thickness + self.penalty.reach() {
                    *contact = Contact { distance: f64::INFINITY, ..Contact::default() };
                    continue;
                }
                let closest = tool.profile.closest(position);
                *far = Far { position, distance: closest.distance };
                let gap = closest.distance - 0.5 * thickness;
                if model.settings.iteration != Iteration::PrimalDual {
                    *carried = 0.0;
                } else if iteration > 0 {
                    *carried = (contact.pressure.value + contact.pressure.slope * (gap - contact.gap)).max(0.0);
                }
                let node = Visitor {
                    carried: *carried,
                    position,
                    relative: Point::new(self.moves[i][0], self.moves[i][1] - moved),
                    thickness,
                    area: self.areas[i],
                };
                *contact = Contact { distance: closest.distance, gap, ..Contact::default() };
                let Some(touch) = touch(&closest, &self.penalty, &friction, &node) else { continue };
                contact.normal = touch.normal;
                contact.tangential = touch.tangential;
                contact.slip = touch.slip;
                contact.pressure = touch.pressure;

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
                    let row = &self.thickness_rows[e];
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
                self.tool_force[j] += touch.force.y;
                self.penetration = self.penetration.max(-touch.gap / thickness);
                self.active_contacts += usize::from(touch.gap < 0.0);
            }
        }
        largest
    }

    /// Symmetry on the axis, the held edge, and no rotations in a membrane.
    fn constrain(&mut self, model: &Model) {
        let last = self.nodes.len() - 1;
        self.edge_reaction = -self.system.rhs[last];
        self.system.fix(0, 0);
        self.system.fix(0, 2);
        if model.blank.theory == Theory::Membrane {
            for i in 0..=last {
                self.system.fix(i, 2);
            }
        }
        if model.blank.edge != Edge::Free {
            for freedom in 0..3 {
                self.system.fix(last, freedom);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::hardening::Swift;
    use crate::material::{Hardening, Material};
    use crate::model::{Blank, Grading, Role, Settings, Tool};

    fn model(geometry: Geometry, theory: Theory) -> Model {
        let t = 1.0;
        let tool = |role, profile, motion| Tool { role, profile, friction: 0.12, motion };
        let holder = if geometry == Geometry::Axisymmetric { 9e3 } else { 60.0 };
        Model {
            title: "small cup".into(),
            notes: vec![],
            geometry,
            blank: Blank {
                length: 24.0,
                thickness: t,
                elements: 12,
                grading: Grading::Uniform,
                theory,
                layers: if theory == Theory::Membrane { 1 } else { 5 },
                edge: Edge::Free,
            },
            material: Material {
                hardening: Hardening::Swift(Swift::new(500.0, 0.2, 1e-3).expect("valid")),
                elastic: None,
            },
            tools: vec![
                tool(Role::Punch, Profile::flat_punch(12.0, 4.0, t), Motion::Travel),
                tool(Role::Die, Profile::die(13.3, 4.0, t), Motion::Fixed),
                tool(Role::Holder, Profile::holder(17.3, t), Motion::Force(holder)),
            ],
            travel: 6.0,
            speed: 1.0,
            frames: vec![6.0],
            settings: Settings { iteration: Iteration::Newton, ..Settings::default() },
        }
    }

    /// Trust: central differences of the whole residual, at a state in the middle of a draw that is disturbed off
    /// equilibrium: elements, contact, friction, thinning under contact and the holder's border all in one.
    #[test]
    fn matrix_is_the_derivative_of_the_residual() {
        for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
            for theory in [Theory::Bending, Theory::Membrane] {
                let mut formed = model(geometry, theory);
                formed.settings.iteration = Iteration::PrimalDual;
                let flat = State::flat(&formed, crate::mesh::nodes(&formed));
                let (run, state) = crate::solver::run_from(&formed, flat, &mut ());
                assert!(run.stop.is_complete(), "{}", run.stop);
                check(&model(geometry, theory), &state);
            }
        }
    }

    fn check(model: &Model, state: &State) {
        let dt = 0.05;
        let mut work = Workspace::new(model, state);
        work.begin(model, state);
        work.predict(model, state, dt, false);
        for (i, x) in work.moves.iter_mut().enumerate() {
            let wave = (i as f64 * 1.7).sin();
            x[0] += if i == 0 { 0.0 } else { 2e-4 * wave };
            x[1] += 2e-4 * (i as f64 * 2.3).cos();
            x[2] += if i == 0 || model.blank.theory == Theory::Membrane { 0.0 } else { 3e-4 * wave };
        }
        // A residual norm below SLACK_NORM's start would not matter here: Newton's H is the derivative only without
        // the membrane's floor, which fades with the velocity norm.
        let at = |work: &mut Workspace| {
            assert!(work.assemble(model, state, dt, 0, 0.0));
            (work.system.rhs.clone(), work.system.corner_rhs)
        };
        at(&mut work);
        let exact = work.system.clone();
        let n = work.nodes.len();
        let scale = |i: usize| exact.diagonal[i].norm();
        let h = 1e-8;
        for j in 0..n {
            for d in 0..3 {
                let held = (j == 0 && d != 1) || (d == 2 && model.blank.theory == Theory::Membrane);
                if held {
                    continue;
                }
                let x = work.moves[j][d];
                work.moves[j][d] = x + h;
                let (plus, plus_border) = at(&mut work);
                work.moves[j][d] = x - h;
                let (minus, minus_border) = at(&mut work);
                work.moves[j][d] = x;
                for i in 0..n {
                    let difference = -(plus[i] - minus[i]) / (2.0 * h);
                    let column = match i as isize - j as isize {
                        0 => exact.diagonal[i].column(d).into_owned(),
                        1 => exact.lower[i].column(d).into_owned(),
                        -1 => exact.upper[i].column(d).into_owned(),
                        _ => Vector3::zeros(),
                    };
                    for k in 0..3 {
                        if i == 0 && k != 1 {
                            continue;
                        }
                        let error = (difference[k] - column[k]).abs();
                        assert!(error < 2e-5 * scale(i), "node {i}.{k} by {j}.{d}: {} {}", difference[k], column[k]);
                    }
                }
                let border = -(plus_border[0] - minus_border[0]) / (2.0 * h);
                let row = exact.rows[j][0][d];
                assert!((border - row).abs() < 2e-5 * scale(n - 1), "holder by {j}.{d}: {border} {row}");
            }
        }
        let tool = 2;
        let z = work.tool_position[tool];
        work.tool_position[tool] = z + h;
        let (plus, plus_border) = at(&mut work);
        work.tool_position[tool] = z - h;
        let (minus, minus_border) = at(&mut work);
        for i in 1..n {
            let difference = -(plus[i] - minus[i]) / (2.0 * h);
            assert!((difference - exact.columns[i][0]).norm() < 2e-5 * scale(i), "node {i} by the holder");
        }
        let corner = -(plus_border[0] - minus_border[0]) / (2.0 * h);
        assert!((corner - exact.corner[(0, 0)]).abs() < 2e-5 * corner.abs().max(1.0), "{corner}");
    }
}
