//! Where the sheet flows steadily, so that the rate of one step says something of the next.

use super::evaluation::Evaluation;
use super::step::Step;
use crate::model::Mode;
use crate::solver::state::State;

/// Change of the strain rate from step to step, over the rate, up to which the flow is steady \[–\].
const STEADY: f64 = 0.6;
/// Strain increments of a flow, in cut-offs: what is slower creeps only because it is regularised.
const FLOWING: f64 = 10.0;

/// Marks in `next`, at the end of a step, the elements that flow steadily at all of their thickness points. Where one of
/// them does not, bending sets in or turns round, and the others soon follow.
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
