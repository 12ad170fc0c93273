//! Equilibrium at the end of a step: the residual r = p − f and its matrix H (Sosnowski 1994, equations 7 to 9).

use super::attempt::Step;
use super::blocks;
use super::contacts::{ActiveTool, Contact, Far};
use super::line_search::LineSearch;
use super::loads::BeadPlace;
use super::selection::Selection;
use crate::contact::penalty::Penalty;
use crate::element::Node;
use crate::element::kinematics::Reference;
use crate::element::section::{self, Law};
use crate::geometry::Point;
use crate::material::elastoplastic::{Carried, ElastoplasticLaw, Operators, Trial as ElastoplasticTrial};
use crate::material::flow::{FlowLaw, Iterate, PointState, StressUpdate, Triple};
use crate::material::{PointLaw, chaboche};
use crate::model::{Edge, Iteration, Mode, Model, Motion, Pressure, PressureCap, ReleaseStiffness, Role, Settings};
use crate::numerics::block_tridiagonal::System;
use crate::numerics::lobatto::{self, ThicknessPoint};
use crate::state::{State, drawn};
use nalgebra::Vector3;
use std::mem::take;

/// Least tension of a membrane in its matrix, over its yield force \[–\]; it fades once the velocity norm is below [`SLACK_NORM`].
const SLACK_TENSION: f64 = 0.5;
const SLACK_NORM: f64 = 0.05;

/// A holder that neither sheet nor block holds, and a sheet that tools going back leave free, are kept in place by this
/// share of a block's stiffness \[–\]: a force of millionths of those that form the sheet.
const ANCHOR: f64 = 1e-7;

/// Where the corrector stands when it asks for residual and matrix.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial {
    pub matrix: Iteration,
    /// Counts from 0.
    pub iteration: usize,
    /// Of the last iteration \[–\].
    pub velocity_norm: f64,
}

/// Everything an iteration works on, allocated once for a run.
pub(super) struct Workspace {
    pub tools: Vec<ActiveTool>,
    pub layers: Vec<ThicknessPoint>,
    /// Trial moves of the nodes in the step, the velocities times its duration, and where they lead.
    pub moves: Vec<Node>,
    pub nodes: Vec<Node>,
    /// Trial positions of the tools at the end of the step, along z and away from the axis.
    pub tool_position: Vec<f64>,
    pub tool_aside: Vec<f64>,
    pub iterates: Vec<Iterate>,
    /// What the twin keeps instead of an iterate; a step's first guesses are the last one's answers.
    pub twins: Vec<ElastoplasticTrial>,
    pub responses: Vec<StressUpdate>,
    pub thickness: Vec<f64>,
    /// Volume of each element that the step reckons with \[mm³, or mm² in plane strain\], and its growth in the step.
    pub volume: Vec<f64>,
    pub(super) growth: Vec<f64>,
    pub membrane_increment: Vec<[f64; 2]>,
    pub system: System,
    pub line: LineSearch,
    /// The stiffness that an unloading keeps through an increment.
    pub kept: Option<System>,
    /// Force of each tool on the sheet along z, and away from the axis \[N, or N/mm\].
    pub tool_force: Vec<f64>,
    pub tool_force_aside: Vec<f64>,
    /// Residual of the equilibrium before boundary conditions: the reaction where a freedom is held.
    pub edge_reaction: Vector3<f64>,
    /// Every tool's contact with every node, tool by tool.
    pub contacts: Vec<Contact>,
    /// Where each pair was last measured.
    pub(super) far: Vec<Far>,
    /// Their pressures carried from iteration to iteration \[MPa\].
    pub(super) carried: Vec<f64>,
    /// The augmented Lagrangian's shift λ ≤ 0 of every pair \[mm\].
    pub shift: Vec<f64>,
    /// Their gaps in the last round \[mm\].
    pub(super) last_gap: Vec<f64>,
    pub active_contacts: usize,
    /// Where the model's beads hold the sheet in this step.
    pub(super) beads: Vec<Option<BeadPlace>>,
    /// Trial pressure of each gas \[MPa\], and its index among the shared unknowns where it is one.
    pub gas_pressure: Vec<f64>,
    pub(super) gas_shared: Vec<Option<usize>>,
    /// Norm of the strain rate that a pressure holds, over its target \[–\].
    pub(super) held_norm: f64,
    /// The cap that this pressure sits on, and by what share it misses or exceeds it \[–\].
    pub(super) on_cap: Option<PressureCap>,
    pub(super) beyond_cap: f64,
    /// Rows of the membrane strains Δε_s, Δε_θ by r, z of both nodes, of every element.
    pub(super) membrane_rows: Vec<[[f64; 4]; 2]>,
    /// Force of the gas on every node \[N, or N/mm\].
    pub gas_force: Vec<Point>,
    /// Δε₀ of the step \[–\], raised by the factor `softening` ≥ 1 while a hard step looks for a start.
    pub cutoff: f64,
    pub softening: f64,
    /// Largest nodal residual over the largest internal or contact force of a node, and the node where it sits.
    pub residual_norm: f64,
    pub worst_node: usize,
    pub(super) starts: Vec<Reference>,
    pub(super) selection: Selection,
    pub(super) thickness_rows: Vec<[f64; 6]>,
    pub(super) areas: Vec<f64>,
    /// Shear yield stress at the nodes at the start of the step \[MPa\]; zero when no friction law asks for it.
    pub(super) shear_yield: Vec<f64>,
    pub(super) before: Vec<PointState>,
    /// The layers as the twin finds them.
    pub(super) carried_points: Vec<Carried>,
    /// Forces that held the sheet before its tools were taken away \[N, N mm\]; they fade.
    pub(super) held: Vec<Vector3<f64>>,
    pub(super) penalty: Penalty,
    block_area: f64,
    /// Move of the holder at which it stands on its distance blocks \[mm\], relative to the die; none without a holder.
    block: Option<f64>,
    /// What of its force they bear \[N, or N/mm\].
    pub(super) block_force: f64,
}

impl Workspace {
    pub fn new(model: &Model, state: &State) -> Self {
        let mut shared = 0;
        let tools: Vec<ActiveTool> = model
            .tools
            .iter()
            .map(|tool| {
                let unknown = matches!(&tool.motion, Motion::Pressed(press) if !press.is_idle());
                let index = unknown.then_some(shared);
                shared += usize::from(unknown);
                ActiveTool {
                    profile: match model.settings.facets {
                        Some(n) if model.settings.round_facets => tool.profile.faceted(n).rounded(),
                        Some(n) => tool.profile.faceted(n),
                        None => tool.profile.clone(),
                    },
                    friction: tool.friction,
                    motion: tool.motion.clone(),
                    role: tool.role,
                    shared: index,
                    released: model.release.map(|_| 0.0),
                }
            })
            .collect();
        let (n, elements) = (state.nodes.len(), state.thickness.len());
        let gas_shared: Vec<Option<usize>> = model
            .gas
            .iter()
            .map(|gas| {
                let unknown = matches!(gas.pressure, Pressure::Rate(_));
                let index = unknown.then_some(shared);
                shared += usize::from(unknown);
                index
            })
            .collect();
        let holds_rate = gas_shared.iter().any(Option::is_some);
        let t = model.blank.thickness;
        let points = state.layers.len();
        let blank = StressUpdate { stress: [0.0; 3], tangent: [0.0; 6], increment: 0.0, yield_stress: 0.0 };
        let pairs = n * tools.len();
        let mut work = Self {
            tool_position: state.tools.clone(),
            tool_aside: state.aside.clone(),
            tool_force: vec![0.0; tools.len()],
            tool_force_aside: vec![0.0; tools.len()],
            tools,
            layers: lobatto::rule(model.blank.layers),
            moves: vec![[0.0; 3]; n],
            nodes: state.nodes.clone(),
            iterates: vec![Iterate::default(); points],
            twins: vec![ElastoplasticTrial::default(); if model.mode == Mode::Flow { 0 } else { points }],
            responses: vec![blank; points],
            thickness: state.thickness.clone(),
            volume: state.volume.clone(),
            growth: vec![1.0; elements],
            membrane_increment: vec![[0.0; 2]; elements],
            system: System::new(n, shared),
            line: LineSearch::new(n),
            kept: model
                .release
                .filter(|release| release.stiffness == ReleaseStiffness::Constant)
                .map(|_| System::new(n, shared)),
            edge_reaction: Vector3::zeros(),
            far: vec![Far::default(); pairs],
            carried: vec![0.0; pairs],
            contacts: vec![Contact::free(f64::INFINITY); pairs],
            shift: vec![0.0; pairs],
            last_gap: vec![0.0; pairs],
            active_contacts: 0,
            beads: vec![None; model.beads.len()],
            gas_force: vec![Point::zeros(); n],
            gas_pressure: state.gas.clone(),
            gas_shared,
            held_norm: 0.0,
            on_cap: None,
            beyond_cap: 0.0,
            membrane_rows: vec![[[0.0; 4]; 2]; if holds_rate { elements } else { 0 }],
            cutoff: 0.0,
            softening: 1.0,
            residual_norm: 0.0,
            worst_node: 0,
            starts: Vec::with_capacity(elements),
            selection: Selection::new(model, elements),
            thickness_rows: vec![[0.0; 6]; elements],
            areas: vec![0.0; n],
            shear_yield: vec![0.0; n],
            before: vec![PointState::at(0.0); points],
            carried_points: vec![Carried::default(); if model.mode == Mode::Flow { 0 } else { points }],
            held: vec![Vector3::zeros(); if model.release.is_some() { n } else { 0 }],
            penalty: Penalty {
                stiffness: model.settings.contact_stiffness / t,
                smoothing: model.settings.contact_smoothing * t,
            },
            block_area: model.geometry.area(model.blank.length),
            block: blocks::of_holder(model),
            block_force: 0.0,
        };
        work.measure_far();
        work.hold(model, state);
        work
    }

    /// What the stress in the sheet asks for to be in equilibrium: the forces of the tools, before they are taken away.
    fn hold(&mut self, model: &Model, state: &State) {
        let layers = self.layers.len();
        if self.held.is_empty() {
            return;
        }
        for (e, pair) in state.nodes.windows(2).enumerate() {
            let theory = model.blank.theory.of_element(state.bends[e]);
            let start = Reference::new(model.geometry, theory, pair[0], pair[1]);
            let Some(end) = start.end([0.0; 3], [0.0; 3]) else { continue };
            let points = &state.layers[e * layers..(e + 1) * layers];
            let force = section::forces(&end, state.volume[e], state.thickness[e], &self.layers, |i| points[i].stress);
            self.held[e] += force.fixed_rows::<3>(0);
            self.held[e + 1] += force.fixed_rows::<3>(3);
        }
    }

    /// Strain increment of a layer point in the last assembly \[–\].
    pub fn strain_of(&self, i: usize) -> Triple {
        self.twins.get(i).map_or_else(|| self.iterates[i].strain(), |trial| trial.strain)
    }

    /// Takes the start of a step: which elements bend, reference lengths, areas, hardening.
    pub fn begin(&mut self, step: &Step) {
        let Step { model, state, dt, .. } = *step;
        self.selection.choose(model, state);
        self.starts.clear();
        self.areas.fill(0.0);
        for (e, pair) in state.nodes.windows(2).enumerate() {
            let theory = model.blank.theory.of_element(self.selection.bends[e]);
            let start = Reference::new(model.geometry, theory, pair[0], pair[1]);
            let [a, b] = start.tributary();
            self.areas[e] += a;
            self.areas[e + 1] += b;
            self.starts.push(start);
        }
        let layers = self.layers.len();
        for (i, (before, point)) in self.before.iter_mut().zip(&state.layers).enumerate() {
            *before = PointState { strain: point.strain, porosity: 0.0, temperature: state.temperature[i / layers] };
        }
        if model.mode != Mode::Flow {
            let law = twin(model, Iteration::Newton, dt);
            for (i, (carried, point)) in self.carried_points.iter_mut().zip(&state.layers).enumerate() {
                let (strain, temperature) = (point.strain, state.temperature[i / layers]);
                *carried = Carried { strain, temperature, yield_stress: 0.0, stress: point.stress, back: point.back };
                carried.yield_stress = law.yield_stress(carried);
            }
        }
        if let Some(voids) = &model.material.voids {
            self.foresee_voids(voids, state, dt);
        }
        self.average_strains();
        self.place_beads(model, state);
        if self.tools.iter().any(|tool| tool.friction.needs_shear_yield()) {
            self.find_shear_yield(model, state);
        }
    }

    /// k = σ_y/√3 at the mean strain through the thickness of the elements around each node.
    fn find_shear_yield(&mut self, model: &Model, state: &State) {
        self.shear_yield.fill(0.0);
        let (layers, last) = (self.layers.len(), self.thickness.len() - 1);
        for e in 0..=last {
            let points = &state.layers[e * layers..(e + 1) * layers];
            let strain: f64 = points.iter().zip(&self.layers).map(|(p, l)| l.weight * p.strain).sum();
            let k = model.material.yield_stress(strain, state.temperature[e]) / 3f64.sqrt();
            self.shear_yield[e] += if e == 0 { k } else { 0.5 * k };
            self.shear_yield[e + 1] += if e == last { k } else { 0.5 * k };
        }
    }

    /// Shares of an element's area at the start of the step that belong to its two nodes \[mm², or mm per mm of depth\].
    pub(super) fn tributary(&self, e: usize) -> [f64; 2] {
        self.starts[e].tributary()
    }

    /// Takes a predictor: trial positions at the last velocities, prescribed motions imposed, layers rewound.
    pub fn predict(&mut self, step: &Step, from_rest: bool) {
        let Step { model, state, dt, .. } = *step;
        self.carried.copy_from_slice(&state.pressure);
        self.shift.copy_from_slice(&state.shift);
        self.gas_pressure.copy_from_slice(&state.gas);
        // A held strain rate has no meaning at rest.
        let holds_rate = !self.membrane_rows.is_empty();
        // The velocities of the last step, in proportion to the punch's where that has changed.
        let before = model.schedule.as_ref().map_or(0.0, |schedule| schedule.slope_before(state.time));
        let faster = if before > 0.0 { (model.travel_at(state.time + dt) - state.travel) / (before * dt) } else { 1.0 };
        let share = if from_rest && !holds_rate { 0.0 } else { faster * dt };
        for (i, x) in self.moves.iter_mut().enumerate() {
            for d in 0..3 {
                x[d] = share * state.velocity[i][d];
            }
        }
        if holds_rate && state.time == 0.0 {
            self.guess_dome(step);
        }
        let last = self.moves.len() - 1;
        match model.blank.edge {
            Edge::Free => {}
            Edge::Clamped => self.moves[last] = [0.0; 3],
            Edge::Pulled { speed } => {
                self.moves[last] = [speed * model.speed * model.nominal(state.time, dt), 0.0, 0.0]
            }
        }
        self.moves[0][0] = 0.0;
        let progress = model.progress(state.time + dt) - model.progress(state.time);
        for (j, tool) in self.tools.iter().enumerate() {
            let (axial, aside) = match tool.motion {
                Motion::Fixed | Motion::Gap(_) => (0.0, 0.0),
                Motion::Travel => (model.travel_at(state.time + dt) - state.travel, 0.0),
                Motion::Path { axial, aside } => (axial * progress, aside * progress),
                // What the sheet has left stands still.
                Motion::Pressed(_) if tool.released.is_some() => (0.0, 0.0),
                Motion::Pressed(_) => (share * state.tool_velocity[j], 0.0),
            };
            self.tool_position[j] = state.tools[j] + axial;
            self.tool_aside[j] = state.aside[j] + aside;
        }
        for (iterate, point) in self.iterates.iter_mut().zip(&state.layers) {
            *iterate = Iterate::start(point.carried);
        }
        self.average_iterates(model, state);
    }

    /// Moves the trial along the direction of the iteration by a share of it.
    pub fn advance(&mut self, share: f64) {
        for (u, d) in self.moves.iter_mut().zip(&self.line.direction) {
            for k in 0..3 {
                u[k] += share * d[k];
            }
        }
        for (position, tool) in self.tool_position.iter_mut().zip(&self.tools) {
            if let Some(k) = tool.shared {
                *position += share * self.line.shared[k];
            }
        }
        for (pressure, shared) in self.gas_pressure.iter_mut().zip(&self.gas_shared) {
            if let Some(k) = shared {
                *pressure += share * self.line.shared[*k];
            }
        }
    }

    /// Residual and matrix at the trial positions; `false` when an element has collapsed.
    ///
    /// The system's right-hand side is −r, ready for δx = −H⁻¹ r.
    #[must_use]
    pub fn assemble(&mut self, step: &Step, trial: &Trial) -> bool {
        let Step { model, state, dt, .. } = *step;
        let Trial { matrix, velocity_norm, .. } = *trial;
        let settings = &model.settings;
        let share = model.nominal(state.time, dt) / (Settings::CUTOFF_STEP * model.duration);
        self.cutoff = self.softening * settings.cutoff_strain * share;
        let material = &model.material;
        for (x, (start, u)) in self.nodes.iter_mut().zip(state.nodes.iter().zip(&self.moves)) {
            for d in 0..3 {
                x[d] = start[d] + u[d];
            }
        }
        self.system.clear();

        // Internal forces p and their matrix.
        let sound = if model.mode == Mode::Flow {
            let law = FlowLaw {
                hardening: &material.hardening,
                rate: material.rate.as_ref(),
                softening: material.softening.as_ref(),
                anisotropy: material.anisotropy,
                voids: material.voids.as_ref(),
                matrix,
                cutoff: self.cutoff,
                duration: dt,
            };
            // Taken out and put back: nothing is allocated.
            let (before, mut iterates) = (take(&mut self.before), take(&mut self.iterates));
            let sound = self.strain_sheet(law, &before, &mut iterates, state, velocity_norm);
            (self.before, self.iterates) = (before, iterates);
            sound
        } else {
            let law = twin(model, matrix, dt);
            let (before, mut twins) = (take(&mut self.carried_points), take(&mut self.twins));
            let sound = self.strain_sheet(law, &before, &mut twins, state, velocity_norm);
            (self.carried_points, self.twins) = (before, twins);
            sound
        };
        if !sound {
            return false;
        }
        let largest = |forces: &[Vector3<f64>]| forces.iter().map(|f| f.xy().norm()).fold(0.0, f64::max);
        let internal = largest(&self.system.rhs);
        let contact = self.contact(step, trial);
        self.restrain(model, state, dt);
        self.anchor(model);
        self.inflate(model, state, state.time + dt);
        let gas = self.gas_force.iter().map(|f| f.norm()).fold(0.0, f64::max);
        let left = 1.0 - (state.time + dt) / model.duration;
        let mut held: f64 = 0.0;
        for (rhs, force) in self.system.rhs.iter_mut().zip(&self.held) {
            *rhs += force * left;
            held = held.max(force.xy().norm());
        }
        let largest_force = internal.max(contact).max(gas).max(held);

        if let Some(kept) = &mut self.kept {
            if trial.iteration == 0 { kept.take_matrix(&self.system) } else { self.system.take_matrix(kept) }
        }
        self.hold_rate(model, state, dt);
        self.press(model, state, dt);
        self.constrain(model);
        let (worst, residual) = self
            .system
            .rhs
            .iter()
            .map(|f| f.xy().norm())
            .enumerate()
            .fold((0, 0.0), |worst, now| if now.1 > worst.1 { now } else { worst });
        self.worst_node = worst;
        self.residual_norm = match largest_force > 0.0 {
            true => residual / largest_force,
            // A sheet that all tools have left is at rest; one that none has reached yet says nothing.
            false if model.has_paths() => 0.0,
            false => f64::INFINITY,
        };
        true
    }

    /// Strains every element to the trial positions by a law: internal forces, matrix and thickness; `false` when one has
    /// collapsed.
    fn strain_sheet<L: PointLaw>(
        &mut self,
        point: L,
        before: &[L::PointState],
        iterates: &mut [L::Iterate],
        state: &State,
        velocity_norm: f64,
    ) -> bool {
        let law =
            Law { point, layers: &self.layers, slack_tension: SLACK_TENSION * (velocity_norm / SLACK_NORM).min(1.0) };
        let system = &mut self.system;
        let n_layers = self.layers.len();
        for (e, start) in self.starts.iter().enumerate() {
            let Some(end) = start.end(self.moves[e], self.moves[e + 1]) else { return false };
            let points = e * n_layers..(e + 1) * n_layers;
            let internal = law.internal(
                &end,
                self.volume[e],
                state.thickness[e],
                &before[points.clone()],
                &mut iterates[points.clone()],
                &mut self.responses[points],
            );
            system.diagonal[e] += internal.matrix[0][0];
            system.upper[e] += internal.matrix[0][1];
            system.lower[e + 1] += internal.matrix[1][0];
            system.diagonal[e + 1] += internal.matrix[1][1];
            system.rhs[e] -= internal.force.fixed_rows::<3>(0);
            system.rhs[e + 1] -= internal.force.fixed_rows::<3>(3);
            self.thickness[e] = internal.thickness * self.growth[e];
            self.thickness_rows[e] = internal.thickness_row.map(|by| by * self.growth[e]);
            self.membrane_increment[e] = [end.strain[0], end.strain[1]];
            if let Some(rows) = self.membrane_rows.get_mut(e) {
                *rows = end.membrane_rows();
            }
        }
        true
    }

    /// Shared unknowns: tools pressed by a force.
    fn press(&mut self, model: &Model, state: &State, dt: f64) {
        let closing = self.closing_force(model);
        // The blocks stand on the die and go with it.
        let die = model.tools.iter().position(|tool| tool.role == Role::Die);
        let die = die.map_or(0.0, |j| self.tool_position[j] - drawn(model, &model.tools[j]));
        for (j, tool) in self.tools.iter().enumerate() {
            let (Some(k), Motion::Pressed(press)) = (tool.shared, &tool.motion) else { continue };
            if tool.released.is_some() {
                self.block_force = 0.0;
                self.system.corner[(k, k)] = 1.0;
                continue;
            }
            let moved = self.tool_position[j];
            let mut force = press.force.at(model.travel_at(state.time + dt)) - press.stiffness * moved;
            if tool.role == Role::Holder {
                force -= closing;
            }
            self.system.corner[(k, k)] += press.stiffness;
            let block = self.block.and_then(|height| self.penalty.at(height + die - moved));
            self.block_force = block.map_or(0.0, |block| self.block_area * block.value);
            if let Some(block) = block {
                self.system.corner_rhs[k] -= self.block_area * block.value;
                self.system.corner[(k, k)] -= self.block_area * block.slope;
            }
            let anchor = ANCHOR * self.block_area * self.penalty.stiffness;
            self.system.corner_rhs[k] -= anchor * (moved - state.tools[j]);
            self.system.corner[(k, k)] += anchor;
            self.system.corner_rhs[k] -= self.tool_force[j] - force;
        }
    }

    /// Keeps a sheet from floating along z once the tools that go away have left it.
    fn anchor(&mut self, model: &Model) {
        if !model.has_paths() {
            return;
        }
        for (i, area) in self.areas.iter().enumerate() {
            let stiffness = ANCHOR * self.penalty.stiffness * area;
            self.system.rhs[i].y -= stiffness * self.moves[i][1];
            self.system.diagonal[i][(1, 1)] += stiffness;
        }
    }

    /// Symmetry on the axis, the held edge, and no rotations where no element resists them.
    fn constrain(&mut self, model: &Model) {
        let last = self.nodes.len() - 1;
        self.edge_reaction = -self.system.rhs[last];
        self.system.fix(0, 0);
        self.system.fix(0, 2);
        for i in 0..=last {
            if !self.selection.rotates[i] {
                self.system.fix(i, 2);
            }
        }
        if model.release.is_some() && model.blank.edge == Edge::Free {
            // Nothing else holds the sheet up; what fades is in balance, so that this bears nothing.
            self.system.fix(0, 1);
        }
        if model.blank.edge != Edge::Free {
            for freedom in 0..3 {
                self.system.fix(last, freedom);
            }
        }
    }
}

/// The twin's law in a step.
fn twin(model: &Model, matrix: Iteration, duration: f64) -> ElastoplasticLaw<'_> {
    let material = &model.material;
    ElastoplasticLaw {
        hardening: (model.mode == Mode::ElastoViscoplastic).then_some(&material.hardening),
        operators: Operators::new(material.elastic.expect("checked where the model is made"), material.anisotropy),
        kinematic: chaboche::shifting(material.kinematic),
        rate: material.rate.as_ref(),
        softening: material.softening.as_ref(),
        secant: matrix == Iteration::Secant,
        duration,
    }
}

#[cfg(test)]
mod tests;
