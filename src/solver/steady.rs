//! Detection of steady flow, where the rate of one step predicts the next.

use super::evaluation::Evaluation;
use super::step::Step;
use crate::model::Mode;
use crate::solver::state::State;

/// Largest relative change of the strain rate in steady flow \[–\].
const STEADY: f64 = 0.6;
/// Least strain increment of flow, in cut-offs \[–\].
const FLOWING: f64 = 10.0;

/// Marks in `next` the elements whose thickness points all flow steadily.
pub(super) fn judge(step: &Step, evaluation: &Evaluation, next: &mut State) {
    if step.model.mode != Mode::Flow {
        return;
    }
    let metal = &step.model.material.yield_criterion;
    let least = FLOWING * step.cutoff(1.0);
    let rows = next.points.rows().zip(step.state.points.rows()).zip(evaluation.updates.rows());
    for (steady, ((now, before), updates)) in next.steady.iter_mut().zip(rows) {
        *steady = now.iter().zip(before).zip(updates).all(|((now, before), update)| {
            let (rate, last) = (now.strain_rate, before.strain_rate.map(|rate| step.speed_ratio * rate));
            let change = metal.equivalent_increment([rate[0] - last[0], rate[1] - last[1], rate[2] - last[2]]);
            update.increment > least && change < STEADY * metal.equivalent_increment(rate)
        });
    }
}
