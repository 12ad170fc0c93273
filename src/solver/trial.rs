//! The unknowns of an iteration, and what one iteration remembers for the next.

use super::line_search::LineSearch;
use super::process::Process;
use super::step::Step;
use crate::contact::penalty::ValueAndSlope;
use crate::element::Node;
use crate::geometry::{Nearest, Point};
use crate::material::elastoplastic::Trial as PointMemory;
use crate::material::flow::{Iterate, Triple};
use crate::model::{Edge, Mode, Motion, ReleaseStiffness, Theory};
use crate::numerics::Grid;
use crate::numerics::block_tridiagonal::System;
use crate::solver::state::State;

/// What a pair of tool and contact point remembers of its last evaluation.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactMemory {
    /// Where the point was last measured against the tool, in the tool's frame, and how far away it was \[mm\].
    pub position: Point,
    pub distance: f64,
    /// The piece of the tool that is closest to it.
    pub nearest: Nearest,
    /// Pressure carried from iteration to iteration \[MPa\].
    pub carried: f64,
    /// Gap \[mm\], pressure \[MPa\] and slope, from which the carried pressure follows.
    pub gap: f64,
    pub pressure: ValueAndSlope,
    /// The augmented Lagrangian's shift λ ≤ 0, and the gap in its last round \[mm\].
    pub shift: f64,
    pub round_gap: f64,
}

/// The unknowns at the end of a step, and what the iterations remember of each other. Allocated once for a run.
pub(super) struct Trial {
    /// Moves of the nodes in the step, the velocities times its duration.
    pub moves: Vec<Node>,
    /// Displacement of each tool (away from the axis, along z) from where it is drawn \[mm\].
    pub tools: Vec<Point>,
    /// Pressure of each gas \[MPa\].
    pub gas: Vec<f64>,
    /// Elements by thickness points: what the flow law remembers.
    pub iterates: Grid<Iterate>,
    /// What the elastoplastic law remembers in its place; the answers of a step are the first guesses of the next.
    pub elastoplastic: Grid<PointMemory>,
    /// Tools by contact points.
    pub contacts: Grid<ContactMemory>,
    /// Factor ≥ 1 on the cut-off while a hard step looks for a start \[–\].
    pub softening: f64,
    pub line: LineSearch,
    /// The stiffness that an unloading keeps through an increment.
    pub kept: Option<System>,
}

impl Trial {
    /// Room for the trials of a run that begins with `state`.
    pub fn new(process: &Process, state: &State) -> Self {
        let (model, n) = (process.model, state.nodes.len());
        let constant = model.release.is_some_and(|release| release.stiffness == ReleaseStiffness::Constant);
        let elastoplastic = if model.mode == Mode::Flow { 0 } else { state.thickness.len() };
        Self {
            moves: vec![[0.0; 3]; n],
            tools: state.tools.clone(),
            gas: state.gas.clone(),
            iterates: Grid::new(state.thickness.len(), process.rule.len(), Iterate::default()),
            elastoplastic: Grid::new(elastoplastic, process.rule.len(), PointMemory::default()),
            contacts: Grid::new(process.tools.len(), state.contact_points(), ContactMemory::default()),
            softening: 1.0,
            line: LineSearch::new(n),
            kept: constant.then(|| System::new(n, process.shared)),
        }
    }

    /// Takes a first guess of a step: moves at the velocities of the last step's end or from rest, prescribed motions imposed.
    pub fn predict(&mut self, step: &Step, from_rest: bool) {
        let Step { process, model, state, dt, .. } = *step;
        let pairs = state.pressure.iter().zip(state.shift.iter());
        for (memory, (pressure, shift)) in self.contacts.iter_mut().zip(pairs) {
            (memory.carried, memory.shift) = (*pressure, *shift);
        }
        for (pressure, (gas, before)) in self.gas.iter_mut().zip(model.gas.iter().zip(&state.gas)) {
            *pressure = gas.pressure.given(step.end()).unwrap_or(*before);
        }
        // A held strain rate has no meaning at rest.
        let holds_rate = process.holds_rate();
        let share = if from_rest && !holds_rate { 0.0 } else { step.speed_ratio * dt };
        for (u, velocity) in self.moves.iter_mut().zip(&state.end_velocity) {
            *u = velocity.map(|velocity| share * velocity);
        }
        if holds_rate && state.time == 0.0 {
            guess_dome(step, &mut self.moves);
        }
        let last = self.moves.len() - 1;
        match model.blank.edge {
            Edge::Free => {}
            Edge::Clamped => self.moves[last] = [0.0; 3],
            Edge::Pulled { speed } => self.moves[last] = [speed * model.speed * step.process_time, 0.0, 0.0],
        }
        self.moves[0][0] = 0.0;
        let progress = model.progress(step.end()) - model.progress(state.time);
        for (j, tool) in process.tools.iter().enumerate() {
            let moved = match tool.motion {
                Motion::Fixed | Motion::Gap(_) => Point::zeros(),
                Motion::Travel => Point::new(0.0, step.travel() - state.travel),
                Motion::Path(way) => way * progress,
                // What the sheet has left stands still.
                Motion::Pressed(_) if tool.released.is_some() => Point::zeros(),
                Motion::Pressed(_) => Point::new(0.0, share * state.tool_velocity[j]),
            };
            self.tools[j] = state.tools[j] + moved;
        }
        for (e, points) in state.points.rows().enumerate() {
            for (k, point) in points.iter().enumerate() {
                self.iterates[(e, k)] = Iterate::start(point.carried);
            }
        }
        self.average(step);
    }

    /// First iterates of membranes: the mean of their points', without the transverse shear, which they do not feel. Nodes
    /// that nothing turns wait for the end of the step.
    fn average(&mut self, step: &Step) {
        for e in step.membranes() {
            let mut carried = [0.0; 3];
            for (point, at) in step.state.points.row(e).iter().zip(&step.process.rule) {
                carried[0] += at.weight * point.carried[0];
                carried[1] += at.weight * point.carried[1];
            }
            self.iterates[(e, 0)] = Iterate::start(carried);
        }
        if step.model.blank.theory == Theory::Selective {
            for (u, _) in self.moves.iter_mut().zip(&step.rotates).filter(|(_, rotates)| !**rotates) {
                u[2] = 0.0;
            }
        }
    }

    /// Goes a share of the direction of the iteration.
    pub fn advance(&mut self, process: &Process, share: f64) {
        for (u, d) in self.moves.iter_mut().zip(&self.line.direction) {
            for k in 0..3 {
                u[k] += share * d[k];
            }
        }
        for (displacement, tool) in self.tools.iter_mut().zip(&process.tools) {
            if let Some(k) = tool.shared {
                displacement.y += share * self.line.shared[k];
            }
        }
        for (pressure, shared) in self.gas.iter_mut().zip(&process.gas_shared) {
            if let Some(k) = shared {
                *pressure += share * self.line.shared[*k];
            }
        }
    }

    /// Strain increment of thickness point `k` of element `e` in the last evaluation \[–\].
    pub fn strain(&self, e: usize, k: usize) -> Triple {
        if self.elastoplastic.is_empty() { self.iterates[(e, k)].strain() } else { self.elastoplastic[(e, k)].strain }
    }
}

/// A shallow dome that strains at about the rate that is held: where the first step starts from.
fn guess_dome(step: &Step, moves: &mut [Node]) {
    let Some((gas, control)) = step.model.held_gas() else { return };
    let a = gas.within.min(step.model.blank.length);
    let height = a * (control.target * step.dt).sqrt() * gas.face.sign();
    for (u, x) in moves.iter_mut().zip(&step.state.nodes) {
        let x = (x[0] / a).min(1.0);
        *u = [0.0, height * (1.0 - x * x), if x < 1.0 { -2.0 * height * x / a } else { 0.0 }];
    }
}
