//! Porosity over a step: what the corrector reckons with, and what the step made of it.

use super::step::Converged;
use crate::material::Gtn;
use crate::state::State;

/// Volume of each element at the end of a step of `dt` \[s\] \[mm³, or mm² in plane strain\] and its growth \[–\], foreseen
/// from the last rates like the porosity itself: they stay while the corrector goes, and the step is second order in its
/// length.
pub(super) fn foreseen_volume(state: &State, dt: f64) -> (Vec<f64>, Vec<f64>) {
    let elements = state.volume.iter().zip(state.dilation.iter().zip(&state.dilation_rate));
    let volumes = elements.map(|(volume, (dilation, rate))| {
        let growth = rate * dt;
        (volume * (dilation + growth).exp(), growth.exp())
    });
    volumes.unzip()
}

/// Integrates the porosity of every thickness point along its strain path, and corrects strain and thickness by it; `next`
/// stands at the end of the step.
pub(super) fn grow(voids: &Gtn, converged: &Converged, next: &mut State) {
    let Converged { step, trial, evaluation, .. } = converged;
    for (e, points) in next.points.rows_mut().enumerate() {
        let mut volume = 0.0;
        for (k, (point, at)) in points.iter_mut().zip(&step.process.rule).enumerate() {
            let before = point.strain - evaluation.updates[(e, k)].increment;
            let now =
                voids.evolve(step.model.material.anisotropy, point.porosity, before, trial.iterates[(e, k)].strain());
            point.porosity_rate = (now.porosity - point.porosity) / step.dt;
            point.porosity = now.porosity;
            point.strain = now.strain;
            volume += at.weight * now.volume;
        }
        next.thickness[e] *= volume.exp() / step.growth[e];
        next.dilation[e] += volume;
        next.dilation_rate[e] = volume / step.dt;
    }
}
