//! One step of a run, iteration by iteration.

use super::case::Case;
use super::interruptible::{Progress, Stages, interruptible};
use super::table::{Column, columns, field};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use stampflow::Table;
use stampflow::material::flow::PointSnapshot;
use stampflow::model::{Iteration, Mode, Model};
use stampflow::results::tables::iteration_table;
use stampflow::solver::IterateSnapshot;
use stampflow::solver::trace::{IterationHistory, TraceRequest, trace as trace_step};
use stampflow::table::Unit;

/// Nodes, elements and contact points of an iterate.
type IterateParts<'py> = [Vec<Column<'py>>; 3];
/// Matrix, whether it converged, order of convergence, iterations of all tries, start of each, and iterates.
type HistoryParts<'py> = (&'static str, bool, Option<f64>, Vec<Column<'py>>, Vec<&'static str>, Vec<IterateParts<'py>>);
/// Travel \[mm\], duration \[s\], tolerance, and a history per matrix.
type TraceParts<'py> = (f64, f64, f64, Vec<HistoryParts<'py>>);

/// Repeats a step, stage and number from 1, with each matrix: `all`, or their names; none for the case's own.
#[pyfunction]
pub fn trace<'py>(
    py: Python<'py>, case: PyRef<'py, Case>, place: (usize, usize), matrices: Vec<String>, tolerance: Option<f64>,
    progress: Progress,
) -> PyResult<TraceParts<'py>> {
    let known = Iteration::ALL.map(Iteration::key);
    if let Some(name) = matrices.iter().find(|name| *name != "all" && !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(PyValueError::new_err(format!("there is no matrix {name}; there are {known}, and all")));
    }
    let is_wanted = |matrix: &Iteration| matrices.iter().any(|name| name == "all" || name == matrix.key());
    let (stage, step) = place;
    let request =
        TraceRequest { stage, step, matrices: Iteration::ALL.into_iter().filter(is_wanted).collect(), tolerance };
    let stages = &case.inner().stages;
    let (traced, raised) =
        interruptible(py, progress, |line| trace_step(stages, &request, &mut Stages::new(line, stages.len())));
    raised.map_or(Ok(()), Err)?;
    let traced = traced.map_err(|error| PyIndexError::new_err(error.to_string()))?;
    let model = &stages[traced.stage - 1].model;
    let histories = traced.histories.iter().map(|history| parts(py, model, history));
    Ok((traced.record.travel, traced.dt, traced.tolerance, histories.collect()))
}

fn parts<'py>(py: Python<'py>, model: &Model, history: &IterationHistory) -> HistoryParts<'py> {
    let iterates = history.iterates.iter().map(|iterate| tables(model, iterate).map(|table| columns(py, table)));
    let starts = history.rows.iter().map(|row| row.start.key()).collect();
    let order = history.rate().and_then(|rate| rate.order);
    let rows = columns(py, iteration_table(history.rows.iter()));
    (history.matrix.key(), history.end.is_some(), order, rows, starts, iterates.collect())
}

/// Nodes, elements and contact points.
fn tables(model: &Model, iterate: &IterateSnapshot) -> [Table; 3] {
    let IterateSnapshot { nodes, imbalance, points, cut_off, contacts, .. } = iterate;
    let larger = |a: &&PointSnapshot, b: &&PointSnapshot| a.equivalent_increment.total_cmp(&b.equivalent_increment);
    let most: Vec<&PointSnapshot> = points.iter().filter_map(|points| points.iter().max_by(larger)).collect();
    let (times, force) = (model.extent().times(), model.extent().force_unit());
    let flag = |is_set: bool| f64::from(u8::from(is_set));
    let viscosity = (model.mode == Mode::Flow).then(|| {
        field("viscosity_MPa_s", "Viscosity there", Unit::None, &most, |point| point.viscosity.unwrap_or(f64::NAN))
    });
    let nodes = vec![
        field("r", "Distance from the axis", Unit::Mm, nodes, |node| node[0]),
        field("z", "z, along the axis", Unit::Mm, nodes, |node| node[1]),
        field("theta", "Rotation of the fibre", Unit::None, nodes, |node| node[2]),
        field("imbalance_r", "Force out of balance along r", force, imbalance, |forces| times * forces[0]),
        field("imbalance_z", "Force out of balance along z", force, imbalance, |forces| times * forces[1]),
    ];
    let elements = [
        field("strain_increment", "Largest equivalent strain increment", Unit::None, &most, |point| {
            point.equivalent_increment
        }),
        field("yield_stress", "Yield stress there", Unit::MPa, &most, |point| point.yield_stress),
        field("strain_equivalent", "Equivalent strain there", Unit::None, &most, |point| point.equivalent_strain),
        field("stress_meridional", "Meridional stress there", Unit::MPa, &most, |point| point.stress[0]),
        field("stress_hoop", "Hoop stress there", Unit::MPa, &most, |point| point.stress[1]),
        field("cut_off", "Strains by less than ten cut-offs", Unit::None, cut_off, |is_cut_off| flag(*is_cut_off)),
    ];
    let contacts = vec![
        field("r", "Distance from the axis", Unit::Mm, contacts, |at| at.position[0]),
        field("z", "z, along the axis", Unit::Mm, contacts, |at| at.position[1]),
        field("force_r", "Force on the sheet along r", force, contacts, |at| times * at.force[0]),
        field("force_z", "Force on the sheet along z", force, contacts, |at| times * at.force[1]),
        field("sticks", "Sticks", Unit::None, contacts, |at| flag(at.sticks)),
    ];
    [nodes, elements.into_iter().chain(viscosity).collect(), contacts].map(Table::new)
}
