//! One case with many settings, on all cores.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::study::{self, Columns, Designs, Plan, Row, Solved, Vary};
use std::convert::Infallible;
use std::thread::available_parallelism;

/// Numbers by their headers, and words by theirs.
type Table<'py> = (Vec<(String, Bound<'py, PyArray1<f64>>)>, Vec<(String, Vec<String>)>);

/// Runs every combination of what is varied: how many values each axis has, what came of the designs in their order, and
/// the exception that cut it short.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub fn sweep<'py>(
    py: Python<'py>,
    case: &Case,
    axes: Vec<String>,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<(Vec<usize>, Table<'py>, Option<PyErr>)> {
    let plan = axes.iter().map(|axis| Vary::together(axis)).collect::<Result<Vec<_>, _>>();
    let plan = plan.and_then(|axes| Plan::of(case.subject()?, axes)).map_err(|error| error::of_study(py, &error))?;
    let threads = threads.or_else(|| available_parallelism().ok().map(usize::from)).unwrap_or(1);
    let indices: Vec<u64> = (0..plan.count()).collect();
    let (rows, raised) = attended(py, progress, |line| {
        let mut rows = Vec::new();
        let Ok(()) = study::run(&plan, &indices, threads, line, |row| {
            rows.push(row);
            Ok::<(), Infallible>(())
        });
        rows
    });
    let shape = plan.axes().iter().map(|axis| axis[0].values.len()).collect();
    Ok((shape, table(py, &plan, &rows), raised))
}

/// What came of the designs, column by column.
fn table<'py>(py: Python<'py>, plan: &Plan, rows: &[Row]) -> Table<'py> {
    let (mut numbers, mut words) = (Vec::new(), Vec::new());
    for (i, header) in plan.headers().into_iter().enumerate() {
        let given = || rows.iter().map(|row| &row.design.values[i]);
        match given().map(|value| value.number).collect::<Option<Vec<f64>>>() {
            Some(values) => numbers.push((header, values.into_pyarray(py))),
            None => words.push((header, given().map(|value| value.text.clone()).collect())),
        }
    }
    let mut headers: Vec<String> = Vec::new();
    for solved in rows.iter().flat_map(|row| &row.result) {
        let new = Columns::of(plan, solved).numbers.into_iter().filter(|header| !headers.contains(header));
        headers.extend(new.collect::<Vec<_>>());
    }
    for header in headers {
        let of = |row: &Row| row.result.as_ref().ok().and_then(|solved| solved.number(&header)).unwrap_or(f64::NAN);
        numbers.push((header.clone(), rows.iter().map(of).collect::<Vec<f64>>().into_pyarray(py)));
    }
    numbers.push(("seconds".into(), rows.iter().map(|row| row.seconds).collect::<Vec<f64>>().into_pyarray(py)));
    let told = |of: fn(&Solved) -> String| {
        rows.iter().map(|row| row.result.as_ref().map_or_else(|_| String::new(), of)).collect::<Vec<_>>()
    };
    words.push(("verdict".into(), told(|solved| solved.light.name().into())));
    words.push(("red".into(), told(|solved| solved.red.join(" "))));
    words.push(("amber".into(), told(|solved| solved.amber.join(" "))));
    let end = |row: &Row| row.result.as_ref().map_or("not run", |solved| solved.outcome.end.kind).to_owned();
    words.push(("end".into(), rows.iter().map(end).collect()));
    words.push(("reason".into(), rows.iter().map(reason).collect()));
    (numbers, words)
}

/// Why a design did not come to its end; else empty.
fn reason(row: &Row) -> String {
    match &row.result {
        Ok(solved) if solved.outcome.end.complete => String::new(),
        Ok(solved) => solved.outcome.end.why.to_string(),
        Err(why) => why.clone(),
    }
}
