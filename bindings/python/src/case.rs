//! A case, and how it is solved.

use super::attend::{Progress, Stages, attended};
use super::error;
use super::solution::Solution;
use pyo3::prelude::*;
use stampflow::study::{StudyError, Subject};
use stampflow::{assess, case};
use std::time::Instant;

/// A case as it was read, and the text and settings that it was read from.
#[pyclass(frozen, module = "stampflow._native")]
pub struct Case {
    case: stampflow::Case,
    /// Before any settings.
    written: String,
    name: String,
}

#[pymethods]
impl Case {
    /// Reads a case file.
    #[staticmethod]
    fn load(py: Python<'_>, path: String) -> PyResult<Self> {
        let case = case::load(&path, &[]).map_err(|error| error::of_case(py, &error))?;
        Ok(Self { written: case.text.clone(), case, name: path })
    }

    /// Reads a case from text.
    #[staticmethod]
    pub fn parse(py: Python<'_>, text: String, name: String, settings: Vec<String>) -> PyResult<Self> {
        let case = case::parse(&text, &name, &settings).map_err(|error| error::of_case(py, &error))?;
        Ok(Self { case, written: text, name })
    }

    /// The same with further settings, `key=value`.
    fn with_settings(&self, py: Python<'_>, settings: Vec<String>) -> PyResult<Self> {
        let all = [self.case.overrides.clone(), settings].concat();
        Self::parse(py, self.written.clone(), self.name.clone(), all)
    }

    #[getter]
    fn name(&self) -> &str {
        &self.case.name
    }

    #[getter]
    fn path(&self) -> &str {
        &self.name
    }

    #[getter]
    fn title(&self) -> &str {
        &self.case.model().title
    }

    #[getter]
    fn text(&self) -> &str {
        &self.case.text
    }

    /// Before any settings.
    #[getter]
    fn written(&self) -> &str {
        &self.written
    }

    /// What it has for a key, as it is written there.
    fn value(&self, py: Python<'_>, key: &str) -> PyResult<Option<String>> {
        self.subject().map(|subject| subject.own(key)).map_err(|error| error::of_study(py, &error))
    }

    #[getter]
    fn settings(&self) -> Vec<String> {
        self.case.overrides.clone()
    }

    #[getter]
    fn stages(&self) -> Vec<String> {
        self.case.stage_names().map(str::to_owned).collect()
    }

    /// What is found before a run, as JSON.
    fn findings(&self) -> PyResult<String> {
        super::solution::json(&assess::before(&self.case))
    }

    /// Solves it; with the exception that cut it short, where there is one.
    fn solve(&self, py: Python<'_>, progress: Progress) -> (Solution, Option<PyErr>) {
        let (solution, raised) = attended(py, progress, |line| {
            let start = Instant::now();
            let solution = self.case.clone().solve(&mut Stages::new(line, self.case.stages.len()));
            stampflow::Solution { wall: Some(start.elapsed()), ..solution }
        });
        (Solution::new(solution), raised)
    }
}

impl Case {
    /// As it was read.
    pub fn read(&self) -> &stampflow::Case {
        &self.case
    }

    /// A case that a study made of what it varies.
    pub fn made(of: &Subject, case: stampflow::Case) -> Self {
        let (text, path) = of.written();
        Self { case, written: text.to_owned(), name: path.to_string_lossy().into_owned() }
    }

    /// As what a study varies.
    pub fn subject(&self) -> Result<Subject, StudyError> {
        Subject::of_text(self.written.clone(), &self.name, self.case.overrides.clone())
    }
}
