//! What it means that a step, however short, finds no equilibrium: often there is none, and the sheet says why.

use super::corrector::Outcome;
use super::evaluation::Evaluation;
use super::step::Step;
use crate::element::surface::STATIONS;
use crate::model::{Edge, Geometry, Motion, Role};
use crate::solver::solution::neck::neck;
use crate::solver::solution::{StepRecord, Stop};
use crate::solver::state::State;
use crate::units::{Amount, joined};

/// Way of a place, or work on the sheet, in the last step over what its mean rate so far would have made of it: beyond that
/// it runs away \[–\].
const RUNAWAY: f64 = 5.0;
/// Way that the sheet's middle is ahead of a punch that pushes it, over the thickness, from which the sheet is an arch \[–\].
const AHEAD: f64 = 1.0;
const ADVICE: &str = "try more elements, a smaller solver.first_step, or solver.norm = \"velocity\"";

/// Why no equilibrium was found for `step`, however short, after `steps`; `outcome` is that of its last try.
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

/// What makes a run creep, whose `step` is one try too many after `steps`; `evaluation` is that of the last of them, and
/// `worst` the node with the largest residual in the last try that failed, where one did.
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

/// The first node of the element that strained most in the last step.
fn fastest_straining(state: &State) -> usize {
    let rate = |e: usize| state.points.row(e).iter().map(|point| point.equivalent_rate).fold(0.0, f64::max);
    (0..state.thickness.len()).max_by(|&a, &b| rate(a).total_cmp(&rate(b))).unwrap_or(0)
}

/// An end that has a name; `worst` is the node that is farthest from equilibrium.
fn named(step: &Step, evaluation: &Evaluation, worst: usize, steps: &[StepRecord]) -> Option<Stop> {
    mechanism(step, worst).or_else(|| burst(step, evaluation, steps)).or_else(|| arch(step, steps))
}

/// A strip of membranes bears load by tension alone: without anything that holds it back no shape of it is in equilibrium.
/// Around the axis the hoop holds it.
fn mechanism(step: &Step, i: usize) -> Option<Stop> {
    let model = step.model;
    let bends = step.bends[i.max(1) - 1] && step.bends[i.min(step.bends.len() - 1)];
    let tools = || step.process.tools.iter().filter(|tool| !tool.is_absent());
    let rubs = tools().any(|tool| tool.role != Role::Punch && tool.friction.largest_coefficient() > 0.0);
    let held = model.blank.edge != Edge::Free
        || !(model.beads.is_empty() && model.gas.is_empty())
        || (rubs && tools().any(|tool| tool.role == Role::Holder));
    (model.geometry == Geometry::PlaneStrain && !bends && !held)
        .then(|| Stop::Mechanism { travel: step.state.travel, s0: step.state.s0[i] })
}

/// Whether a place that gas alone presses runs away as the run ends, or the sheet as a whole, as a strip that gas folds round
/// its punch: it has come to the largest pressure that it can bear.
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

/// Whether the sheet's middle has gone ahead of a punch that pushes: legs that swing or come together lift it off as an arch,
/// which snaps through without a load to balance it.
fn arch(step: &Step, steps: &[StepRecord]) -> Option<Stop> {
    let (model, state) = (step.model, step.state);
    let j = model.tools.iter().position(|tool| tool.role == Role::Punch)?;
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

/// What the sheet was doing where the solver got no further, at node `i`.
fn seen(step: &Step, evaluation: &Evaluation, i: usize, steps: &[StepRecord]) -> String {
    let Step { model, state, .. } = *step;
    let last = steps.last().copied().unwrap_or_default();
    let mut seen = Vec::new();
    let neck = neck(model, state, None);
    if last.step == 0 {
        seen.push(
            "the first step did not converge: the tools may not meet the sheet as drawn (see `stampflow check`)".into(),
        );
    }
    if neck.stands_out {
        let (s0, left) = (Amount::place(neck.s0), Amount::share(neck.share));
        seen.push(format!("the sheet has necked at s0 = {s0} ({left} left)"));
    }
    if last.ironing > 0.02 {
        let share = Amount::share(last.ironing);
        seen.push(format!("two tools iron the sheet by {share} of its thickness"));
    }
    if 8 * last.contact_changes > evaluation.nodes.len() {
        seen.push(format!("{n} contacts came or went in the last step", n = last.contact_changes));
    }
    if i + 2 >= evaluation.nodes.len() && model.blank.edge == Edge::Free {
        seen.push("the worst place is the blank's edge".into());
    }
    let mut tools = step.process.tools.iter().enumerate();
    let points = STATIONS * (i.max(1) - 1)..STATIONS * (i + 1).min(state.thickness.len());
    if let Some((_, tool)) =
        tools.find(|(j, _)| points.clone().any(|point| evaluation.contacts[(*j, point)].normal > 0.0))
    {
        seen.push(format!("the {tool} touches the sheet at the worst place", tool = tool.role.name()));
    }
    joined(seen, ", ")
}
