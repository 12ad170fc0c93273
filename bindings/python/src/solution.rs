//! A solved case, and what is told of it.

use super::attend::{Progress, attended};
use super::column::{Column, columns};
use super::error;
use super::picture::Picture;
use super::stage::{FrameParts, StageParts};
use super::words::plain;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use serde::Serialize;
use stampflow::assess::{self, Answer, Finding};
use stampflow::message::Message;
use stampflow::output::{Make, OUTPUTS, Output, Results, StageView};
use stampflow::study::verify::{self, Number, Of, Verification};
use std::sync::{Arc, OnceLock};

/// A solved case, with error bars where it was verified.
#[pyclass(frozen, module = "stampflow._native")]
pub struct Solution {
    solution: Arc<stampflow::Solution>,
    verification: Option<Verification>,
    /// Found once: some questions solve the case again.
    answered: OnceLock<(Answer, Vec<Finding>)>,
}

#[pymethods]
impl Solution {
    #[getter]
    fn complete(&self) -> bool {
        self.solution.is_complete()
    }

    /// Time that the solution took [s].
    #[getter]
    fn wall_time(&self) -> f64 {
        self.solution.wall.map_or(0.0, |wall| wall.as_secs_f64())
    }

    /// The stages that were run.
    fn stages(&self) -> Vec<StageParts> {
        let stages = self.solution.case.stages.iter().zip(&self.solution.stages);
        stages.map(|(asked, stage)| super::stage::parts(&asked.name, stage)).collect()
    }

    /// A frame of a stage.
    fn frame<'py>(&self, py: Python<'py>, stage: usize, frame: usize) -> PyResult<FrameParts<'py>> {
        let solved = self.solution.stages.get(stage);
        let parts = solved.and_then(|stage| super::stage::frame(py, stage, frame));
        parts.ok_or_else(|| PyIndexError::new_err("no such frame"))
    }

    /// A table of a stage by the name of its file; nothing where there is none.
    fn table<'py>(&self, py: Python<'py>, stage: usize, file: &str) -> PyResult<Option<Vec<Column<'py>>>> {
        let Make::Table(make) = output(file)?.make else { return Err(unknown(file)) };
        let table = py.detach(|| self.solution.views().get(stage).and_then(make));
        Ok(table.map(|table| columns(py, table)))
    }

    /// A picture of a stage by the name of its file; nothing where there is nothing to draw.
    fn picture<'py>(&self, py: Python<'py>, stage: usize, file: &str) -> PyResult<Option<Picture<'py>>> {
        let output = output(file)?;
        let chart = self.viewing(py, |views| views.get(stage).and_then(|view| output.chart(view)))?;
        Ok(chart.map(|chart| super::picture::picture(py, &chart)))
    }

    /// What `summary.json` says, of several stages a list of them.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        let summary = match &self.verification {
            None => py.detach(|| self.solution.summary()),
            Some(_) => self.results(py)?.summary(),
        };
        json(&summary)
    }

    /// As it is printed by `run --verbose`.
    fn told(&self, py: Python<'_>) -> String {
        py.detach(|| self.solution.summary().to_string())
    }

    /// The light of the verdict, its sentence, and a line of its lights.
    fn verdict(&self, py: Python<'_>) -> (&'static str, String, String) {
        let (answer, findings) = self.answered(py);
        (answer.light.name(), plain(&answer.sentence), plain(assess::headline(findings)))
    }

    /// The rows of the verdict, as JSON.
    fn findings(&self, py: Python<'_>) -> PyResult<String> {
        json(&assess::judgements(&self.answered(py).1).collect::<Vec<_>>())
    }

    /// The numbers: header, label, value, unit, error bar, as they are told, what the bar is made of or why there is none.
    #[allow(clippy::type_complexity)]
    fn numbers(&self, py: Python<'_>) -> Vec<(String, &'static str, f64, &'static str, Option<f64>, String, String)> {
        let told = |number: &Number, bar: Option<f64>, about: String| {
            let amount = bar.map_or(number.amount, |half| number.amount.with_bar(half));
            let told = plain(Message::from(amount));
            (header(number), number.label, number.amount.value, number.amount.unit.symbol(), bar, told, about)
        };
        match &self.verification {
            Some(verification) => {
                let bars = verification.bars.iter();
                bars.map(|bar| told(&bar.number, bar.moves(), plain(bar.made_of()))).collect()
            }
            None => {
                let stampflow::Solution { case, stages, .. } = &*self.solution;
                let numbers = verification::numbers(case, stages, &self.answered(py).1);
                numbers.iter().map(|number| told(number, None, String::new())).collect()
            }
        }
    }

    /// The same with error bars, from one coarser run or from finer ones; with the exception that cut it short.
    fn verify(&self, py: Python<'_>, quick: bool, progress: Progress) -> (Self, Option<PyErr>) {
        let (verification, raised) = attended(py, progress, |line| match quick {
            true => verification::quick(&self.solution, line),
            false => verification::verify(&self.solution, line),
        });
        let solution = Arc::clone(&self.solution);
        (Self { solution, verification: Some(verification), answered: OnceLock::new() }, raised)
    }

    /// What the error bars are from, and whatever is no small error; empty without them.
    fn told_of_bars(&self) -> Vec<String> {
        let sentences = self.verification.iter().flat_map(Verification::sentences);
        sentences.map(plain).collect()
    }

    /// Every comparison with a reference: quantity, source, in a sentence, whether it is beyond what is accepted, its points.
    #[allow(clippy::type_complexity)]
    fn comparisons<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<Vec<(&'static str, String, String, bool, Vec<Column<'py>>)>> {
        let comparisons = self.solution.comparisons().map_err(|error| error::of_reference(py, &error))?;
        let of = comparisons.into_iter().map(|comparison| {
            let source = comparison.source.as_ref().map_or_else(String::new, ToString::to_string);
            let (name, sentence) = (comparison.spec.against.name(), plain(comparison.sentence()));
            (name, source, sentence, comparison.is_failure(), columns(py, comparison.table()))
        });
        Ok(of.collect())
    }

    /// Writes every table and plot into a folder, as `run --out` does; the files.
    fn write(&self, py: Python<'_>, folder: String) -> PyResult<Vec<String>> {
        let files = py.detach(|| self.solution.write(&folder)).map_err(|error| error::of_output(py, &error))?;
        Ok(files.iter().map(|file| file.to_string_lossy().into_owned()).collect())
    }
}

impl Solution {
    /// Without error bars.
    pub fn new(solution: stampflow::Solution) -> Self {
        Self::verified(solution, None)
    }

    /// With error bars, where there are some.
    pub fn verified(solution: stampflow::Solution, verification: Option<Verification>) -> Self {
        Self { solution: Arc::new(solution), verification, answered: OnceLock::new() }
    }

    fn answered(&self, py: Python<'_>) -> &(Answer, Vec<Finding>) {
        py.detach(|| self.answered.get_or_init(|| verification::answered(&self.solution, self.verification.as_ref())))
    }

    fn results(&self, py: Python<'_>) -> PyResult<Results<'_>> {
        let results = py.detach(|| Results::of(&self.solution)).map_err(|error| error::of_reference(py, &error))?;
        Ok(results.verified(self.verification.as_ref()))
    }

    /// Its stages as outputs see them; only error bars need what the case is compared with.
    fn viewing<R: Send>(&self, py: Python<'_>, look: impl FnOnce(&[StageView<'_>]) -> R + Send) -> PyResult<R> {
        match &self.verification {
            None => Ok(py.detach(|| look(&self.solution.views()))),
            Some(_) => Ok(look(&self.results(py)?.views)),
        }
    }
}

fn output(file: &str) -> PyResult<&'static Output> {
    OUTPUTS.iter().find(|output| output.file == file).ok_or_else(|| unknown(file))
}

fn unknown(file: &str) -> PyErr {
    PyValueError::new_err(format!("there is no output {file}"))
}

/// A number's name with its unit, as columns of studies have it.
pub fn header(number: &Number) -> String {
    match number.of {
        Of::Verdict => number.amount.unit.keyed(&format!("{}_judged", number.key)),
        Of::Answer | Of::Part => number.amount.unit.keyed(number.key),
    }
}

/// As the command line prints it.
pub fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map(plain).map_err(|error| PyValueError::new_err(error.to_string()))
}
