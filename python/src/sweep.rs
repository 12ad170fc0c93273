//! One case with many settings, on all cores.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use super::rows::{Rows, Table};
use super::study::{Told, form, found, threads, told};
use pyo3::prelude::*;
use serde_json::Value;
use stampflow::output::study::pictures;
use stampflow::study::{self, Bars, Columns, Designs, Plan, Results, Said, StudyError, Vary};
use std::convert::Infallible;

/// So many designs at most: their rows are kept in memory.
const MOST: u64 = 10_000_000;

/// So many designs at most are told and drawn: more are no picture, and their lines would fill the memory.
const TOLD: u64 = 100_000;

/// How many values each axis has, what is said of a sweep that is whole, what came of the designs in their order, and the
/// exception that cut it short.
type Swept<'py> = (Vec<usize>, Option<Told<'py>>, Table<'py>, Option<PyErr>);

/// Runs every combination of what is varied.
#[pyfunction]
pub fn sweep<'py>(
    py: Python<'py>,
    case: &Case,
    axes: Vec<String>,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<Swept<'py>> {
    let plan = plan(case, &axes).map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| {
        let base = study::base(plan.subject(), Bars::Without, line)?;
        let (columns, indices) = (Columns::of(&plan, &base), (0..plan.count()).collect::<Vec<u64>>());
        let (mut rows, mut lines) = (Rows::of(plan.headers()), Vec::new());
        let Ok(()) = study::run(&plan, &indices, self::threads(threads), Bars::Without, line, |row| {
            lines.extend((plan.count() <= TOLD).then(|| columns.line(&plan, &row)));
            rows.push(row);
            Ok::<(), Infallible>(())
        });
        // What is said is said of the table, as on the command line: of its digits.
        let table = (lines.len() == indices.len()).then(|| study::csv(&columns.header(), &lines));
        Ok::<_, StudyError>((base, rows, table))
    });
    let (base, rows, table) = found(py, result, &mut raised)?;
    let results = table.map(|table| Results::of(&table[..], "the sweep", &plan, &base)).transpose();
    let results = results.map_err(|error| error::of_study(py, &error))?;
    let said = results.map(|results| {
        let sentences = Said::of(&results).sentences(&results);
        told(py, &Value::Null, sentences, pictures(&results, &case.read().model().title, form()))
    });
    let shape = plan.axes().iter().map(|axis| axis[0].values.len()).collect();
    Ok((shape, said, rows.table(py), raised))
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
