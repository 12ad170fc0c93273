//! Solver of the flow approach: explicit predictor, implicit corrector.

mod augmented_lagrangian;
mod closing;
mod converged;
mod corrector;
mod course;
mod damage;
mod end_search;
mod energy_balance;
mod equilibrium;
mod evaluation;
mod heat;
mod ironing;
mod line_search;
pub mod mesh;
mod no_equilibrium;
mod observer;
mod remedies;
mod restraints;
mod retry;
mod run_context;
pub mod solution;
mod stages;
pub mod state;
mod step;
mod step_record;
mod tearing_index;
mod termination;
mod terms;
mod time_step;
pub mod trace;
mod trial;

use crate::contact::penalty::Penalty;
use crate::element::{Node, kinematics::Reference, surface::STATIONS, surface::stations};
use crate::geometry::{Point, turned};
use crate::material::{Material, flow::ROOM_TEMPERATURE, flow::Triple};
use crate::model::{
    Edge, Geometry, Iteration, Mode, Model, Motion, Norm, Pressure, Role, Settings, Stage, Theory, Tool,
};
use crate::numerics::{Grid, ValueAndSlope, bisect, block_tridiagonal::System, quadrature::ThicknessPoint};
use crate::solver::solution::{Effort, Heat, IterationRecord, StepRecord};
use crate::solver::state::{MaterialPoint, State, waiting_displacement};
use converged::Converged;
use corrector::Outcome;
use evaluation::Evaluation;
use nalgebra::Vector3;
use run_context::RunContext;
use solution::{StageSolution, Stop, StopKind};
use step::Step;
use trial::Trial;

pub use closing::closing_way;
pub use observer::{Iterate, IterateContact, IterateSnapshot, Observer};
pub use remedies::{Remedy, run_from};
pub use retry::{Start, try_step};
pub use stages::{enter, run, solve};

fn advance(before: &Evaluation, converged: &Converged, rejected: usize, last: &StepRecord) -> (State, StepRecord) {
    let Converged { step, .. } = converged;
    let times = step.model.extent().times();
    let (work, plastic) = energy_balance::work(before, converged);
    let mut next = converged.advanced();
    let mut record = step_record::record(converged, before, &next, rejected);
    ironing::add(converged, &mut next, &mut record);
    tearing_index::add(converged, &mut next, &mut record);
    if step.model.material.gtn.is_some() {
        (record.porosity, record.porous_s0) = next.largest_porosity(&step.context.rule);
    }
    if step.model.material.fracture.is_some() {
        (record.damage, record.damage_s0) = next.largest_damage(&step.context.rule);
    }
    let heat = heat::advance(converged, &plastic, &mut next).unwrap_or_default();
    record.power = work.scaled(1.0 / step.dt).scaled(times);
    record.work = last.work.combined(work.scaled(times), |before, added| before + added);
    record.heat = Heat {
        plastic: last.heat.plastic + times * heat.plastic,
        tools: last.heat.tools + times * heat.tools,
        stored: last.heat.stored + times * heat.stored,
    };
    (record.coldest, record.hottest) = next.temperatures();
    (next, record)
}
