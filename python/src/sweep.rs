//! One case with many settings, on all cores.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use super::rows::{Rows, Table};
use super::study::threads;
use pyo3::prelude::*;
use stampflow::study::{self, Bars, Designs, Plan, StudyError, Vary};
use std::convert::Infallible;

/// So many designs at most: their rows are kept in memory.
const MOST: u64 = 10_000_000;

/// Runs every combination of what is varied: how many values each axis has, what came of the designs in their order, and
/// the exception that cut it short.
#[pyfunction]
pub fn sweep<'py>(
    py: Python<'py>,
    case: &Case,
    axes: Vec<String>,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<(Vec<usize>, Table<'py>, Option<PyErr>)> {
    let plan = plan(case, &axes).map_err(|error| error::of_study(py, &error))?;
    let indices: Vec<u64> = (0..plan.count()).collect();
    let (rows, raised) = attended(py, progress, |line| {
        let mut rows = Rows::of(plan.headers());
        let Ok(()) = study::run(&plan, &indices, self::threads(threads), Bars::Without, line, |row| {
            rows.push(row);
            Ok::<(), Infallible>(())
        });
        rows
    });
    let shape = plan.axes().iter().map(|axis| axis[0].values.len()).collect();
    Ok((shape, rows.table(py), raised))
}

fn plan(case: &Case, axes: &[String]) -> Result<Plan, StudyError> {
    let axes = axes.iter().map(|axis| Vary::together(axis)).collect::<Result<_, _>>()?;
    let plan = Plan::of(case.subject()?, axes)?;
    match plan.count() {
        0..=MOST => Ok(plan),
        count => {
            let help = "fewer values, or the command line in shards".to_owned();
            Err(StudyError::Asked { what: format!("{count} designs are asked for, more than {MOST}"), help })
        }
    }
}
