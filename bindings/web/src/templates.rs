//! Case files to begin with, and the sheets that they can name.

use crate::json::{Value, table};
use crate::question::{Failure, Question};
use stampflow::author::templates::{Choice, TEMPLATES, find};
use stampflow::case::library;

/// Every template with its options, and the names of all sheets.
pub fn list() -> Value {
    let option = |choice: &'static Choice| {
        table! {
            "key": choice.key,
            "kind": choice.kind.placeholder(),
            "default": choice.default.words(),
            "about": choice.about,
        }
    };
    let templates = TEMPLATES.iter().map(|template| {
        table! { "name": template.name, "about": template.about, "options": Value::list(template.options().map(option)) }
    });
    table! { "templates": Value::list(templates), "sheets": Value::list(library::names()) }
}

/// The text of a template's case.
pub fn fill(question: &Question) -> Result<Value, Failure> {
    let given: Vec<(&str, &str)> = question.table("given").collect();
    let text = find(question.text("name"))?.fill(&given)?;
    Ok(table! { "text": text })
}
