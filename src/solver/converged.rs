//! Converged steps and the states after them.

use super::{terms::contact, *};
use crate::material::{Elastic, Gtn, flow::YieldCondition};

/// Largest relative change of the strain rate in steady flow \[–\].
const STEADY: f64 = 0.6;
/// Least strain increment of flow, in cut-offs \[–\].
const FLOWING: f64 = 10.0;

pub(super) struct Converged<'a> {
    pub step: &'a Step<'a>,
    pub trial: &'a Trial,
    pub evaluation: &'a Evaluation,
    pub outcome: Outcome,
}

impl<'a> Converged<'a> {
    pub fn new(step: &'a Step, trial: &'a mut Trial, evaluation: &'a mut Evaluation, outcome: Outcome) -> Self {
        contact::measure_far(step, trial, evaluation);
        Self { step, trial, evaluation, outcome }
    }

    /// Force along z of every tool on the sheet, of the whole part \[N, or N/mm\].
    pub fn tool_forces(&self) -> Vec<f64> {
        self.evaluation.tool_force.iter().map(|force| self.step.model.extent().times() * force.y).collect()
    }

    /// Largest equivalent strain increment at a thickness point \[–\].
    pub fn strain_increment(&self) -> f64 {
        self.evaluation.updates.iter().map(|update| update.increment).fold(0.0, f64::max)
    }

    pub fn advanced(&self) -> State {
        let Self { step, trial, evaluation, .. } = self;
        let Step { model, state, dt, .. } = **step;
        let points = state.points.iter().zip(evaluation.updates.iter()).zip(trial.iterates.iter()).enumerate();
        let points = points.map(|(i, ((point, update), iterate))| {
            let (carried, back) = match trial.elastoplastic.get(i) {
                None => (iterate.carried(), point.back),
                Some(memory) => (update.stress, memory.back),
            };
            let (strain, strain_rate) = (point.strain + update.increment, iterate.strain.map(|strain| strain / dt));
            let (stress, equivalent_rate) = (update.stress, update.increment / step.process_time);
            MaterialPoint { strain, stress, carried, back, strain_rate, equivalent_rate, ..*point }
        });
        let pressures = evaluation.contacts.iter().map(|contact| contact.pressure.value);
        let strains = state.membrane.iter().zip(&evaluation.membrane_increment);
        let velocity: Vec<Node> = trial.moves.iter().map(|u| u.map(|u| u / dt)).collect();
        let mut next = State {
            time: step.end(),
            travel: step.travel(),
            nodes: evaluation.nodes.clone(),
            end_velocity: self.end_velocity(&velocity),
            velocity,
            thickness: evaluation.thickness.clone(),
            membrane: strains.map(|(total, e)| [total[0] + e[0], total[1] + e[1]]).collect(),
            last_step: dt,
            steady: vec![false; state.steady.len()],
            points: Grid::from_values(state.points.columns(), points),
            tools: trial.tools.clone(),
            tool_velocity: trial.tools.iter().zip(&state.tools).map(|(now, before)| (now.y - before.y) / dt).collect(),
            pressure: Grid::from_values(state.contact_points(), pressures),
            shift: Grid::from_values(state.contact_points(), trial.contacts.iter().map(|memory| memory.shift)),
            gas: trial.gas.clone(),
            ..state.clone()
        };
        mark_steady(step, evaluation, &mut next);
        if let Some(elastic) = model.elasticity() {
            correct_elastic_volume(elastic, step, evaluation, &mut next);
        }
        if let Some(voids) = &model.material.gtn {
            grow_voids(voids, step, trial, evaluation, &mut next);
        }
        if let Some(fracture) = &model.material.fracture {
            damage::add(fracture, self, &mut next);
        }
        next
    }

    /// Velocities extrapolated linearly to the end of the step from the means of this and the last one.
    fn end_velocity(&self, mean: &[Node]) -> Vec<Node> {
        let Step { state, dt, speed_ratio, number, .. } = *self.step;
        if number == 1 {
            return mean.to_vec();
        }
        let ahead = dt / (dt + state.last_step / speed_ratio);
        let nodes = mean.iter().zip(&state.velocity);
        nodes.map(|(now, before)| [0, 1, 2].map(|d| now[d] + ahead * (now[d] - speed_ratio * before[d]))).collect()
    }
}

fn mark_steady(step: &Step, evaluation: &Evaluation, next: &mut State) {
    if step.model.mode != Mode::Flow {
        return;
    }
    let metal = &step.model.material.yield_criterion;
    let rows = next.points.rows().zip(step.state.points.rows()).zip(evaluation.updates.rows());
    for (steady, ((now, before), updates)) in next.steady.iter_mut().zip(rows) {
        *steady = now.iter().zip(before).zip(updates).all(|((now, before), update)| {
            let (rate, last) = (now.strain_rate, before.strain_rate.map(|rate| step.speed_ratio * rate));
            let change = metal.equivalent_increment([rate[0] - last[0], rate[1] - last[1], rate[2] - last[2]]);
            update.increment > FLOWING * step.cutoff(1.0) && change < STEADY * metal.equivalent_increment(rate)
        });
    }
}

/// Corrects the thickness of `next` by the elastic volume strain of its stress.
///
/// ```text
/// t = t₀ exp(−ε_s − ε_θ + ln J),   ln J = (1 − 2ν)(τ_s + τ_θ)/E, the mean through the thickness
/// ```
///
/// Within a step t goes with the ln J of its start; the pressure of tools, 3(1 − 2ν) p/2E, is neglected.
fn correct_elastic_volume(elastic: Elastic, step: &Step, evaluation: &Evaluation, next: &mut State) {
    for (e, updates) in evaluation.updates.rows().enumerate() {
        let points = updates.iter().zip(&step.context.rule);
        let volume: f64 = points.map(|(update, at)| at.weight * elastic.volume_strain(update.stress)).sum();
        next.thickness[e] *= (volume - next.dilation[e]).exp();
        next.dilation[e] = volume;
    }
}

fn grow_voids(voids: &Gtn, step: &Step, trial: &Trial, evaluation: &Evaluation, next: &mut State) {
    let metal = step.model.material.yield_criterion.quadratic();
    for (e, points) in next.points.rows_mut().enumerate() {
        let mut volume = 0.0;
        for (k, (point, at)) in points.iter_mut().zip(&step.context.rule).enumerate() {
            let before = point.strain - evaluation.updates[(e, k)].increment;
            let now = voids.evolve(metal, point.porosity, before, trial.iterates[(e, k)].strain);
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
