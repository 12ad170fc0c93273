//! Errors of the library as exceptions of `stampflow.errors`.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;
use stampflow::case::CaseError;
use stampflow::compare::CompareError;
use stampflow::import::ImportError;
use stampflow::output::OutputError;
use stampflow::study::StudyError;

/// A class of `stampflow.errors`.
struct Exception {
    name: &'static str,
    class: PyOnceLock<Py<PyType>>,
}

static CASE: Exception = Exception::named("CaseError");
static STUDY: Exception = Exception::named("StudyError");
static DRAWING: Exception = Exception::named("DrawingError");
static REFERENCE: Exception = Exception::named("CompareError");

impl Exception {
    const fn named(name: &'static str) -> Self {
        Self { name, class: PyOnceLock::new() }
    }

    fn raised<'py, A>(&self, py: Python<'py>, args: A) -> PyErr
    where
        A: pyo3::call::PyCallArgs<'py>,
    {
        let made = self.class.import(py, "stampflow.errors", self.name).and_then(|class| class.call1(args));
        made.map_or_else(|error| error, PyErr::from_value)
    }
}

/// An error of a case: with its file, its place in it and what to write.
pub fn of_case(py: Python<'_>, error: &CaseError) -> PyErr {
    let (line, column) = error.position().unzip();
    let message = error.render(false);
    CASE.raised(py, (message.trim_end(), error.to_string(), error.file(), line, column, error.key(), error.remedy()))
}

/// An error of a study, or of the case that it varies.
pub fn of_study(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Case(error) => of_case(py, error),
        StudyError::Asked { what, help } => STUDY.raised(py, (what, help)),
    }
}

/// A drawing that no case is made of: with its file and the line of the entity.
pub fn of_drawing(py: Python<'_>, file: &str, error: &ImportError) -> PyErr {
    DRAWING.raised(py, (&error.what, &error.help, file, error.line))
}

/// A reference that the case is compared with cannot be used.
pub fn of_reference(py: Python<'_>, error: &CompareError) -> PyErr {
    REFERENCE.raised(py, (error.to_string(),))
}

/// Results that cannot be written.
pub fn of_output(py: Python<'_>, error: &OutputError) -> PyErr {
    match error {
        OutputError::Write(error) => pyo3::exceptions::PyOSError::new_err(error.to_string()),
        OutputError::Compare(error) => of_reference(py, error),
    }
}
