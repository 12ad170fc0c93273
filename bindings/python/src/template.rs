//! Cases from a few sizes.

use super::error;
use pyo3::prelude::*;
use stampflow::author::templates::{TEMPLATES, find};

/// Name of a template, what it forms, and its options: name, what it is, what is taken where it is not given.
type Listed = (&'static str, &'static str, Vec<(&'static str, &'static str, &'static str)>);

/// The text of a template's case with some sizes.
#[pyfunction]
pub fn fill(py: Python<'_>, name: &str, given: Vec<(String, String)>) -> PyResult<String> {
    let given: Vec<(&str, &str)> = given.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
    find(name).and_then(|template| template.fill(&given)).map_err(|error| error::of_case(py, &error))
}

/// All templates.
#[pyfunction]
pub fn templates() -> Vec<Listed> {
    let of = |template: &'static stampflow::author::templates::Template| {
        let options = template.options().map(|choice| (choice.key, choice.about, choice.default.words()));
        (template.name, template.about, options.collect())
    };
    TEMPLATES.iter().map(of).collect()
}
