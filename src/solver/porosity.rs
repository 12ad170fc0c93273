//! Evolution of porosity over a converged step.

use super::evaluation::Evaluation;
use super::step::Step;
use super::trial::Trial;
use crate::material::Gtn;
use crate::solver::state::State;

/// Integrates the porosity of every thickness point, and corrects strain and thickness of `next` by it.
pub(super) fn grow(voids: &Gtn, step: &Step, trial: &Trial, evaluation: &Evaluation, next: &mut State) {
    let metal = step.model.material.yield_criterion.quadratic();
    for (e, points) in next.points.rows_mut().enumerate() {
        let mut volume = 0.0;
        for (k, (point, at)) in points.iter_mut().zip(&step.context.rule).enumerate() {
            let before = point.strain - evaluation.updates[(e, k)].increment;
            let now = voids.evolve(metal, point.porosity, before, trial.iterates[(e, k)].strain());
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
