//! Sequences of stages: the sheet and the tools that stay carry over.

use super::{closing::close, closing::closed, equilibrium::unloading, step::FADING, *};
use crate::model::{stage::Beginning, stage::Stage, tool_sizes::met};
use crate::solver::{solution::Trimmed, state::waiting, state::waiting_displacement};
use std::sync::Arc;

const LEAST_ELEMENTS: usize = 2;

/// Solves stages one after another from the flat blank, up to the first that is refused or does not come to its end.
pub fn solve(stages: &[Stage], observer: &mut dyn Observer) -> Vec<StageSolution> {
    let mut solutions: Vec<StageSolution> = Vec::new();
    for stage in stages {
        if solutions.last().is_some_and(|before| !before.stop.is_complete()) {
            break;
        }
        if let Err(error) = stage.check(solutions.last().map(|before| &before.model)) {
            solutions.push(StageSolution::unsolved(stage.model.clone(), Stop::new(StopKind::Refused, error)));
            break;
        }
        observer.stage(stage);
        solutions.push(match solutions.last() {
            None => from_flat(&stage.model, observer),
            Some(before) => {
                let (model, state, trimmed) = begin(stage, before);
                StageSolution { trimmed, ..run_from(&model, state, observer) }
            }
        });
    }
    let work = solutions.iter().map(StageSolution::largest_work).fold(0.0, f64::max);
    solutions.iter_mut().for_each(|solution| solution.process_work = work);
    solutions
}

/// Solves a model from the flat blank; one that [`Model::check`] refuses ends with [`StopKind::Refused`].
pub fn run(model: &Model, observer: &mut dyn Observer) -> StageSolution {
    if let Err(error) = model.check() {
        return StageSolution::unsolved(model.clone(), Stop::new(StopKind::Refused, error));
    }
    from_flat(model, observer)
}

fn from_flat(model: &Model, observer: &mut dyn Observer) -> StageSolution {
    let Some(way) = closing_way(model) else {
        return run_from(model, State::initial(model, mesh::nodes(model)), observer);
    };
    let before = close(model, way, observer);
    if !before.stop.is_complete() {
        return before;
    }
    let model = closed(model, before.steps.last().map_or(0.0, |last| last.travel));
    let meets = [Role::Punch, Role::Pad].into_iter().filter(|role| model.tool(*role).is_some()).collect();
    let stage = Stage { name: String::new(), model, begin: Beginning { meets, ..Beginning::default() } };
    let state = enter(&stage, &before.model, before.end);
    StageSolution { closing: before.closing, ..run_from(&stage.model, state, observer) }
}

fn begin(stage: &Stage, before: &StageSolution) -> (Model, State, Option<Trimmed>) {
    let state = enter(stage, &before.model, before.end.clone());
    let mut model = stage.model.clone();
    if !state.unloading.is_empty() && model.travel > 0.0 {
        let is_new = |tool: &&mut Tool| !before.model.tools.iter().any(|old| stays(stage, tool, old));
        for tool in model.tools.iter_mut().filter(is_new) {
            if let Motion::Pressed(press) = &mut tool.motion {
                press.force = press.force.rising_to(FADING * model.travel);
            }
        }
    }
    model.blank.elements = state.thickness.len();
    model.blank.length = state.s0[state.s0.len() - 1];
    let trimmed = stage.begin.trim.map(|asked| {
        let (edge, left) = (state.nodes[state.nodes.len() - 1][0], model.blank.elements);
        Trimmed { asked, edge, elements: before.model.blank.elements - left }
    });
    (model, state, trimmed)
}

/// First state of a stage, from the last `state` of a stage with the model `before`.
///
/// Time and travel restart, velocities scale with the speed; tools that stay keep position and pressure, gases their pressure.
pub fn enter(stage: &Stage, before: &Model, mut state: State) -> State {
    let (model, begin) = (&stage.model, &stage.begin);
    // The forces of tools that had gone before have faded.
    (state.time, state.travel, state.unloading) = (0.0, 0.0, Arc::default());
    if begin.turn_over {
        turn_over(&mut state);
    }
    let pace = model.speed / before.speed;
    state.velocity.iter_mut().chain(&mut state.end_velocity).for_each(|node| *node = node.map(|v| pace * v));
    state.steady.fill(false);
    state.temperature_rates.fill([0.0; 2]);
    state.points.iter_mut().for_each(|point| point.equivalent_rate = 0.0);
    if let Some(radius) = begin.trim {
        trim(&mut state, radius);
    }
    state.ironed.iter_mut().for_each(|[stage, _]| *stage = 0.0);
    state.tearing_index = vec![[0.0; 2]; state.thickness.len()];
    if begin.anneal {
        state.nose_curvature.fill(0.0);
        for point in state.points.iter_mut() {
            // Annealing closes no void.
            let MaterialPoint { porosity, porosity_rate, strain_rate, damage, .. } = *point;
            *point = MaterialPoint { porosity, porosity_rate, strain_rate, damage, ..MaterialPoint::default() };
        }
    }
    let carried = model.gas.iter().map(|gas| before.gas.iter().position(|old| old.face == gas.face));
    state.gas = carried.map(|old| old.map_or(0.0, |k| state.gas[k])).collect();

    let old = state.clone();
    state.pressure = Grid::new(model.tools.len(), state.contact_points(), 0.0);
    state.shift = state.pressure.clone();
    state.tool_velocity = vec![0.0; model.tools.len()];
    state.tools = model.tools.iter().map(|tool| Point::new(0.0, waiting_displacement(model, tool))).collect();
    for (j, tool) in model.tools.iter().enumerate() {
        if let Some(k) = before.tools.iter().position(|other| stays(stage, tool, other)) {
            state.tools[j] = old.tools[k];
            state.pressure.row_mut(j).copy_from_slice(old.pressure.row(k));
            state.shift.row_mut(j).copy_from_slice(old.shift.row(k));
        }
        if begin.meets.contains(&tool.role) {
            let at = |i: usize| Point::new(state.nodes[i][0] - state.tools[j].x, state.nodes[i][1]);
            let sheet: Vec<_> = (0..state.nodes.len()).map(|i| (at(i), 0.5 * state.thickness_at(i))).collect();
            state.tools[j].y = met(&tool.profile, tool.role.side(), &sheet, [model.blank.thickness, waiting(model)]);
        }
    }
    let has_gone = |old: &Tool| !model.tools.iter().any(|tool| stays(stage, tool, old));
    let is_unheld = model.release.is_some() || begin.trim.is_some() || before.tools.iter().any(has_gone);
    state.unloading = if is_unheld && model.mode != Mode::Flow { unloading(model, &state) } else { Arc::default() };
    state
}

fn stays(stage: &Stage, tool: &Tool, old: &Tool) -> bool {
    !stage.begin.turn_over && old.role == tool.role && old.profile == tool.profile
}

/// Mirrors the sheet, z → −z: its faces change places, and with them the thickness points; rotation and shear change their sign.
fn turn_over(state: &mut State) {
    for [_, axial, turn] in state.nodes.iter_mut().chain(&mut state.velocity).chain(&mut state.end_velocity) {
        (*axial, *turn) = (-*axial, -*turn);
    }
    for point in state.points.iter_mut() {
        let [one, other] = &mut point.back;
        for [.., shear] in [&mut point.stress, &mut point.carried, &mut point.strain_rate, one, other] {
            *shear = -*shear;
        }
    }
    (0..state.thickness.len()).for_each(|e| state.points.row_mut(e).reverse());
    state.face_damage.iter_mut().for_each(|faces| faces.reverse());
}

fn trim(state: &mut State, radius: f64) {
    let inside = state.nodes.windows(2).rposition(|w| 0.5 * (w[0][0] + w[1][0]) <= radius).map_or(0, |e| e + 1);
    let elements = inside.max(LEAST_ELEMENTS).min(state.thickness.len());
    fn cut<T, const N: usize>(values: [&mut Vec<T>; N], length: usize) {
        values.into_iter().for_each(|values| values.truncate(length));
    }
    cut([&mut state.nodes, &mut state.velocity, &mut state.end_velocity], elements + 1);
    cut([&mut state.s0], elements + 1);
    let State { thickness, volume, dilation, dilation_rate, temperature, nose_curvature, .. } = state;
    cut([thickness, volume, dilation, dilation_rate, temperature, nose_curvature], elements);
    cut([&mut state.steady], elements);
    cut([&mut state.membrane, &mut state.temperature_rates, &mut state.face_damage, &mut state.ironed], elements);
    state.points.truncate_rows(elements);
    state.pressure.truncate_columns(STATIONS * elements);
    state.shift.truncate_columns(STATIONS * elements);
}
