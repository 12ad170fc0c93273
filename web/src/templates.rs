//! Case files to begin with, and the sheets that they can name.

use crate::question::{Failure, text};
use serde_json::{Value, json};
use stampflow::author::templates::{Choice, TEMPLATES, find};
use stampflow::case::library;

/// Every template with its options, and the names of all sheets.
pub fn list() -> Value {
    let option = |choice: &'static Choice| {
        json!({
            "key": choice.key,
            "kind": choice.kind.placeholder(),
            "default": choice.default.words(),
            "about": choice.about,
        })
    };
    let templates = TEMPLATES.iter().map(|template| {
        let options: Vec<Value> = template.options().map(option).collect();
        json!({ "name": template.name, "about": template.about, "options": options })
    });
    json!({ "templates": templates.collect::<Vec<_>>(), "sheets": library::names().collect::<Vec<_>>() })
}

/// The text of a template's case.
pub fn fill(question: &Value) -> Result<Value, Failure> {
    let given: Vec<(&str, &str)> = question["given"]
        .as_object()
        .into_iter()
        .flatten()
        .filter_map(|(key, value)| Some((key.as_str(), value.as_str()?)))
        .collect();
    let text = find(text(question, "name"))?.fill(&given)?;
    Ok(json!({ "text": text }))
}
