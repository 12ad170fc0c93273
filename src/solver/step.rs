//! Start of a step: what all its iterations share.

use super::{restraints::BeadPosition, run_context::references, *};
use crate::element::surface::Station;
use crate::material::elastoplastic::{Carried, ElastoplasticLaw, Operators};
use crate::material::{Surroundings, chaboche::shifting, flow::PointState};
use crate::solver::state::nonlocal_average::NonlocalAverage;

/// Exponent m of the resistance to flowing faster than the surroundings \[–\]: half of it lets sheets with n = 0.02 alternate.
const EXPONENT: f64 = 0.005;
/// Floor of increments over the cut-off \[–\].
const FLOOR: f64 = 100.0;
/// Progress of a stage over which the forces of the tools before fade \[–\]; those of a release fade over all of it.
pub(super) const FADING: f64 = 0.02;
/// Strain increment of a cut-off point over the cut-off \[–\].
pub(super) const CUT_OFF_ZONE: f64 = 10.0;

pub(super) struct Step<'a> {
    pub context: &'a RunContext<'a>,
    pub model: &'a Model,
    pub state: &'a State,
    /// Clock and process time \[s\].
    pub dt: f64,
    pub process_time: f64,
    pub number: usize,
    /// Punch speed over that of the step before \[–\].
    pub speed_ratio: f64,
    /// Regularisation of the slip \[mm\].
    pub slip_scale: f64,
    pub references: Vec<Reference>,
    /// Area of each contact point \[mm², or mm per mm of depth\].
    pub areas: Vec<f64>,
    /// Half the thickness difference between an element's ends at the start \[mm\]; keeps faces continuous.
    pub half_thickness_difference: Vec<f64>,
    /// Areas of the lower and upper face over that of the mid-surface at the start \[–\].
    pub faces: Vec<[f64; 2]>,
    /// Shear yield stress of the elements \[MPa\].
    pub shear_yield: Vec<f64>,
    /// Points of the flow law or of the elastoplastic law; the other is empty.
    pub flow_points: Grid<PointState>,
    pub elastoplastic_points: Grid<Carried>,
    /// Section thickness of each element at the start \[mm\].
    pub section: Vec<f64>,
    /// Volume of each element at that thickness \[mm³, or mm² in plane strain\], and its growth in the step.
    pub volume: Vec<f64>,
    pub growth: Vec<f64>,
    pub beads: Vec<Option<BeadPosition>>,
}

impl<'a> Step<'a> {
    /// Prepares the `number`-th step of a run, `dt` \[s\] from `state`.
    pub fn new(context: &'a RunContext<'a>, state: &'a State, dt: f64, number: usize) -> Self {
        let model = context.model;
        let process_time = model.process_time(state.time, dt);
        let references: Vec<Reference> = references(model, state).collect();
        let neighbourhood = NonlocalAverage::new(model, state);
        let section = neighbourhood.means(|e| state.thickness[e]);
        // Voids grow on at their last rate.
        let voids = |exponent: f64| if model.material.gtn.is_some() { exponent.exp() } else { 1.0 };
        let growth: Vec<f64> = state.dilation_rate.iter().map(|rate| voids(rate * dt)).collect();
        let volume = |e: usize| {
            state.volume[e] * voids(state.dilation[e] + state.dilation_rate[e] * dt) * (section[e] / state.thickness[e])
        };
        let volume = (0..growth.len()).map(volume).collect();
        let around = surroundings(context, state, process_time, &neighbourhood);
        let before = model.schedule.as_ref().map_or(0.0, |schedule| schedule.slope_before(state.time));
        let speed_ratio =
            if before > 0.0 { (model.travel_at(state.time + dt) - state.travel) / (before * dt) } else { 1.0 };
        // v₀ of friction is a share of the process speed, which is at least one thickness per run.
        let least_speed = model.speed.max(model.blank.thickness / model.duration);
        let (flow_points, elastoplastic_points) = match model.mode {
            Mode::Flow => (flow_points(context, state, dt, speed_ratio, &around), Grid::from_values(0, [])),
            _ => (Grid::from_values(0, []), elastoplastic_points(context, state, dt, &around)),
        };
        Self {
            context,
            model,
            state,
            dt,
            process_time,
            number,
            speed_ratio,
            slip_scale: model.settings.slip_speed * least_speed * process_time,
            areas: references.iter().flat_map(Reference::contact_areas).collect(),
            half_thickness_difference: half_thickness_difference(&references, &state.thickness),
            faces: faces(&references, state),
            references,
            shear_yield: shear_yield(context, state),
            flow_points,
            elastoplastic_points,
            section,
            volume,
            growth,
            beads: model.beads.iter().map(|bead| BeadPosition::find(bead, model, state)).collect(),
        }
    }

    pub fn stations(&self) -> &'static [Station; STATIONS] {
        stations(self.model.blank.theory == Theory::Bending)
    }

    /// Share of the forces of removed tools that is left at a time \[–\].
    pub fn unloading_left(&self, time: f64) -> f64 {
        (1.0 - time / ((if self.model.release.is_some() { 1.0 } else { FADING }) * self.model.duration)).max(0.0)
    }

    /// Cut-off Δε₀ of the step times `softening` \[–\].
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
}

/// Flow around each thickness point: nonlocal mean of the last rates of the points at the same depth.
fn surroundings(context: &RunContext, state: &State, time: f64, near: &NonlocalAverage) -> Grid<Surroundings> {
    let model = context.model;
    let floor = FLOOR * model.settings.cutoff_strain * time / (Settings::CUTOFF_STEP * model.duration);
    let mut around = Grid::new(state.thickness.len(), state.points.columns(), Surroundings::default());
    for k in 0..state.points.columns() {
        for (e, rate) in near.means(|e| state.points[(e, k)].equivalent_rate).into_iter().enumerate() {
            let others = 1.0 - near.own_share(e);
            if others > 0.0 {
                let increment = time * rate;
                let exponent = EXPONENT * others * increment / (increment + floor);
                around[(e, k)] = Surroundings { exponent, increment, floor };
            }
        }
    }
    around
}

fn flow_points(context: &RunContext, state: &State, dt: f64, ratio: f64, around: &[Surroundings]) -> Grid<PointState> {
    let (rule, columns) = (&context.rule, state.points.columns());
    let (voids, criterion) = (context.model.material.gtn.as_ref(), context.model.material.yield_criterion);
    let temperatures: Vec<f64> = (0..state.thickness.len()).map(|e| state.foreseen_temperature(e, dt)).collect();
    let point_states = state.points.iter().zip(around.iter()).enumerate().map(|(i, (point, around))| PointState {
        porosity: voids.map_or(0.0, |voids| voids.foreseen(point.porosity + point.porosity_rate * dt)),
        temperature: temperatures[i / columns],
        surroundings: *around,
        ..PointState::at(point.strain)
    });
    let mut points = Grid::from_values(columns, point_states);
    for (e, row) in points.rows_mut().enumerate() {
        if state.steady[e] {
            let weight = dt / (dt + state.last_step / ratio);
            let lasts = state.points.row(e);
            let expected = |rate: Triple| rate.map(|rate| ratio * rate * dt);
            let (first, last) = (expected(lasts[0].strain_rate), expected(lasts[columns - 1].strain_rate));
            let height = rule[columns - 1].xi - rule[0].xi;
            for ((point, before), at) in row.iter_mut().zip(lasts).zip(rule) {
                let spread = [0, 1].map(|d| if height > 0.0 { at.half * (last[d] - first[d]) / height } else { 0.0 });
                *point = point.following(expected(before.strain_rate), spread, weight, criterion, voids);
            }
        }
    }
    points
}

fn elastoplastic_points(context: &RunContext, state: &State, dt: f64, around: &Grid<Surroundings>) -> Grid<Carried> {
    let model = context.model;
    let elastic = model.elasticity().expect("checked where the model is made");
    let columns = state.points.columns();
    let points = context.metals.iter().flat_map(|metal| {
        let law = elastoplastic_law(model, metal.material, Iteration::Newton, dt);
        metal.elements.clone().flat_map(|e| (0..columns).map(move |k| (e, k))).map(move |at| {
            let temperature = state.foreseen_temperature(at.0, dt);
            let MaterialPoint { strain, stress, back, .. } = state.points[at];
            let dilation = elastic.volume_strain(stress).exp_m1();
            let surroundings = around[at];
            let carried = Carried { strain, temperature, yield_stress: 0.0, stress, dilation, back, surroundings };
            Carried { yield_stress: law.yield_stress(&carried), ..carried }
        })
    });
    Grid::from_values(columns, points)
}

/// Half the thickness difference between each element's ends, by its neighbours' thicknesses \[mm\].
pub(super) fn half_thickness_difference(references: &[Reference], thickness: &[f64]) -> Vec<f64> {
    let last = thickness.len() - 1;
    let along = |e: usize| {
        let (before, after) = (e.max(1) - 1, (e + 1).min(last));
        let apart: f64 = (before..after).map(|i| 0.5 * (references[i].length + references[i + 1].length)).sum();
        0.5 * (if apart > 0.0 { (thickness[after] - thickness[before]) / apart } else { 0.0 }) * references[e].length
    };
    (0..=last).map(along).collect()
}

fn faces(references: &[Reference], state: &State) -> Vec<[f64; 2]> {
    let face = |(e, reference): (usize, &Reference)| {
        reference.faces(state.nodes[e + 1][2] - state.nodes[e][2], state.thickness[e])
    };
    references.iter().enumerate().map(face).collect()
}

/// Shear yield stress σ_y/√3 at the mean strain of each element \[MPa\].
fn shear_yield(context: &RunContext, state: &State) -> Vec<f64> {
    let of_element = |(e, points): (usize, &[MaterialPoint])| {
        let strain: f64 = points.iter().zip(&context.rule).map(|(p, at)| at.weight * p.strain).sum();
        context.metal(e).material.yield_stress(strain, state.temperature[e]) / 3f64.sqrt()
    };
    state.points.rows().enumerate().map(of_element).collect()
}

/// Elastoplastic law of a step of `duration` \[s\].
pub(super) fn elastoplastic_law<'a>(
    model: &Model, material: &'a Material, matrix: Iteration, duration: f64,
) -> ElastoplasticLaw<'a> {
    let Material { hardening, rate, thermal, yield_criterion, chaboche, .. } = material;
    let hardening = (model.mode == Mode::ElastoViscoplastic).then_some(hardening);
    let elastic = model.elasticity().expect("checked where the model is made");
    let (operators, kinematic) = (Operators::new(elastic, *yield_criterion), shifting(*chaboche));
    let (rate, softening, secant) = (rate.as_ref(), thermal.as_ref(), matrix == Iteration::Secant);
    ElastoplasticLaw { hardening, operators, kinematic, rate, softening, secant, duration }
}
