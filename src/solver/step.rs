//! A step: what is given, and the state that a converged one leads to.
//!
//! ```text
//! Step::new(process, state, Δt)                     everything that the iterations of a step share, computed once
//! Trial::predict(step, start)                       the unknowns, and what the iterations remember of each other
//! Evaluation::update(step, trial)                   residual and matrix: a function of both
//! retry::solve(step, ..) -> Converged               the only way to a Converged
//! Converged::advanced() -> State                    the next state; a step that failed is dropped
//! ```

use super::corrector::Outcome;
use super::equilibrium::Evaluation;
use super::porosity;
use super::process::Process;
use super::retry::Start;
use super::selective_bending;
use super::terms::bead::BeadPlace;
use super::terms::gas::Seal;
use super::terms::sheet;
use super::trial::Trial;
use crate::element::kinematics::Reference;
use crate::material::elastoplastic::Carried;
use crate::material::flow::PointState;
use crate::model::{Iteration, Mode, Model, Settings};
use crate::numerics::Grid;
use crate::state::{MaterialPoint, State};

/// What is given of a step, and what follows from that alone.
pub(super) struct Step<'a> {
    pub process: &'a Process<'a>,
    pub model: &'a Model,
    /// Where it starts.
    pub state: &'a State,
    /// How long it takes by the clock, and at the mean speed of the process \[s\].
    pub dt: f64,
    pub process_time: f64,
    /// Its number, from 1.
    pub number: usize,
    /// Slip over which friction sets in \[mm\].
    pub slip_scale: f64,
    /// Which elements bend, and at which nodes an element resists their rotation.
    pub bends: Vec<bool>,
    pub rotates: Vec<bool>,
    pub references: Vec<Reference>,
    /// Area that belongs to each node \[mm², or mm per mm of depth\].
    pub areas: Vec<f64>,
    /// Shear yield stress at the nodes \[MPa\]; zero where no friction law asks for it.
    pub shear_yield: Vec<f64>,
    /// Elements by thickness points, as the flow law and as the elastoplastic law finds them; one of the two is empty.
    pub flow_points: Grid<PointState>,
    pub elastoplastic_points: Grid<Carried>,
    /// Volume of each element that the step reckons with \[mm³, or mm² in plane strain\], and its growth in the step.
    pub volume: Vec<f64>,
    pub growth: Vec<f64>,
    /// Where the model's beads hold the sheet, and where the seals of its gases cut it.
    pub beads: Vec<Option<BeadPlace>>,
    pub seals: Vec<Seal>,
}

/// Elements of a sheet in their reference configuration, each bending or not.
pub(super) fn references<'a>(
    model: &'a Model,
    state: &'a State,
    bends: &'a [bool],
) -> impl Iterator<Item = Reference> + 'a {
    state
        .nodes
        .windows(2)
        .zip(bends)
        .map(|(pair, &bends)| Reference::new(model.geometry, model.blank.theory.of_element(bends), pair[0], pair[1]))
}

/// Area that belongs to each node \[mm², or mm per mm of depth\].
pub(super) fn nodal_areas(references: impl Iterator<Item = Reference>, nodes: usize) -> Vec<f64> {
    let mut areas = vec![0.0; nodes];
    for (e, reference) in references.enumerate() {
        let [a, b] = reference.tributary();
        areas[e] += a;
        areas[e + 1] += b;
    }
    areas
}

impl<'a> Step<'a> {
    /// A step of `dt` \[s\] from `state`, the `number`-th of its run.
    pub fn new(process: &'a Process<'a>, state: &'a State, dt: f64, number: usize) -> Self {
        let model = process.model;
        let process_time = model.process_time(state.time, dt);
        let bends = selective_bending::bending(process, state);
        let references: Vec<Reference> = references(model, state, &bends).collect();
        let (volume, growth) = match &model.material.voids {
            Some(_) => porosity::foreseen_volume(state, dt),
            None => (state.volume.clone(), vec![1.0; state.volume.len()]),
        };
        let asks = process.tools.iter().any(|tool| tool.friction.needs_shear_yield());
        let (flow_points, elastoplastic_points) = match model.mode {
            Mode::Flow => (flow_points(process, state, dt, &bends), Grid::default()),
            _ => (Grid::default(), elastoplastic_points(model, state, dt)),
        };
        Self {
            process,
            model,
            state,
            dt,
            process_time,
            number,
            slip_scale: model.settings.slip_speed * model.speed * process_time,
            rotates: selective_bending::rotating(&bends),
            areas: nodal_areas(references.iter().copied(), state.nodes.len()),
            references,
            bends,
            shear_yield: if asks { shear_yield(process, state) } else { vec![0.0; state.nodes.len()] },
            flow_points,
            elastoplastic_points,
            volume,
            growth,
            beads: model.beads.iter().map(|bead| BeadPlace::find(bead, model, state)).collect(),
            seals: model.gas.iter().map(|gas| Seal::find(state, gas.within)).collect(),
        }
    }

    /// Δε₀ of the step \[–\], times `softening`.
    pub fn cutoff(&self, softening: f64) -> f64 {
        let share = self.process_time / (Settings::CUTOFF_STEP * self.model.duration);
        softening * self.model.settings.cutoff_strain * share
    }

    /// Time at its end \[s\].
    pub fn end(&self) -> f64 {
        self.state.time + self.dt
    }

    /// Punch travel at its end \[mm\].
    pub fn travel(&self) -> f64 {
        self.model.travel_at(self.end())
    }

    /// Elements that are membranes, of a sheet with several thickness points.
    pub fn membranes(&self) -> impl Iterator<Item = usize> {
        let layered = self.process.rule.len() > 1;
        (0..self.bends.len()).filter(move |&e| layered && !self.bends[e])
    }
}

/// The flow law's points; of a membrane the mean of its points.
fn flow_points(process: &Process, state: &State, dt: f64, bends: &[bool]) -> Grid<PointState> {
    let (rule, columns) = (&process.rule, state.points.columns());
    let points = state.points.iter().enumerate().map(|(i, point)| PointState {
        strain: point.strain,
        porosity: match &process.model.material.voids {
            Some(voids) => voids.foreseen(point.porosity + point.porosity_rate * dt),
            None => 0.0,
        },
        temperature: state.temperature[i / columns],
    });
    let mut points = Grid::from_values(columns, points);
    for (row, _) in points.rows_mut().zip(bends).filter(|(_, bends)| !**bends && columns > 1) {
        let mean = |of: fn(&PointState) -> f64| row.iter().zip(rule).map(|(p, at)| at.weight * of(p)).sum();
        let mean =
            PointState { strain: mean(|p| p.strain), porosity: mean(|p| p.porosity), temperature: row[0].temperature };
        row.fill(mean);
    }
    points
}

fn elastoplastic_points(model: &Model, state: &State, dt: f64) -> Grid<Carried> {
    let law = sheet::elastoplastic_law(model, Iteration::Newton, dt);
    let columns = state.points.columns();
    let points = state.points.iter().enumerate().map(|(i, point)| {
        let temperature = state.temperature[i / columns];
        let MaterialPoint { strain, stress, back, .. } = *point;
        let carried = Carried { strain, temperature, yield_stress: 0.0, stress, back };
        Carried { yield_stress: law.yield_stress(&carried), ..carried }
    });
    Grid::from_values(columns, points)
}

/// k = σ_y/√3 at the mean strain through the thickness of the elements around each node \[MPa\].
fn shear_yield(process: &Process, state: &State) -> Vec<f64> {
    let mut shear_yield = vec![0.0; state.nodes.len()];
    let last = state.thickness.len() - 1;
    for (e, points) in state.points.rows().enumerate() {
        let strain: f64 = points.iter().zip(&process.rule).map(|(p, at)| at.weight * p.strain).sum();
        let k = process.model.material.yield_stress(strain, state.temperature[e]) / 3f64.sqrt();
        shear_yield[e] += if e == 0 { k } else { 0.5 * k };
        shear_yield[e + 1] += if e == last { k } else { 0.5 * k };
    }
    shear_yield
}

/// A step in equilibrium.
pub(super) struct Converged<'a> {
    pub step: &'a Step<'a>,
    pub trial: &'a Trial,
    pub evaluation: &'a Evaluation,
    pub outcome: Outcome,
    /// What the corrector came to equilibrium from.
    pub start: Start,
}

impl Converged<'_> {
    /// Largest equivalent strain that the step adds at a thickness point \[–\].
    pub fn strain_increment(&self) -> f64 {
        self.evaluation.updates.iter().map(|update| update.increment).fold(0.0, f64::max)
    }

    /// The state at the end of the step, at the temperatures of its start.
    pub fn advanced(&self) -> State {
        let Self { step, trial, evaluation, .. } = self;
        let Step { model, state, dt, .. } = **step;
        let points = state.points.iter().zip(evaluation.updates.iter().zip(trial.iterates.iter())).enumerate();
        let points = points.map(|(i, (point, (update, iterate)))| {
            let (carried, back) = match trial.elastoplastic.get(i) {
                None => (iterate.carried, point.back),
                Some(memory) => (update.stress, memory.back),
            };
            MaterialPoint {
                strain: point.strain + update.increment,
                stress: update.stress,
                carried,
                back,
                porosity: point.porosity,
                porosity_rate: point.porosity_rate,
            }
        });
        let nodes = state.nodes.len();
        let strains = state.membrane.iter().zip(&evaluation.membrane_increment);
        let tool_moves = trial.tools.iter().zip(&state.tools);
        let mut next = State {
            time: step.end(),
            travel: step.travel(),
            nodes: evaluation.nodes.clone(),
            velocity: trial.moves.iter().map(|u| u.map(|u| u / dt)).collect(),
            thickness: evaluation.thickness.clone(),
            volume: state.volume.clone(),
            dilation: state.dilation.clone(),
            dilation_rate: state.dilation_rate.clone(),
            temperature: state.temperature.clone(),
            membrane: strains.map(|(total, e)| [total[0] + e[0], total[1] + e[1]]).collect(),
            bends: step.bends.clone(),
            points: Grid::from_values(state.points.columns(), points),
            tools: trial.tools.clone(),
            tool_velocity: tool_moves.map(|(now, before)| (now.y - before.y) / dt).collect(),
            pressure: Grid::from_values(nodes, evaluation.contacts.iter().map(|contact| contact.pressure.value)),
            shift: Grid::from_values(nodes, trial.contacts.iter().map(|memory| memory.shift)),
            gas: trial.gas.clone(),
            s0: state.s0.clone(),
        };
        if let Some(voids) = &model.material.voids {
            porosity::grow(voids, self, &mut next);
        }
        next
    }
}
