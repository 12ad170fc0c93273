//! Several runs, and what was measured, side by side.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use super::solution::{Solution, header};
use super::study::{Given, Told, form, found, readings, threads, told};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use stampflow::compare::Computed;
use stampflow::output::comparisons;
use stampflow::output::study::json;
use stampflow::output::study::versus::pictures;
use stampflow::study::versus::{Asked, Candidate, Change, Compared, Measured};

/// A number of all runs: header, label, unit; values, half their error bars, differences to the first run; whether these are
/// within the error bars, where that is known.
type NumberParts<'py> = (String, &'static str, &'static str, Vec<Bound<'py, PyArray1<f64>>>, Vec<Option<bool>>);

/// What is told, the numbers, the solutions, and what interrupted them.
type Parts<'py> = (Told<'py>, Vec<NumberParts<'py>>, Vec<Solution>, Option<PyErr>);

/// Runs cases, each with the overrides that it has besides those of its first, and holds them against each other and against
/// measured curves; also their solutions, in order, as far as they came.
#[pyfunction]
pub fn compare<'py>(
    py: Python<'py>,
    cases: Vec<(PyRef<'py, Case>, Vec<String>)>,
    measured: Vec<Given<'py>>,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<Parts<'py>> {
    let mut candidates = Vec::new();
    for (case, own) in &cases {
        let case = case.read().clone();
        comparisons(&case, &Computed::nothing(case.model())).map_err(|error| error::of_reference(py, &error))?;
        candidates.push(Candidate { case, own: own.clone() });
    }
    let read =
        readings(&measured).and_then(|measured| measured.iter().map(Measured::read).collect::<Result<Vec<_>, _>>());
    let asked = read.and_then(|measured| Asked::new(candidates, measured));
    let asked = asked.map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| asked.solve(None, self::threads(threads), line));
    let versus = found(py, result, &mut raised)?;
    if versus.members.is_empty() {
        // Interrupted before any run has ended: there is nothing to compare.
        return Err(raised.unwrap_or_else(|| PyKeyboardInterrupt::new_err(())));
    }
    let drawn = pictures(&versus, false, form()).into_iter().map(|drawn| (drawn.stem, drawn.chart));
    let told = told(py, &json::versus(&versus), versus.legend(), drawn);
    let numbers = versus.compared().into_iter().map(|compared| parts(py, compared)).collect();
    let solutions = versus.members.into_iter().map(|one| Solution::verified(one.solution, Some(one.verification)));
    Ok((told, numbers, solutions.collect(), raised))
}

fn parts(py: Python<'_>, compared: Compared) -> NumberParts<'_> {
    let Compared { number, values, changes } = compared;
    let all = || [Change::None].iter().chain(&changes).copied().collect::<Vec<_>>();
    let or_nan = |values: Vec<Option<f64>>| {
        values.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect::<Vec<_>>().into_pyarray(py)
    };
    let arrays = vec![
        or_nan(values.iter().map(|amount| amount.map(|amount| amount.value)).collect()),
        or_nan(values.iter().map(|amount| amount.and_then(|amount| amount.bar())).collect()),
        or_nan(all().iter().map(Change::value).collect()),
    ];
    let within = all().iter().map(Change::is_within).collect();
    (header(&number), number.label, number.amount.unit.symbol(), arrays, within)
}
