//! A step: what is given, and what follows from that alone.
//!
//! ```text
//! Step::new(process, state, Δt)                     everything that the iterations of a step share, computed once
//! Trial::predict(step, ..)                          the unknowns, and what the iterations remember of each other
//! equilibrium::evaluate(step, trial, ..)            the Evaluation, residual and matrix: a function of both
//! retry::solve(step, ..) -> Converged               what a step in equilibrium is
//! Converged::advanced() -> State                    the next state; a step that failed is dropped
//! ```

use super::places::{BeadPlace, Seal};
use super::process::{Process, nodal_areas, references};
use super::selective_bending::rotating;
use crate::element::kinematics::Reference;
use crate::material::Surroundings;
use crate::material::chaboche;
use crate::material::elastoplastic::{Carried, ElastoplasticLaw, Operators};
use crate::material::flow::PointState;
use crate::model::{Iteration, Mode, Model, Settings};
use crate::numerics::Grid;
use crate::state::neighbourhood::Neighbourhood;
use crate::state::{MaterialPoint, State};

/// m of the resistance to flowing faster than the surroundings \[–\]: declared. Sheets with n = 0.02 in elements down to a
/// sixteenth of a thickness do not alternate with it, with less than half of it they do; forces change by 0.02 %.
const EXPONENT: f64 = 0.005;
/// Increment below which rates are not told apart, over the cut-off \[–\].
const FLOOR: f64 = 100.0;

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
    /// Thickness of the section at each element as the step begins \[mm\].
    pub section: Vec<f64>,
    /// Volume of each element at that thickness that the step reckons with \[mm³, or mm² in plane strain\], and its growth in
    /// the step.
    pub volume: Vec<f64>,
    pub growth: Vec<f64>,
    /// Where the model's beads hold the sheet, and where the seals of its gases cut it.
    pub beads: Vec<Option<BeadPlace>>,
    pub seals: Vec<Seal>,
}

impl<'a> Step<'a> {
    /// A step of `dt` \[s\] from `state`, the `number`-th of its run.
    pub fn new(process: &'a Process<'a>, state: &'a State, dt: f64, number: usize) -> Self {
        let model = process.model;
        let process_time = model.process_time(state.time, dt);
        let bends = process.selection.bending(model, state, &process.rule);
        let references: Vec<Reference> = references(model, state, &bends).collect();
        let neighbourhood = Neighbourhood::new(model, state);
        let section = neighbourhood.section_thickness(&state.thickness);
        let (mut volume, growth) = match &model.material.gtn {
            Some(_) => foreseen_volume(state, dt),
            None => (state.volume.clone(), vec![1.0; state.volume.len()]),
        };
        for (volume, (section, thickness)) in volume.iter_mut().zip(section.iter().zip(&state.thickness)) {
            *volume *= section / thickness;
        }
        let around = surroundings(process, state, process_time, &neighbourhood);
        let asks = process.tools.iter().any(|tool| tool.friction.needs_shear_yield());
        let (flow_points, elastoplastic_points) = match model.mode {
            Mode::Flow => (flow_points(process, state, dt, &around, &bends), Grid::default()),
            _ => (Grid::default(), elastoplastic_points(model, state, dt, &around)),
        };
        Self {
            process,
            model,
            state,
            dt,
            process_time,
            number,
            slip_scale: model.settings.slip_speed * model.speed * process_time,
            rotates: rotating(&bends),
            areas: nodal_areas(references.iter().copied(), state.nodes.len()),
            references,
            bends,
            shear_yield: if asks { shear_yield(process, state) } else { vec![0.0; state.nodes.len()] },
            flow_points,
            elastoplastic_points,
            section,
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

/// Volume of each element at the end of a step of `dt` \[s\] \[mm³, or mm² in plane strain\] and its growth \[–\], foreseen
/// from the last rates like the porosity itself: they stay while the corrector goes, and the step is second order in its
/// length.
fn foreseen_volume(state: &State, dt: f64) -> (Vec<f64>, Vec<f64>) {
    let elements = state.volume.iter().zip(state.dilation.iter().zip(&state.dilation_rate));
    let volumes = elements.map(|(volume, (dilation, rate))| {
        let growth = rate * dt;
        (volume * (dilation + growth).exp(), growth.exp())
    });
    volumes.unzip()
}

/// What flows around each thickness point: the mean over its element's neighbourhood of the last rates of the points at the
/// same place in the thickness. What stood still, and elements longer than their neighbourhood, hold nothing back.
fn surroundings(process: &Process, state: &State, time: f64, near: &Neighbourhood) -> Grid<Surroundings> {
    let model = process.model;
    let floor = FLOOR * model.settings.cutoff_strain * time / (Settings::CUTOFF_STEP * model.duration);
    let columns = state.points.columns();
    let of = |e: usize, k: usize| {
        let others = 1.0 - near.own_share(e);
        if others <= 0.0 {
            return Surroundings::default();
        }
        let increment = time * near.mean(e, |other| state.points[(other, k)].strain_rate);
        Surroundings { exponent: EXPONENT * others * increment / (increment + floor), increment, floor }
    };
    let points = (0..state.thickness.len()).flat_map(|e| (0..columns).map(move |k| (e, k)));
    Grid::from_values(columns, points.map(|(e, k)| of(e, k)))
}

/// The flow law's points; of a membrane the mean of its points.
fn flow_points(
    process: &Process,
    state: &State,
    dt: f64,
    around: &Grid<Surroundings>,
    bends: &[bool],
) -> Grid<PointState> {
    let (rule, columns) = (&process.rule, state.points.columns());
    let points = state.points.iter().enumerate().map(|(i, point)| PointState {
        strain: point.strain,
        porosity: match &process.model.material.gtn {
            Some(voids) => voids.foreseen(point.porosity + point.porosity_rate * dt),
            None => 0.0,
        },
        temperature: state.temperature[i / columns],
        surroundings: around[(i / columns, i % columns)],
    });
    let mut points = Grid::from_values(columns, points);
    for (row, _) in points.rows_mut().zip(bends).filter(|(_, bends)| !**bends && columns > 1) {
        let mean = |of: fn(&PointState) -> f64| row.iter().zip(rule).map(|(p, at)| at.weight * of(p)).sum();
        let middle = row[columns / 2];
        row.fill(PointState { strain: mean(|p| p.strain), porosity: mean(|p| p.porosity), ..middle });
    }
    points
}

fn elastoplastic_points(model: &Model, state: &State, dt: f64, around: &Grid<Surroundings>) -> Grid<Carried> {
    let law = elastoplastic_law(model, Iteration::Newton, dt);
    let columns = state.points.columns();
    let points = state.points.iter().enumerate().map(|(i, point)| {
        let temperature = state.temperature[i / columns];
        let MaterialPoint { strain, stress, back, .. } = *point;
        let surroundings = around[(i / columns, i % columns)];
        let carried = Carried { strain, temperature, yield_stress: 0.0, stress, back, surroundings };
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

/// The law of elastoplastic metal in a step of `duration` \[s\].
pub(super) fn elastoplastic_law(model: &Model, matrix: Iteration, duration: f64) -> ElastoplasticLaw<'_> {
    let material = &model.material;
    ElastoplasticLaw {
        hardening: (model.mode == Mode::ElastoViscoplastic).then_some(&material.hardening),
        operators: Operators::new(material.elastic.expect("checked where the model is made"), material.hill48),
        kinematic: chaboche::shifting(material.chaboche),
        rate: material.rate.as_ref(),
        softening: material.thermal.as_ref(),
        secant: matrix == Iteration::Secant,
        duration,
    }
}
