//! Unknowns of a step, and memory between its iterations.

use super::{line_search::LineSearch, *};
use crate::geometry::Nearest;
use crate::material::{elastoplastic::Trial as PointMemory, flow::Iterate};
use crate::model::ReleaseStiffness;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactMemory {
    /// Last measured position in the tool's frame, and its distance \[mm\].
    pub position: Point,
    pub distance: f64,
    pub nearest: Nearest,
    /// Carried pressure \[MPa\].
    pub carried: f64,
    /// Last gap \[mm\], pressure \[MPa\] and slope.
    pub gap: f64,
    pub pressure: ValueAndSlope,
    /// Shift λ ≤ 0 of the augmented Lagrangian, and the gap in its last round \[mm\].
    pub shift: f64,
    pub round_gap: f64,
}

pub(super) struct Trial {
    /// Moves of the nodes in the step \[mm, rad\].
    pub moves: Vec<Node>,
    /// Displacement of each tool (away from the axis, along z) from where it is drawn \[mm\].
    pub tools: Vec<Point>,
    /// Pressure of each gas \[MPa\].
    pub gas: Vec<f64>,
    /// Elements by thickness points: what the flow law remembers.
    pub iterates: Grid<Iterate>,
    /// Iterates of the elastoplastic law; those of a step are the first guesses of the next.
    pub elastoplastic: Grid<PointMemory>,
    /// Tools by contact points.
    pub contacts: Grid<ContactMemory>,
    /// Factor ≥ 1 on the cut-off in softened starts \[–\].
    pub softening: f64,
    pub line: LineSearch,
    /// Constant stiffness of an unloading increment.
    pub kept: Option<System>,
}

impl Trial {
    pub fn new(context: &RunContext, state: &State) -> Self {
        let (model, n) = (context.model, state.nodes.len());
        let (elements, layers) = (state.thickness.len(), context.rule.len());
        let kept = (model.release == Some(ReleaseStiffness::Constant)).then(|| System::new(n, context.shared));
        let iterates = Grid::new(elements, layers, Iterate::default());
        let elastoplastic = if model.mode == Mode::Flow { 0 } else { elements };
        let elastoplastic = Grid::new(elastoplastic, layers, PointMemory::default());
        let contacts = Grid::new(context.tools.len(), state.contact_points(), ContactMemory::default());
        let (moves, tools, gas, line) = (vec![[0.0; 3]; n], state.tools.clone(), state.gas.clone(), LineSearch::new(n));
        Self { moves, tools, gas, iterates, elastoplastic, contacts, softening: 1.0, line, kept }
    }

    /// Predicts a step: extrapolated velocities or rest, with prescribed motions.
    pub fn predict(&mut self, step: &Step, from_rest: bool) {
        let Step { context, model, state, dt, .. } = *step;
        for (memory, (pressure, shift)) in self.contacts.iter_mut().zip(state.pressure.iter().zip(state.shift.iter())) {
            (memory.carried, memory.shift) = (*pressure, *shift);
        }
        for (pressure, (gas, before)) in self.gas.iter_mut().zip(model.gas.iter().zip(&state.gas)) {
            *pressure = gas.pressure.prescribed(step.end()).unwrap_or(*before);
        }
        // A held strain rate has no meaning at rest.
        let holds_rate = context.holds_rate();
        let share = if from_rest && !holds_rate { 0.0 } else { step.speed_ratio * dt };
        for (u, velocity) in self.moves.iter_mut().zip(&state.end_velocity) {
            *u = velocity.map(|velocity| share * velocity);
        }
        if holds_rate && state.time == 0.0 {
            guess_dome(step, &mut self.moves);
        }
        for (i, edge) in model.held_edges(self.moves.len()) {
            let held = edge.held(model.speed * step.process_time, step.travel() - state.travel);
            held.into_iter().enumerate().for_each(|(d, held)| self.moves[i][d] = held.unwrap_or(self.moves[i][d]));
        }
        for (j, tool) in context.tools.iter().enumerate() {
            let to = |travel: f64| tool.motion.displacement(travel, model.travel);
            let moved = match tool.motion {
                Motion::Path(way) => way * (model.progress(step.end()) - model.progress(state.time)),
                // What the sheet has left stands still.
                Motion::Pressed(_) if tool.released.is_none() => Point::new(0.0, share * state.tool_velocity[j]),
                _ => to(step.travel()) - to(state.travel),
            };
            self.tools[j] = state.tools[j] + moved;
        }
        for (iterate, point) in self.iterates.iter_mut().zip(state.points.iter()) {
            *iterate = Iterate::start(point.carried);
        }
    }

    pub fn advance(&mut self, context: &RunContext, share: f64) {
        for (u, d) in self.moves.iter_mut().zip(&self.line.direction) {
            *u = [0, 1, 2].map(|k| u[k] + share * d[k]);
        }
        for (displacement, tool) in self.tools.iter_mut().zip(&context.tools) {
            if let Some(k) = tool.shared {
                displacement.y += share * self.line.shared[k];
            }
        }
        for (pressure, shared) in self.gas.iter_mut().zip(&context.gas_shared) {
            if let Some(k) = shared {
                *pressure += share * self.line.shared[*k];
            }
        }
    }

    /// Strain increment of thickness point `k` of element `e` in the last evaluation \[–\].
    pub fn strain(&self, e: usize, k: usize) -> Triple {
        if self.elastoplastic.is_empty() { self.iterates[(e, k)].strain } else { self.elastoplastic[(e, k)].strain }
    }
}

fn guess_dome(step: &Step, moves: &mut [Node]) {
    let Some((gas, control)) = step.model.held_gas() else { return };
    let a = gas.within.min(step.model.blank.length);
    if step.model.blank.meridian.is_some() {
        let grown = control.target * step.dt * gas.face.sign();
        return moves.iter_mut().zip(&step.state.nodes).for_each(|(u, x)| *u = [grown * x[0], 0.0, 0.0]);
    }
    let height = a * (control.target * step.dt).sqrt() * gas.face.sign();
    for (u, x) in moves.iter_mut().zip(&step.state.nodes) {
        let x = (x[0] / a).min(1.0);
        *u = [0.0, height * (1.0 - x * x), if x < 1.0 { -2.0 * height * x / a } else { 0.0 }];
    }
}
