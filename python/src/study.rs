//! What studies have in common: how many threads, and what is handed over of what they found.

use super::error;
use super::picture::{Picture, picture};
use pyo3::prelude::*;
use serde_json::Value;
use stampflow::message::{Form, Message};
use stampflow::output::Chart;
use stampflow::study::StudyError;
use std::thread::available_parallelism;

/// What a study found as the JSON that the command line prints, its sentences, the answer first, and its pictures by the stems
/// of their files.
pub type Told<'py> = (String, Vec<String>, Vec<(String, Picture<'py>)>);

/// The words and units that Python is told in.
pub fn form() -> Form {
    Form::default()
}

/// As many as are asked for, or one a core.
pub fn threads(asked: Option<usize>) -> usize {
    asked.or_else(|| available_parallelism().ok().map(usize::from)).unwrap_or(1)
}

/// What is handed over.
pub fn told<'py, S: ToString>(
    py: Python<'py>,
    found: &Value,
    sentences: impl IntoIterator<Item = Message>,
    charts: impl IntoIterator<Item = (S, Chart)>,
) -> Told<'py> {
    let sentences = sentences.into_iter().map(|sentence| sentence.told(form())).collect();
    let pictures = charts.into_iter().map(|(stem, chart)| (stem.to_string(), picture(py, &chart)));
    (found.to_string(), sentences, pictures.collect())
}

/// What was found, or why nothing was: the exception that cut it short, or what is wrong with the study.
pub fn found<R>(py: Python<'_>, result: Result<R, StudyError>, raised: &mut Option<PyErr>) -> PyResult<R> {
    result.map_err(|wrong| raised.take().unwrap_or_else(|| error::of_study(py, &wrong)))
}
