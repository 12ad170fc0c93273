//! Cases, templates and sheets.

use super::interruptible::{Progress, Stages, interruptible};
use super::table::json as to_json;
use super::{error, solution::Solution};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde_json::json;
use stampflow::author::templates::{TEMPLATES, Template, find};
use stampflow::case::library;
use stampflow::study::{BaseCase, StudyError};
use stampflow::{assess, case};
use std::{collections::BTreeMap, time::Instant};

/// A case as it was read, and the text and settings that it was read from.
#[pyclass(frozen, module = "stampflow._native")]
pub struct Case {
    case: stampflow::Case,
    /// Text before any settings.
    written: String,
    path: String,
}

#[pymethods]
impl Case {
    /// Reads a case file.
    #[staticmethod]
    fn load(py: Python<'_>, path: String) -> PyResult<Self> {
        let case = case::load(&path, &[]).map_err(|error| error::case(py, &error))?;
        Ok(Self { written: case.text.clone(), case, path })
    }

    /// Reads a case from text.
    #[staticmethod]
    fn parse(py: Python<'_>, text: String, path: String, settings: Vec<String>) -> PyResult<Self> {
        let case = case::parse(&text, &path, &settings).map_err(|error| error::case(py, &error))?;
        Ok(Self { case, written: text, path })
    }

    /// Applies further settings, `key=value`.
    fn with_settings(&self, py: Python<'_>, settings: Vec<String>) -> PyResult<Self> {
        let all = [self.case.overrides.clone(), settings].concat();
        Self::parse(py, self.written.clone(), self.path.clone(), all)
    }

    #[getter]
    fn name(&self) -> &str {
        &self.case.name
    }

    #[getter]
    fn path(&self) -> &str {
        &self.path
    }

    #[getter]
    fn title(&self) -> &str {
        &self.case.model().title
    }

    #[getter]
    fn text(&self) -> &str {
        &self.case.text
    }

    #[getter]
    fn written(&self) -> &str {
        &self.written
    }

    #[getter]
    fn settings(&self) -> Vec<String> {
        self.case.overrides.clone()
    }

    #[getter]
    fn stages(&self) -> Vec<String> {
        self.case.stages.iter().map(|stage| stage.name.clone()).collect()
    }

    /// Findings before a run, as JSON.
    fn findings(&self) -> PyResult<String> {
        to_json(&assess::before(&self.case))
    }

    /// Solves the case; returns also the exception that cut it short.
    fn solve(&self, py: Python<'_>, progress: Progress) -> (Solution, Option<PyErr>) {
        let (solution, raised) = interruptible(py, progress, |line| {
            let start = Instant::now();
            let solution = self.case.clone().solve(&mut Stages::new(line, self.case.stages.len()));
            stampflow::Solution { wall: Some(start.elapsed()), ..solution }
        });
        (Solution::new(solution), raised)
    }
}

impl Case {
    /// The case itself.
    pub fn inner(&self) -> &stampflow::Case {
        &self.case
    }

    /// Base case of a study.
    pub fn base(&self) -> Result<BaseCase, StudyError> {
        BaseCase::from_text(self.written.clone(), &self.path, self.case.overrides.clone())
    }
}

/// Text of a template's case with some sizes.
#[pyfunction]
pub fn fill(py: Python<'_>, name: &str, given: Vec<(String, String)>) -> PyResult<String> {
    let given: Vec<(&str, &str)> = given.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
    find(name).and_then(|template| template.fill(&given)).map_err(|error| error::case(py, &error))
}

/// Names of the templates with their options, each with what it is.
#[pyfunction]
pub fn templates() -> BTreeMap<&'static str, Vec<(&'static str, &'static str)>> {
    let options =
        |template: &'static Template| template.options().map(|option| (&*option.key, &*option.about)).collect();
    TEMPLATES.iter().map(|template| (template.name, options(template))).collect()
}

/// Built-in sheets by name, as JSON.
#[pyfunction]
pub fn materials(py: Python<'_>) -> PyResult<String> {
    let all = library::materials().map_err(|error| error::case(py, &error))?;
    let entries = all.iter().map(|entry| {
        let library::Entry { name, about, material, text, .. } = entry;
        let about = json!({
            "title": about.title, "stands_for": about.stands_for.as_ref().map_or(&[][..], |stands| &stands.grades),
            "grade": about.grade, "source": about.source(), "licence": about.licence, "thickness": about.thickness,
            "law": material.hardening.to_string(), "r": material.yield_criterion.ratio(), "n": entry.n(),
            "proof_stress_MPa": entry.proof_stress(), "tensile_strength_MPa": entry.tensile_strength(),
            "uniform_elongation": entry.uniform_elongation(), "young_MPa": material.elastic.map(|elastic| elastic.young),
            "notes": about.notes, "case": text, "made": about.is_made(),
            "band": about.band.as_ref().map(|band| band.rows()),
        });
        (name.to_string(), about)
    });
    to_json(&entries.collect::<serde_json::Map<_, _>>())
}

/// JSON schema of case files.
#[pyfunction]
pub fn schema() -> String {
    stampflow::case::schema()
}

/// TOML of a JSON object.
#[pyfunction]
pub fn toml(json: &str) -> PyResult<String> {
    let wrong = |error: String| PyValueError::new_err(error);
    let tables: ::toml::Table = serde_json::from_str(json).map_err(|error| wrong(error.to_string()))?;
    ::toml::to_string(&tables).map_err(|error| wrong(error.to_string()))
}
