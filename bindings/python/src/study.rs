//! Studies: one function for all kinds, and comparisons.

use super::interruptible::{Progress, interruptible, pooled};
use super::table::{Picture, json, picture};
use super::{case::Case, error};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Deserialize;
use stampflow::study::Watch;
use stampflow::study::compare::{Candidate, SideBySide, check, variant};
use stampflow::study::fit::{CaseFitRequest, Reduction, fit_case, fit_laws, flow_curves};
use stampflow::study::{
    BaseCase, EarlierRuns, Evaluation, LimitSearch, RunTable, Scatter, SearchRequest, Shard, Side, Study, StudyError,
    StudyReport, Sweep, begin, evaluate, measured_curve,
};
use std::{collections::BTreeMap, ops::ControlFlow, path::PathBuf, thread::available_parallelism};

/// Report as JSON, header and rows of the run table, and pictures by name.
type Columns = (Vec<String>, Vec<Vec<String>>);
type Pictures = BTreeMap<String, Picture>;
type Results = (String, Columns, Pictures);

/// Request of any kind of study.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(default)]
    vary: Vec<String>,
    #[serde(default)]
    one_at_a_time: bool,
    runs: Option<u64>,
    seed: Option<u32>,
    goal: Option<String>,
    side: Option<String>,
    condition: Option<String>,
    target: Option<String>,
    tolerance: Option<String>,
    #[serde(default)]
    to: Vec<PathBuf>,
    threads: Option<usize>,
}

fn threads(given: Option<usize>) -> usize {
    given.or_else(|| available_parallelism().ok().map(usize::from)).unwrap_or(1)
}

/// Runs a study of a case: `sweep`, `search`, `scatter` or `fit`.
#[pyfunction]
pub fn study(
    py: Python<'_>, kind: &str, case: PyRef<'_, Case>, request: &str, progress: Progress,
) -> PyResult<(String, Columns, Pictures, Option<PyErr>)> {
    let request: Request = serde_json::from_str(request).map_err(|error| PyValueError::new_err(error.to_string()))?;
    let base = case.base().map_err(|error| error::study(py, &error))?;
    let (result, mut raised) = interruptible(py, progress, |line| pooled(|| run(kind, base, request, line)));
    let (report, runs) = result.map_err(|error| raised.take().unwrap_or_else(|| error::study(py, &error)))?;
    let (report, runs, pictures) = results(&report, runs)?;
    Ok((report, runs, pictures, raised))
}

fn run(
    kind: &str, base: BaseCase, request: Request, watch: &(dyn Watch + Sync),
) -> Result<(StudyReport, Option<RunTable>), StudyError> {
    let Request { vary, one_at_a_time, runs, seed, goal, side, condition, target, tolerance, to, threads: count } =
        request;
    let threads = threads(count);
    let mut study: Box<dyn Study> = match kind {
        "sweep" => Box::new(Sweep::new(base, &vary, one_at_a_time)?),
        "scatter" => Box::new(Scatter::new(base, &vary, runs.unwrap_or(256), seed.unwrap_or(1))?),
        "search" => {
            let side = side.map(|side| if side == "smallest" { Side::Smallest } else { Side::Largest });
            let vary = vary.into_iter().next();
            Box::new(LimitSearch::new(base, &SearchRequest { vary, goal, side, condition, target, tolerance })?)
        }
        _ => {
            let fit = fit_case(&CaseFitRequest::new(base, &vary, &to)?, threads, watch)?;
            return Ok((fit.report, None));
        }
    };
    let settings = Evaluation { threads, shard: Shard::WHOLE, watch };
    let runs = begin(&mut *study, &settings)?;
    let runs = evaluate(&mut *study, &settings, runs, &EarlierRuns::new(), &mut |_, _| ControlFlow::Continue(()));
    Ok((study.report(&runs), Some(runs)))
}

/// Fits hardening laws to tension tests.
#[pyfunction]
pub fn fit_law(py: Python<'_>, files: Vec<PathBuf>) -> PyResult<Results> {
    let (fits, raised) = interruptible(py, None, |line| {
        let curves = flow_curves(&files, &Reduction::default(), &[], &[], line)?;
        fit_laws(curves, None, line)
    });
    match raised {
        Some(raised) => Err(raised),
        None => results(&fits.map_err(|error| error::study(py, &error))?.report(), None),
    }
}

/// Compares cases, variants of the first and measured curves.
#[pyfunction]
pub fn compare(
    py: Python<'_>, cases: Vec<PyRef<'_, Case>>, also: Vec<String>, curves: Vec<PathBuf>,
) -> PyResult<Results> {
    let wrong = |error: StudyError| error::study(py, &error);
    let mut candidates = Vec::new();
    for (i, case) in cases.iter().enumerate() {
        candidates.push(Candidate { case: case.inner().clone(), overrides: Vec::new() });
        for text in also.iter().filter(|_| i == 0) {
            let overrides = variant(text).map_err(wrong)?;
            let varied = case.base().and_then(|base| Ok(base.case(&overrides)?)).map_err(wrong)?;
            candidates.push(Candidate { case: varied, overrides });
        }
    }
    let curves = curves.into_iter().map(|path| measured_curve(&path));
    let curves = curves.collect::<Result<Vec<_>, _>>().map_err(wrong)?;
    check(&candidates, &curves).map_err(wrong)?;
    let (all, raised) =
        interruptible(py, None, |line| SideBySide::solve(&candidates, curves, None, threads(None), line));
    match raised {
        Some(raised) => Err(raised),
        None => results(&all.map_err(wrong)?.report(), None),
    }
}

fn results(report: &StudyReport, runs: Option<RunTable>) -> PyResult<Results> {
    let stem = |file: &str| file.split('.').next().unwrap_or(file).to_owned();
    let pictures = report.charts.iter().map(|(name, chart)| Ok((stem(name), picture(chart)?)));
    let rows = runs.map(|runs| (runs.header(), runs.runs.iter().map(|run| runs.line(run)).collect()));
    Ok((json(report)?, rows.unwrap_or_default(), pictures.collect::<PyResult<_>>()?))
}
