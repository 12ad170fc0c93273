//! Diagnosis of a step without equilibrium: often there is none, and the sheet shows why.

use super::{ironing::is_between_walls, *};
use crate::solver::solution::neck::neck;
use crate::units::{Amount, joined};

/// Motion of a place, or work on the sheet, in the last step over its mean so far, beyond which it runs away \[–\].
const RUNAWAY: f64 = 5.0;
/// Distance of the sheet's middle ahead of a pushing punch, over the thickness, from which the sheet is an arch \[–\].
const AHEAD: f64 = 1.0;
/// Least share of the punch's travel that closes the gap in front of its face \[–\]: 6° of lean, declared.
const CLOSING: f64 = 0.1;

pub(super) fn no_equilibrium(step: &Step, evaluation: &Evaluation, outcome: &Outcome, steps: &[StepRecord]) -> Stop {
    let worst = evaluation.worst_node;
    mechanism(step, evaluation, worst, steps).unwrap_or_else(|| {
        let norm = |norm: f64| if norm.is_finite() { Amount::norm(norm).to_string() } else { "not known".into() };
        let [velocity, residual] = [outcome.increment, outcome.residual_norm].map(norm);
        let (at, dt, s0) = (reached(step.state), Amount::time(step.dt), step.state.s0[worst]);
        let text = format!(
            "no equilibrium found at {at} with steps down to {dt} (velocity norm {velocity}, residual norm {residual}, worst \
             at s0 = {})",
            Amount::place(s0)
        );
        Stop::at(StopKind::NoEquilibrium, s0, joined([text, symptoms(step, evaluation, worst, steps)], "; "))
    })
}

/// Reason why a run spent its budget of `tries` at `step`; `worst` is the node with the largest residual of the last failed try.
pub(super) fn creeping(
    step: &Step, evaluation: &Evaluation, worst: Option<usize>, steps: &[StepRecord], tries: usize,
) -> Stop {
    let state = step.state;
    let rate = |e: &usize| state.points.row(*e).iter().map(|point| point.equivalent_rate).fold(0.0, f64::max);
    let fastest = || (0..state.thickness.len()).max_by(|a, b| rate(a).total_cmp(&rate(b))).unwrap_or(0);
    let worst = worst.unwrap_or_else(fastest);
    mechanism(step, evaluation, worst, steps).unwrap_or_else(|| {
        let (at, dt, s0) = (reached(state), Amount::time(step.dt), state.s0[worst]);
        let spent = format!("{tries} tries of a step have come to {at}, the next would take {dt}");
        let text = format!("creeping: {spent}; worst at s0 = {}", Amount::place(s0));
        Stop::at(StopKind::Creeping, s0, joined([text, symptoms(step, evaluation, worst, steps)], ": "))
    })
}

pub(super) fn interrupted(state: &State) -> Stop {
    Stop::new(StopKind::Interrupted, format!("interrupted at {}: the results up to there are kept", reached(state)))
}

pub(super) fn reached(state: &State) -> String {
    let (travel, time) = (Amount::place(state.travel), Amount::time(state.time));
    if state.travel > 0.0 { format!("{travel} of travel") } else { time.to_string() }
}

fn mechanism(step: &Step, evaluation: &Evaluation, worst: usize, steps: &[StepRecord]) -> Option<Stop> {
    loose_strip(step, worst).or_else(|| burst(step, evaluation, steps)).or_else(|| arch(step, steps))
}

/// A strip of membranes bears load by tension alone: without restraint no shape of it is in equilibrium.
fn loose_strip(step: &Step, i: usize) -> Option<Stop> {
    let (travel, s0) = (Amount::place(step.state.travel), step.state.s0[i]);
    (step.model.blank.theory == Theory::Membrane && is_loose(step.context)).then(|| {
        let at = Amount::place(s0);
        let text = format!("mechanism: at {travel} of travel nothing holds the membranes; they give way at s0 = {at}");
        Stop::at(StopKind::Mechanism, s0, text)
    })
}

fn is_loose(context: &RunContext) -> bool {
    let model = context.model;
    let tools = || context.acting_tools();
    let rubs = tools().any(|(_, tool)| tool.role != Role::Punch && tool.friction.largest_coefficient() > 0.0);
    let held = model.blank.edge != Edge::Free
        || !(model.beads.is_empty() && model.gas.is_empty())
        || (rubs && tools().any(|(_, tool)| tool.role == Role::Holder));
    model.geometry == Geometry::PlaneStrain && !held
}

/// Mechanism that only the stabilisation of elastic membranes would hold: a loose strip in front of a punch.
pub(super) fn unheld(context: &RunContext) -> Option<Stop> {
    let model = context.model;
    let slack = model.mode != Mode::Flow && model.blank.theory == Theory::Membrane && model.release.is_none();
    let text = "mechanism: nothing holds the strip of membranes, which gives way to the punch without a force";
    (slack && is_loose(context) && model.tool(Role::Punch).is_some_and(pushes))
        .then(|| Stop::new(StopKind::Mechanism, text))
}

fn pushes(punch: &Tool) -> bool {
    punch.motion == Motion::Travel || matches!(punch.motion, Motion::Path(way) if way.y > 0.0)
}

/// Tools that squeeze the sheet between them come to a gap that it does not fill without bound on their pressure.
pub(super) fn squeezed(step: &Step, evaluation: &Evaluation) -> Option<Stop> {
    let punch = evaluation.contacts.row(step.model.tool_index(Role::Punch)?);
    let pressure = |e: usize| {
        let closing = punch[STATIONS * e..STATIONS * (e + 1)].iter().filter(|contact| contact.facing.y > CLOSING);
        closing.map(|contact| contact.pressure.value).fold(0.0, f64::max)
    };
    let pressed = (0..step.references.len()).filter(|&e| is_between_walls(step, evaluation, e) && pressure(e) > 0.0);
    let e = pressed.max_by(|&a, &b| pressure(a).total_cmp(&pressure(b)))?;
    let [travel, s0] = [step.state.travel, step.state.middle(e)].map(Amount::place);
    let presses =
        |j: usize| (STATIONS * e..STATIONS * (e + 1)).any(|i| evaluation.contacts[(j, i)].pressure.value > 0.0);
    let pressing = step.context.tools.iter().enumerate().filter(|(j, _)| presses(*j));
    let names = joined(pressing.map(|(_, tool)| step.model.name_of(tool.role)), " and ");
    let text = format!(
        "tools closed: at {travel} of travel {names} squeeze the sheet between them, with {} at s0 = {s0}; no \
         equilibrium was found beyond",
        Amount::stress(pressure(e))
    );
    Some(Stop::at(StopKind::ToolsClosed, step.state.middle(e), text))
}

/// A place, or the whole sheet, that runs away under gas has come to the largest pressure that it can bear.
fn burst(step: &Step, evaluation: &Evaluation, steps: &[StepRecord]) -> Option<Stop> {
    let [.., before, last] = steps else { return None };
    let (model, state) = (step.model, step.state);
    let is_free = |i: &usize| {
        let around = STATIONS * ((*i).max(1) - 1)..STATIONS * (i + 1).min(state.thickness.len());
        let pressed = state.pressure.rows().any(|of_tool| of_tool[around.clone()].iter().any(|p| *p > 0.0));
        evaluation.gas_force[*i].norm() > 0.0 && !pressed
    };
    let speed = |i: usize| state.velocity[i][0].hypot(state.velocity[i][1]);
    let fastest = (0..state.nodes.len()).filter(is_free).max_by(|&a, &b| speed(a).total_cmp(&speed(b)))?;
    let ([r, z, _], s0) = (state.nodes[fastest], state.s0[fastest]);
    let dt = last.time - before.time;
    // The load that the last step added, over the whole: of the pressure or of the run.
    let rise = (last.pressure - before.pressure) / last.pressure;
    let share = model.process_time(before.time, dt) / model.process_time(0.0, last.time);
    let place_runs = dt * speed(fastest) > RUNAWAY * rise.max(share) * (r - s0).hypot(z);
    let sheet_runs = last.work.external - before.work.external > RUNAWAY * share * last.work.external;
    (place_runs || sheet_runs).then(|| {
        let (pressure, [place, r, height]) = (Amount::stress(last.pressure.abs()), [s0, r, z].map(Amount::place));
        let at = match model.blank.is_open() {
            true => format!("the tube has a radius of {r}, {place} along it"),
            false => format!("the sheet at s0 = {place} is at a height of {height}"),
        };
        let text = format!(
            "pressure maximum reached: no equilibrium beyond {pressure}, where {at}; it would run away there, to burst or to fold"
        );
        Stop::at(StopKind::PressureMaximum, s0, text)
    })
}

/// A sheet whose middle is ahead of a pushing punch is an arch that snaps through without a balancing load.
fn arch(step: &Step, steps: &[StepRecord]) -> Option<Stop> {
    let (model, state) = (step.model, step.state);
    let j = model.tool_index(Role::Punch)?;
    let punch = &model.tools[j];
    let top = punch.profile.extreme(true, model.blank.ends())?.y + state.tools[j].y;
    let ahead = state.nodes[0][1] - 0.5 * state.thickness_at(0) - top;
    let presses = model.gas.is_empty() && steps.last().is_some_and(|last| last.punch_force > 0.0);
    let (travel, way) = (Amount::place(state.travel), Amount::thickness(ahead));
    let text = format!("arched: at {travel} of travel the middle is {way} ahead of the punch: it snaps through");
    (pushes(punch) && presses && ahead > AHEAD * model.blank.thickness).then(|| Stop::new(StopKind::Arched, text))
}

fn symptoms(step: &Step, evaluation: &Evaluation, i: usize, steps: &[StepRecord]) -> String {
    let Step { model, state, .. } = *step;
    let last = steps.last().copied().unwrap_or_default();
    let neck = neck(model, state, None);
    let points = STATIONS * (i.max(1) - 1)..STATIONS * (i + 1).min(state.thickness.len());
    let touches = |j: usize| points.clone().any(|point| evaluation.contacts[(j, point)].normal > 0.0);
    let touching = step.context.tools.iter().enumerate().find(|(j, _)| touches(*j));
    let at_edge = i + 2 >= evaluation.nodes.len() && model.blank.edge == Edge::Free;
    let first = "the first step did not converge: the tools may not meet the sheet as drawn (see `stampflow check`)";
    let (s0, left, ironed) = (Amount::place(neck.s0), Amount::share(neck.share), Amount::share(last.ironing));
    let symptoms = [
        (last.step == 0).then(|| first.to_owned()),
        neck.stands_out.then(|| format!("the sheet has necked at s0 = {s0} ({left} left)")),
        (last.ironing > 0.02).then(|| format!("two tools iron the sheet by {ironed} of its thickness")),
        (8 * last.contact_changes > evaluation.nodes.len())
            .then(|| format!("{} contacts came or went in the last step", last.contact_changes)),
        at_edge.then(|| "the worst place is the blank's edge".to_owned()),
        touching.map(|(_, tool)| format!("the {} touches the sheet at the worst place", model.name_of(tool.role))),
    ];
    joined(symptoms.into_iter().flatten(), ", ")
}
