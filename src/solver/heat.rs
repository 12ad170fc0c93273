//! Temperature of the sheet over a step, after its equilibrium.
//!
//! ```text
//! ρ c V (T′ − T) = β W + Δt Σ h A (T_tool − T′) + Δt Σ (k S/l) (T′_next − T′)
//! ```
//!
//! with an element's plastic work W, the area A that a tool touches, and the section S and distance l towards its
//! neighbours: backward Euler on finite volumes. The temperature is uniform through the thickness. The equilibrium of a step
//! uses the extrapolated temperature, at the smaller of the last two rates where they agree in sign.
//!
//! # References
//! β: G. I. Taylor, H. Quinney, Proc. R. Soc. London A 143 (1934) 307–326 (not read).

use super::converged::Converged;
use crate::element::surface::STATIONS;
use crate::model::{Geometry, HeatFlow, Model, ToolHeat};
use crate::solver::solution::Heat;
use crate::solver::state::State;
use std::f64::consts::TAU;

/// Tridiagonal system of the elements' temperatures.
pub(super) struct HeatSolver<'a> {
    flow: &'a HeatFlow,
    geometry: Geometry,
    tools: Vec<(usize, ToolHeat)>,
    diagonal: Vec<f64>,
    /// Coupling to the next element.
    off: Vec<f64>,
    rhs: Vec<f64>,
    /// Δt Σ h A \[mJ/K\] and Δt Σ h A T_tool \[mJ\] of every element.
    exchange: Vec<[f64; 2]>,
}

impl<'a> HeatSolver<'a> {
    /// Creates the solver; `None` at constant temperature.
    pub fn new(model: &'a Model, state: &State) -> Option<Self> {
        let flow = model.heat.as_ref()?.flow.as_ref()?;
        let tools = flow.tools.iter().filter_map(|tool| Some((model.tool_index(tool.role)?, *tool))).collect();
        let n = state.thickness.len();
        Some(Self {
            flow,
            geometry: model.geometry,
            tools,
            diagonal: vec![0.0; n],
            off: vec![0.0; n],
            rhs: vec![0.0; n],
            exchange: vec![[0.0; 2]; n],
        })
    }

    /// Advances the temperatures of `state`; `plastic` is the plastic work of each element.
    pub fn advance(&mut self, converged: &Converged, plastic: &[f64], state: &mut State) -> Heat {
        let n = plastic.len();
        let dt = converged.step.dt;
        self.meet_tools(converged);
        for e in 0..n {
            let stored = self.flow.capacity * state.volume[e];
            let [by_tools, heat] = self.exchange[e];
            self.diagonal[e] = stored + by_tools;
            self.rhs[e] = stored * state.temperature[e] + self.flow.plastic_share * plastic[e] + heat;
            self.off[e] = 0.0;
        }
        if self.flow.conductivity > 0.0 {
            for e in 1..n {
                let [before, after] = [state.along(e - 1), state.along(e)];
                let distance = 0.5 * (before.x.hypot(before.y) + after.x.hypot(after.y));
                let width = if self.geometry == Geometry::Axisymmetric { TAU * state.nodes[e][0] } else { 1.0 };
                let conducted = dt * self.flow.conductivity * width * state.thickness_at(e) / distance;
                self.off[e - 1] = -conducted;
                self.diagonal[e - 1] += conducted;
                self.diagonal[e] += conducted;
            }
        }
        let capacity = self.flow.capacity;
        let content = |state: &State| -> f64 {
            state.volume.iter().zip(&state.temperature).map(|(volume, t)| capacity * volume * t).sum()
        };
        let before = content(state);
        self.solve(&mut state.temperature);
        let steps = state.temperature.iter().zip(&converged.step.state.temperature);
        for (rates, (now, then)) in state.temperature_rates.iter_mut().zip(steps) {
            *rates = [(now - then) / dt, rates[0]];
        }
        let after = content(state);
        let tools = self.exchange.iter().zip(&state.temperature).map(|([by, heat], t)| heat - by * t).sum();
        Heat { plastic: self.flow.plastic_share * plastic.iter().sum::<f64>(), tools, stored: after - before }
    }

    fn meet_tools(&mut self, converged: &Converged) {
        let Converged { step, evaluation, .. } = converged;
        let n = self.exchange.len();
        self.exchange.fill([0.0; 2]);
        for &(j, tool) in &self.tools {
            for e in 0..n {
                for point in STATIONS * e..STATIONS * (e + 1) {
                    if evaluation.contacts[(j, point)].lies_on(&step.context.penalty) {
                        let exchanged = step.dt * tool.transfer * step.areas[point];
                        self.exchange[e][0] += exchanged;
                        self.exchange[e][1] += exchanged * tool.temperature;
                    }
                }
            }
        }
    }

    /// Elimination without pivoting: the matrix is symmetric and diagonally dominant.
    fn solve(&mut self, temperature: &mut [f64]) {
        let n = temperature.len();
        for e in 1..n {
            let factor = self.off[e - 1] / self.diagonal[e - 1];
            self.diagonal[e] -= factor * self.off[e - 1];
            self.rhs[e] -= factor * self.rhs[e - 1];
        }
        for e in (0..n).rev() {
            let next = if e + 1 < n { self.off[e] * temperature[e + 1] } else { 0.0 };
            temperature[e] = (self.rhs[e] - next) / self.diagonal[e];
        }
    }
}
