//! Diagnosis of a step without equilibrium: often there is none, and the sheet shows why.

use super::corrector::Outcome;
use super::evaluation::Evaluation;
use super::step::Step;
use crate::element::surface::STATIONS;
use crate::model::{Edge, Geometry, Motion, Role};
use crate::solver::solution::neck::neck;
use crate::solver::solution::{StepRecord, Stop};
use crate::solver::state::State;
use crate::units::{Amount, joined};

/// Motion of a place, or work on the sheet, in the last step over its mean so far, beyond which it runs away \[–\].
const RUNAWAY: f64 = 5.0;
/// Distance of the sheet's middle ahead of a pushing punch, over the thickness, from which the sheet is an arch \[–\].
const AHEAD: f64 = 1.0;
const ADVICE: &str = "try more elements, a smaller solver.first_step, or solver.norm = \"velocity\"";

/// Reason why no equilibrium was found for `step`, by the outcome of its last try.
pub(super) fn no_equilibrium(step: &Step, evaluation: &Evaluation, outcome: &Outcome, steps: &[StepRecord]) -> Stop {
    let (state, worst) = (step.state, evaluation.worst_node);
    named(step, evaluation, worst, steps).unwrap_or_else(|| Stop::NoEquilibrium {
        travel: state.travel,
        time: state.time,
        step: step.dt,
        velocity_norm: outcome.increment,
        residual_norm: outcome.residual_norm,
        worst_s0: state.s0[worst],
        diagnosis: joined([seen(step, evaluation, worst, steps), ADVICE.into()], "; "),
    })
}

/// Reason why a run spent its budget at `step`; `worst` is the node with the largest residual of the last failed try.
pub(super) fn creeping(
    step: &Step,
    evaluation: &Evaluation,
    worst: Option<usize>,
    steps: &[StepRecord],
    tries: usize,
) -> Stop {
    let state = step.state;
    let worst = worst.unwrap_or_else(|| fastest_straining(state));
    named(step, evaluation, worst, steps).unwrap_or_else(|| Stop::Creeping {
        travel: state.travel,
        time: state.time,
        tries,
        step: step.dt,
        worst_s0: state.s0[worst],
        seen: seen(step, evaluation, worst, steps),
    })
}

fn fastest_straining(state: &State) -> usize {
    let rate = |e: usize| state.points.row(e).iter().map(|point| point.equivalent_rate).fold(0.0, f64::max);
    (0..state.thickness.len()).max_by(|&a, &b| rate(a).total_cmp(&rate(b))).unwrap_or(0)
}

/// A known mechanism of failure; `worst` is the node farthest from equilibrium.
fn named(step: &Step, evaluation: &Evaluation, worst: usize, steps: &[StepRecord]) -> Option<Stop> {
    mechanism(step, worst).or_else(|| burst(step, evaluation, steps)).or_else(|| arch(step, steps))
}

/// A strip of membranes bears load by tension alone: without restraint no shape of it is in equilibrium.
fn mechanism(step: &Step, i: usize) -> Option<Stop> {
    let model = step.model;
    let bends = step.bends[i.max(1) - 1] && step.bends[i.min(step.bends.len() - 1)];
    let tools = || step.context.acting_tools();
    let rubs = tools().any(|(_, tool)| tool.role != Role::Punch && tool.friction.largest_coefficient() > 0.0);
    let held = model.blank.edge != Edge::Free
        || !(model.beads.is_empty() && model.gas.is_empty())
        || (rubs && tools().any(|(_, tool)| tool.role == Role::Holder));
    (model.geometry == Geometry::PlaneStrain && !bends && !held)
        .then(|| Stop::Mechanism { travel: step.state.travel, s0: step.state.s0[i] })
}

/// A place, or the whole sheet, that runs away under gas has come to the largest pressure that it can bear.
fn burst(step: &Step, evaluation: &Evaluation, steps: &[StepRecord]) -> Option<Stop> {
    let [.., before, last] = steps else { return None };
    let (model, state) = (step.model, step.state);
    let is_free = |i: &usize| {
        let around = STATIONS * ((*i).max(1) - 1)..STATIONS * (i + 1).min(state.thickness.len());
        let pressed =
            state.pressure.rows().any(|of_tool| of_tool[around.clone()].iter().any(|pressure| *pressure > 0.0));
        evaluation.gas_force[*i].norm() > 0.0 && !pressed
    };
    let speed = |i: usize| state.velocity[i][0].hypot(state.velocity[i][1]);
    let fastest = (0..state.nodes.len()).filter(is_free).max_by(|&a, &b| speed(a).total_cmp(&speed(b)))?;
    let [r, z, _] = state.nodes[fastest];
    let way = (r - state.s0[fastest]).hypot(z);
    let dt = last.time - before.time;
    // The load that the last step added, over the whole: of the pressure or of the run.
    let rise = (last.pressure - before.pressure) / last.pressure;
    let share = model.process_time(before.time, dt) / model.process_time(0.0, last.time);
    let place_runs = dt * speed(fastest) > RUNAWAY * rise.max(share) * way;
    let sheet_runs = last.work.external - before.work.external > RUNAWAY * share * last.work.external;
    (place_runs || sheet_runs).then(|| Stop::PressureMaximum {
        pressure: last.pressure.abs(),
        height: z,
        s0: state.s0[fastest],
    })
}

/// A sheet whose middle is ahead of a pushing punch is an arch that snaps through without a balancing load.
fn arch(step: &Step, steps: &[StepRecord]) -> Option<Stop> {
    let (model, state) = (step.model, step.state);
    let j = model.tool_index(Role::Punch)?;
    let punch = &model.tools[j];
    let pushes = match punch.motion {
        Motion::Travel => true,
        Motion::Path(way) => way.y > 0.0,
        _ => false,
    };
    let top = punch.profile.extreme(true, model.blank.length)?.y + state.tools[j].y;
    let ahead = state.nodes[0][1] - 0.5 * state.thickness_at(0) - top;
    let presses = model.gas.is_empty() && steps.last().is_some_and(|last| last.punch_force > 0.0);
    (pushes && presses && ahead > AHEAD * model.blank.thickness).then_some(Stop::Arched { travel: state.travel, ahead })
}

fn seen(step: &Step, evaluation: &Evaluation, i: usize, steps: &[StepRecord]) -> String {
    let Step { model, state, .. } = *step;
    let last = steps.last().copied().unwrap_or_default();
    let neck = neck(model, state, None);
    let points = STATIONS * (i.max(1) - 1)..STATIONS * (i + 1).min(state.thickness.len());
    let touches = |j: usize| points.clone().any(|point| evaluation.contacts[(j, point)].normal > 0.0);
    let touching = step.context.tools.iter().enumerate().find(|(j, _)| touches(*j));
    let at_edge = i + 2 >= evaluation.nodes.len() && model.blank.edge == Edge::Free;
    let first = "the first step did not converge: the tools may not meet the sheet as drawn (see `stampflow check`)";
    let (s0, left, ironed) = (Amount::place(neck.s0), Amount::share(neck.share), Amount::share(last.ironing));
    let seen = [
        (last.step == 0).then(|| first.to_owned()),
        neck.stands_out.then(|| format!("the sheet has necked at s0 = {s0} ({left} left)")),
        (last.ironing > 0.02).then(|| format!("two tools iron the sheet by {ironed} of its thickness")),
        (8 * last.contact_changes > evaluation.nodes.len())
            .then(|| format!("{} contacts came or went in the last step", last.contact_changes)),
        at_edge.then(|| "the worst place is the blank's edge".to_owned()),
        touching.map(|(_, tool)| format!("the {} touches the sheet at the worst place", tool.role.name())),
    ];
    joined(seen.into_iter().flatten(), ", ")
}
