//! What studies have in common: what they are of, what was measured, how many threads, and what is handed over of what they
//! found.

use super::case::Case;
use super::error;
use super::picture::{Picture, picture};
use super::words::plain;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use serde_json::Value;
use stampflow::message::{Form, Message};
use stampflow::output::Chart;
use stampflow::study::{Readings, StudyError};
use std::path::PathBuf;
use std::thread::available_parallelism;

/// What a study found as the JSON that the command line prints, its sentences, the answer first, and its pictures by the stems
/// of their files.
pub type Told<'py> = (String, Vec<String>, Vec<(String, Picture<'py>)>);

/// A case that was read; or a case or study file, and settings besides.
#[derive(FromPyObject)]
pub enum Of<'py> {
    /// As it was read.
    Case(PyRef<'py, Case>),
    /// As it stands on the disk.
    File(PathBuf, Vec<String>),
}

/// What was measured: a file; or what it is called, and its columns by their names.
#[derive(FromPyObject)]
pub enum Given<'py> {
    /// A CSV file.
    File(PathBuf),
    /// Arrays.
    Held(String, Vec<(String, PyReadonlyArray1<'py, f64>)>),
}

/// Tables as they were given.
pub fn readings(given: &[Given<'_>]) -> Result<Vec<Readings>, StudyError> {
    let read = |given: &Given<'_>| match given {
        Given::File(path) => Ok(Readings::File(path.clone())),
        Given::Held(called, columns) => {
            let columns = columns.iter().map(|(name, array)| (name.clone(), array.as_array().to_vec()));
            Readings::held(called, &columns.collect::<Vec<_>>())
        }
    };
    given.iter().map(read).collect()
}

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
    let sentences = sentences.into_iter().map(|sentence| plain(sentence.told(form()))).collect();
    let pictures = charts.into_iter().map(|(stem, chart)| (stem.to_string(), picture(py, &chart)));
    (plain(found), sentences, pictures.collect())
}

/// What was found, or why nothing was: the exception that cut it short, or what is wrong with the study.
pub fn found<R>(py: Python<'_>, result: Result<R, StudyError>, raised: &mut Option<PyErr>) -> PyResult<R> {
    result.map_err(|wrong| raised.take().unwrap_or_else(|| error::of_study(py, &wrong)))
}
