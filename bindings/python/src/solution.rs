//! Solved cases.

use super::error;
use super::interruptible::{Progress, interruptible, pooled};
use super::table::{Column, Picture, columns, field, json, picture};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use serde::Serialize;
use stampflow::Table;
use stampflow::assess::{Answer, Finding, error_bars::ErrorBars, judgements};
use stampflow::export::{Drawing, Format};
use stampflow::geometry::Point;
use stampflow::model::Model;
use stampflow::report::Report;
use stampflow::results::{self, Make, OUTPUTS, Output, Results, Summary, tables};
use stampflow::study::{judge, verify};
use stampflow::table::Unit;
use stampflow::units::{Amount, Quantity};
use std::sync::{Arc, OnceLock};
use std::{collections::BTreeMap, path::PathBuf};

/// Angle of a chord in the outline of a tool \[rad\].
const ARC: f64 = 0.03;

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

/// Columns of each tool by its name.
type Outlines<'py> = BTreeMap<&'static str, Vec<Column<'py>>>;

/// Time [s], travel [mm], elements, nodes and tools.
type FrameParts<'py> = (f64, f64, Vec<Column<'py>>, Vec<Column<'py>>, Outlines<'py>);

/// Name with unit, label, value, printed unit, error bar, printed form.
type NumberParts = (String, String, f64, &'static str, Option<f64>, String);

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
        let nodes = &kept[0].nodes;
        let nodes = Table::new(vec![
            field("r", "Distance from the axis", Unit::Mm, nodes, |node| node.r),
            field("z", "z, along the axis", Unit::Mm, nodes, |node| node.z),
            field("theta", "Rotation of the fibre", Unit::None, nodes, |node| node.theta),
            field("thickness", "Thickness", Unit::Mm, nodes, |node| node.thickness),
        ]);
        let tools = outlines(py, &solved.model, &kept[0].tool_displacement);
        Ok((kept[0].time, kept[0].travel, columns(py, elements), columns(py, nodes), tools))
    }

    /// Outlines of the tools of a stage as drawn.
    fn tools<'py>(&self, py: Python<'py>, stage: usize) -> PyResult<Outlines<'py>> {
        let solved = self.solution.stages.get(stage).ok_or_else(|| PyIndexError::new_err("no such stage"))?;
        Ok(outlines(py, &solved.model, &[]))
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

    /// Light, sentence and rows of the verdict, as JSON.
    fn verdict(&self, py: Python<'_>) -> PyResult<String> {
        let (answer, findings) = self.judged(py);
        json(&Verdict { answer, findings: judgements(findings).collect() })
    }

    /// Numbers of the part, then those of the last stage's summary.
    fn numbers(&self, py: Python<'_>) -> PyResult<Vec<NumberParts>> {
        // Judging, which solves more runs, adds their error bars only.
        let of_part = match self.bars {
            None => Answer::of(&self.solution.case, &self.solution.stages, &[]).numbers,
            Some(_) => self.judged(py).0.numbers.clone(),
        };
        let summary = self.results(py)?.views.last().map(Summary::of);
        let is_new = |(key, ..): &(&str, String, Amount)| of_part.iter().all(|number| number.key != *key);
        let of_stage = summary.iter().flat_map(Summary::numbers).filter(is_new);
        let name = |number: &Quantity| number.name.clone().unwrap_or_else(|| number.label.to_owned());
        let numbers = of_part.iter().map(|number| (number.key, name(number), number.amount)).chain(of_stage);
        let parts = numbers.map(|(key, label, amount)| {
            let unit = amount.unit;
            (unit.keyed(key), label, amount.value, unit.symbol(), amount.bar, amount.to_string())
        });
        Ok(parts.collect())
    }

    /// Adds error bars from finer runs; returns also the exception that cut it short.
    fn verify(&self, py: Python<'_>, progress: Progress) -> (Self, Option<PyErr>) {
        let (verified, raised) = interruptible(py, progress, |line| pooled(|| verify::verify(&self.solution, line)));
        let solution = Arc::clone(&self.solution);
        (Self { solution, bars: Some(verified.bars), verdict: OnceLock::new() }, raised)
    }

    /// Writes every table and plot into a folder, as `run --out` does; returns the files.
    fn write(&self, py: Python<'_>, folder: String) -> PyResult<Vec<String>> {
        let files = py.detach(|| pooled(|| self.solution.write(&folder))).map_err(|error| error::output(&error))?;
        Ok(files.iter().map(|file| file.to_string_lossy().into_owned()).collect())
    }

    /// Writes the HTML report.
    fn report(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let verdict = self.judged(py).clone();
        let html = py.detach(|| Report::answered(&self.solution, self.bars.as_ref(), verdict).html());
        results::write(&path, html.as_bytes()).map_err(|error| error::output(&error))
    }

    /// Draws tools, blank and formed sheet into a file, DXF in a unit; returns the layers.
    fn export(&self, path: PathBuf, version: &str, unit: &str) -> PyResult<Vec<String>> {
        let versions = [("r12", Format::DxfR12), ("2000", Format::Dxf2000)];
        let dxf = versions.into_iter().find(|(name, _)| *name == version);
        let format = dxf.and_then(|(_, dxf)| Format::of(&path, dxf));
        let help = "write a path that ends with .dxf, .svg or .csv, and dxf=\"r12\" or \"2000\"";
        let format = format.ok_or_else(|| PyValueError::new_err(help))?;
        let drawing = Drawing::new(&self.solution, unit.parse().map_err(PyValueError::new_err::<String>)?);
        results::write(&path, drawing.text(format).as_bytes()).map_err(|error| error::output(&error))?;
        Ok(drawing.layers.into_iter().map(|layer| layer.name).collect())
    }
}

impl Solution {
    /// A solution without error bars.
    pub fn new(solution: stampflow::Solution) -> Self {
        Self { solution: Arc::new(solution), bars: None, verdict: OnceLock::new() }
    }

    fn judged(&self, py: Python<'_>) -> &(Answer, Vec<Finding>) {
        let judge = || pooled(|| judge(&self.solution, self.bars.as_ref(), true, &()));
        py.detach(|| self.verdict.get_or_init(judge))
    }

    fn results(&self, py: Python<'_>) -> PyResult<Results<'_>> {
        let results = py.detach(|| Results::of(&self.solution)).map_err(|error| error::reference(py, &error))?;
        Ok(results.verified(self.bars.as_ref()))
    }
}

fn outlines<'py>(py: Python<'py>, model: &Model, moved: &[Point]) -> Outlines<'py> {
    let tools = model.tools.iter().enumerate().map(|(i, tool)| {
        let (points, moved) = (tool.profile.polyline(ARC), moved.get(i).copied().unwrap_or_default());
        let r = field("r", "Distance from the axis", Unit::Mm, &points, |point| point.x + moved.x);
        let z = field("z", "z, along the axis", Unit::Mm, &points, |point| point.y + moved.y);
        (tool.role.name(), columns(py, Table::new(vec![r, z])))
    });
    tools.collect()
}

fn output(file: &str) -> PyResult<&'static Output> {
    OUTPUTS.iter().find(|output| output.file == file).ok_or_else(|| unknown(file))
}

fn unknown(file: &str) -> PyErr {
    PyValueError::new_err(format!("there is no output {file}"))
}
