//! Errors of the library as exceptions of `stampflow.errors`.

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use stampflow::case::CaseError;
use stampflow::import::ImportError;
use stampflow::study::StudyError;

fn raised<'py, A: pyo3::call::PyCallArgs<'py>>(py: Python<'py>, class: &str, args: A) -> PyErr {
    let made =
        py.import("stampflow.errors").and_then(|errors| errors.getattr(class)).and_then(|class| class.call1(args));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// `CaseError` with its file, place and remedy.
pub fn case(py: Python<'_>, error: &CaseError) -> PyErr {
    let (line, column) = error.position().unzip();
    let message = error.render(false);
    let args = (message.trim_end(), error.to_string(), error.file(), line, column, error.key(), error.remedy());
    raised(py, "CaseError", args)
}

/// `StudyError`, or `CaseError` of the case that the study varies.
pub fn study(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Case(error) => case(py, error),
        StudyError::Request { what, help } => raised(py, "StudyError", (what, help)),
    }
}

/// `DrawingError` with the file and the line of the entity.
pub fn drawing(py: Python<'_>, file: &str, error: &ImportError) -> PyErr {
    raised(py, "DrawingError", (&error.what, &error.help, file, error.line))
}

/// `CompareError` of a reference that cannot be used.
pub fn reference(py: Python<'_>, error: &impl ToString) -> PyErr {
    raised(py, "CompareError", (error.to_string(),))
}

/// `OSError` of results that cannot be written.
pub fn output(error: &impl ToString) -> PyErr {
    PyOSError::new_err(error.to_string())
}
