//! The JSON schema of case files, for editors and for the examples in messages.

use super::{CaseFile, wording};
use serde_json::{Value, json};
use std::sync::LazyLock;

static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let text = schemars::schema_for!(CaseFile).to_value().to_string();
    // Documentation has units as rustdoc wants them, \[MPa\].
    let mut schema: Value = serde_json::from_str(&text.replace(r"\\[", "[").replace(r"\\]", "]"))
        .expect("a JSON value is read as it was written");
    for (name, table) in schema["$defs"].as_object_mut().into_iter().flatten() {
        across(name, table);
    }
    schema
});

/// Adds the keys that give a length of a round part across, each instead of the one from the axis.
fn across(name: &str, table: &mut Value) {
    for twin in
        wording::in_schema(name).filter(|twin| table["properties"].get(twin.radius).is_some()).collect::<Vec<_>>()
    {
        let mut diameter = table["properties"][twin.radius].clone();
        let about = format!("Instead of `{}`, of a round part: its diameter, twice as much.", twin.radius);
        if let Some(diameter) = diameter.as_object_mut() {
            diameter.remove("examples");
            diameter.insert("description".into(), about.into());
        }
        table["properties"][twin.diameter] = diameter;
        let Some(required) = table["required"].as_array_mut() else { continue };
        if let Some(at) = required.iter().position(|key| *key == *twin.radius) {
            required.remove(at);
            table["oneOf"] = json!([{ "required": [twin.radius] }, { "required": [twin.diameter] }]);
        }
    }
}

/// The JSON schema of a case file, indented.
pub fn schema() -> String {
    serde_json::to_string_pretty(&*SCHEMA).expect("a JSON value can be written")
}

/// A named definition of the schema; null when there is none.
pub(crate) fn definition(name: &str) -> &'static Value {
    &SCHEMA["$defs"][name]
}

/// The line that would set the key at a dotted path, taken from the schema's first example: `thickness = "0.9 mm"`.
pub(super) fn example_line(path: &str) -> Option<String> {
    let key = path.rsplit('.').next()?;
    let found = path.split('.').try_fold(&*SCHEMA, |node, segment| property(node, segment))?;
    let example = found.get("examples")?.get(0)?;
    Some(format!("{key} = {example}"))
}

/// The schema of a key of a table, or of an entry of an array; of a choice, in the first alternative that has it.
fn property<'a>(node: &'a Value, segment: &str) -> Option<&'a Value> {
    if let Some(choices) = node.get("anyOf").and_then(Value::as_array) {
        return choices.iter().find_map(|choice| property(choice, segment));
    }
    if let Some(name) = node.get("$ref").and_then(Value::as_str).and_then(|text| text.rsplit('/').next()) {
        return property(SCHEMA.get("$defs")?.get(name)?, segment);
    }
    if segment.parse::<usize>().is_ok() { node.get("items") } else { node.get("properties")?.get(segment) }
}
