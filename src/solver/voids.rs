//! Voids over a step: what the corrector reckons with, and what the step made of them.

use super::assembly::Workspace;
use crate::material::{Gtn, Hill48};
use crate::state::State;

impl Workspace {
    /// Porosity and volume at the end of the step, foreseen from their last rates: they stay while the corrector goes, and
    /// the step is second order in its length.
    pub(super) fn foresee_voids(&mut self, voids: &Gtn, state: &State, dt: f64) {
        for (before, point) in self.before.iter_mut().zip(&state.layers) {
            before.porosity = voids.foreseen(point.porosity + point.porosity_rate * dt);
        }
        for e in 0..self.volume.len() {
            let growth = state.dilation_rate[e] * dt;
            self.growth[e] = growth.exp();
            self.volume[e] = state.volume[e] * (state.dilation[e] + growth).exp();
        }
    }

    /// After a step: integrates the porosity of every layer point along its strain path, and corrects strain and thickness
    /// by it. `state` has moved on to the end of the step.
    pub(super) fn grow_voids(&self, voids: &Gtn, anisotropy: Hill48, state: &mut State, dt: f64) {
        let layers = &self.layers;
        for (e, points) in state.layers.chunks_mut(layers.len()).enumerate() {
            let mut volume = 0.0;
            for (k, (point, layer)) in points.iter_mut().zip(layers).enumerate() {
                let i = e * layers.len() + k;
                let before = point.strain - self.responses[i].increment;
                let now = voids.evolve(anisotropy, point.porosity, before, self.iterates[i].strain());
                point.porosity_rate = (now.porosity - point.porosity) / dt;
                point.porosity = now.porosity;
                point.strain = now.strain;
                volume += layer.weight * now.volume;
            }
            state.thickness[e] *= volume.exp() / self.growth[e];
            state.dilation[e] += volume;
            state.dilation_rate[e] = volume / dt;
        }
    }
}
