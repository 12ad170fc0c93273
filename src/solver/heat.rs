//! Temperature of the sheet over a step, after its equilibrium.
//!
//! ```text
//! ρ c V (T′ − T) = β W + Δt Σ h A (T_tool − T′) + Δt Σ (k S/l) (T′_next − T′)
//! ```
//!
//! with an element's plastic work W, the area A that a tool touches, and the section S and distance l towards its neighbours:
//! backward Euler on finite volumes, uniform through the thickness. Equilibrium uses the extrapolated temperature.
//!
//! Source: β: G. I. Taylor, H. Quinney, Proc. R. Soc. London A 143 (1934) 307–326 (not read).

use super::*;
use std::f64::consts::TAU;

pub(super) fn advance(converged: &Converged, plastic: &[f64], state: &mut State) -> Option<Heat> {
    let Converged { step, evaluation, .. } = converged;
    let (model, n, dt) = (step.model, plastic.len(), step.dt);
    let flow = model.heat.as_ref()?.flow.as_ref()?;
    // Δt Σ h A [mJ/K] and Δt Σ h A T_tool [mJ] of every element.
    let mut exchange = vec![[0.0; 2]; n];
    for (j, tool) in flow.tools.iter().filter_map(|tool| Some((model.tool_index(tool.role)?, tool))) {
        for (i, contact) in evaluation.contacts.row(j).iter().enumerate() {
            if contact.gap < step.context.penalty.lying() {
                let exchanged = dt * tool.transfer * step.areas[i];
                exchange[i / STATIONS][0] += exchanged;
                exchange[i / STATIONS][1] += exchanged * tool.temperature;
            }
        }
    }
    // Tridiagonal and symmetric; `off` couples an element with the next.
    let (mut diagonal, mut off, mut rhs) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for (e, [by_tools, heat]) in exchange.iter().enumerate() {
        let stored = flow.capacity * state.volume[e];
        diagonal[e] = stored + by_tools;
        rhs[e] = stored * state.temperature[e] + flow.plastic_share * plastic[e] + heat;
    }
    for e in (1..n).filter(|_| flow.conductivity > 0.0) {
        let [before, after] = [state.along(e - 1), state.along(e)];
        let distance = 0.5 * (before.x.hypot(before.y) + after.x.hypot(after.y));
        let width = if model.geometry == Geometry::Axisymmetric { TAU * state.nodes[e][0] } else { 1.0 };
        let conducted = dt * flow.conductivity * width * state.thickness_at(e) / distance;
        off[e - 1] = -conducted;
        diagonal[e - 1] += conducted;
        diagonal[e] += conducted;
    }
    let content = |state: &State| -> f64 {
        state.volume.iter().zip(&state.temperature).map(|(volume, t)| flow.capacity * volume * t).sum()
    };
    let before = content(state);
    // Elimination without pivoting: the matrix is diagonally dominant.
    for e in 1..n {
        let factor = off[e - 1] / diagonal[e - 1];
        diagonal[e] -= factor * off[e - 1];
        rhs[e] -= factor * rhs[e - 1];
    }
    for e in (0..n).rev() {
        state.temperature[e] = (rhs[e] - if e + 1 < n { off[e] * state.temperature[e + 1] } else { 0.0 }) / diagonal[e];
    }
    let steps = state.temperature.iter().zip(&step.state.temperature);
    for (rates, (now, then)) in state.temperature_rates.iter_mut().zip(steps) {
        *rates = [(now - then) / dt, rates[0]];
    }
    let tools = exchange.iter().zip(&state.temperature).map(|([by, heat], t)| heat - by * t).sum();
    Some(Heat { plastic: flow.plastic_share * plastic.iter().sum::<f64>(), tools, stored: content(state) - before })
}
