//! Solved cases.

use super::error;
use super::interruptible::{Progress, interruptible};
use super::table::{Column, Picture, columns, json, picture};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use serde::Serialize;
use stampflow::Table;
use stampflow::assess::error_bars::ErrorBars;
use stampflow::assess::{Answer, Finding, judgements};
use stampflow::report::Report;
use stampflow::results::{self, CaseSummary, Make, OUTPUTS, Output, Results, tables};
use stampflow::solver::solution::NodeRecord;
use stampflow::study::{judge, verify};
use stampflow::table::{Column as NamedColumn, Unit};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

/// A solved case, with error bars once it was verified.
#[pyclass(frozen, module = "stampflow._native")]
pub struct Solution {
    solution: Arc<stampflow::Solution>,
    bars: Option<ErrorBars>,
    verdict: OnceLock<(Answer, Vec<Finding>)>,
}

#[derive(Serialize)]
struct StageFacts<'a> {
    name: &'a str,
    stop: &'static str,
    why: String,
    complete: bool,
    iterations: usize,
    frames: usize,
}

#[derive(Serialize)]
struct Verdict<'a> {
    #[serde(flatten)]
    answer: &'a Answer,
    findings: Vec<&'a Finding>,
}

/// Time [s], travel [mm], elements and nodes.
type FrameParts<'py> = (f64, f64, Vec<Column<'py>>, Vec<Column<'py>>);

/// Name with unit, label, value, printed unit, error bar, printed form.
type NumberParts = (String, &'static str, f64, &'static str, Option<f64>, String);

#[pymethods]
impl Solution {
    #[getter]
    fn complete(&self) -> bool {
        self.solution.is_complete()
    }

    /// Stages that were run, as JSON.
    fn stages(&self) -> PyResult<String> {
        let stages = self.solution.case.stages.iter().zip(&self.solution.stages);
        let facts = stages.map(|(stage, solved)| StageFacts {
            name: &stage.name,
            stop: solved.stop.kind.name(),
            why: solved.stop.to_string(),
            complete: solved.stop.is_complete(),
            iterations: solved.steps.iter().map(|step| step.iterations).sum(),
            frames: solved.frames.len(),
        });
        json(&facts.collect::<Vec<_>>())
    }

    /// A frame of a stage.
    fn frame<'py>(&self, py: Python<'py>, stage: usize, frame: usize) -> PyResult<FrameParts<'py>> {
        let none = || PyIndexError::new_err("no such frame");
        let solved = self.solution.stages.get(stage).ok_or_else(none)?;
        let kept = solved.frames.get(frame..=frame).ok_or_else(none)?;
        let mut elements = tables::profile(&solved.model, kept);
        elements.columns.remove(0);
        let column = |key, label, unit, value: fn(&NodeRecord) -> f64| {
            NamedColumn::new(key, label, unit, kept[0].nodes.iter().map(value).collect())
        };
        let nodes = Table::new(vec![
            column("r", "Distance from the axis", Unit::Mm, |node| node.r),
            column("z", "z, along punch travel", Unit::Mm, |node| node.z),
            column("theta", "Rotation of the fibre", Unit::None, |node| node.theta),
            column("thickness", "Thickness", Unit::Mm, |node| node.thickness),
        ]);
        Ok((kept[0].time, kept[0].travel, columns(py, elements), columns(py, nodes)))
    }

    /// A table of a stage by the name of its file; `None` if the stage has none.
    fn table<'py>(&self, py: Python<'py>, stage: usize, file: &str) -> PyResult<Option<Vec<Column<'py>>>> {
        let Make::Table(make) = output(file)?.make else { return Err(unknown(file)) };
        let table = py.detach(|| self.solution.views().get(stage).and_then(make));
        Ok(table.map(|table| columns(py, table)))
    }

    /// Names of all pictures.
    fn pictures(&self) -> Vec<&'static str> {
        let plots = OUTPUTS.iter().filter(|output| matches!(output.make, Make::Plot(_)));
        plots.filter_map(|output| output.file.strip_suffix(".png")).collect()
    }

    /// A picture of a stage by its name; `None` if there is nothing to draw.
    fn picture(&self, py: Python<'_>, stage: usize, name: &str) -> PyResult<Option<Picture>> {
        let Make::Plot(make) = output(&format!("{name}.png"))?.make else { return Err(unknown(name)) };
        let results = self.results(py)?;
        results.views.get(stage).and_then(make).map(|chart| picture(&chart)).transpose()
    }

    /// Contents of `summary.json`; with several stages a list of them.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        json(&CaseSummary::of(&self.solution, &self.results(py)?.views))
    }

    /// Light, sentence and rows of the verdict, as JSON.
    fn verdict(&self, py: Python<'_>) -> PyResult<String> {
        let (answer, findings) = self.judged(py);
        json(&Verdict { answer, findings: judgements(findings).collect() })
    }

    /// Numbers of the part.
    fn numbers(&self, py: Python<'_>) -> Vec<NumberParts> {
        let numbers = self.judged(py).0.numbers.iter();
        let parts = numbers.map(|number| {
            let amount = number.amount;
            (
                amount.unit.keyed(number.key),
                number.label,
                amount.value,
                amount.unit.symbol(),
                amount.bar,
                amount.to_string(),
            )
        });
        parts.collect()
    }

    /// Adds error bars from finer runs; returns also the exception that cut it short.
    fn verify(&self, py: Python<'_>, progress: Progress) -> (Self, Option<PyErr>) {
        let (verified, raised) = interruptible(py, progress, |line| verify::verify(&self.solution, line));
        let solution = Arc::clone(&self.solution);
        (Self { solution, bars: Some(verified.bars), verdict: OnceLock::new() }, raised)
    }

    /// Writes every table and plot into a folder, as `run --out` does; returns the files.
    fn write(&self, py: Python<'_>, folder: String) -> PyResult<Vec<String>> {
        let files = py.detach(|| self.solution.write(&folder)).map_err(|error| error::output(&error))?;
        Ok(files.iter().map(|file| file.to_string_lossy().into_owned()).collect())
    }

    /// Writes the HTML report.
    fn report(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let verdict = self.judged(py).clone();
        let html = py.detach(|| Report::answered(&self.solution, self.bars.as_ref(), verdict).html());
        results::write(&path, html.as_bytes()).map_err(|error| error::output(&error))
    }
}

impl Solution {
    /// A solution without error bars.
    pub fn new(solution: stampflow::Solution) -> Self {
        Self { solution: Arc::new(solution), bars: None, verdict: OnceLock::new() }
    }

    fn judged(&self, py: Python<'_>) -> &(Answer, Vec<Finding>) {
        py.detach(|| self.verdict.get_or_init(|| judge(&self.solution, self.bars.as_ref(), true, &())))
    }

    fn results(&self, py: Python<'_>) -> PyResult<Results<'_>> {
        let results = py.detach(|| Results::of(&self.solution)).map_err(|error| error::reference(py, &error))?;
        Ok(results.verified(self.bars.as_ref()))
    }
}

fn output(file: &str) -> PyResult<&'static Output> {
    OUTPUTS.iter().find(|output| output.file == file).ok_or_else(|| unknown(file))
}

fn unknown(file: &str) -> PyErr {
    PyValueError::new_err(format!("there is no output {file}"))
}
