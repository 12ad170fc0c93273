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
        if let Some(with) = table["dependentRequired"].get(twin.radius).cloned() {
            table["dependentRequired"][twin.diameter] = with;
        }
        let Some(required) = table.get_mut("required").and_then(Value::as_array_mut) else { continue };
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

/// The schema as a value.
pub(crate) fn whole() -> &'static Value {
    &SCHEMA
}

/// The dotted path of every key that holds a value, in the tables of a case: `tools.punch.travel`. Of lists the keys of the
/// first entry, `stages.0.trim`.
pub fn keys() -> Vec<String> {
    let mut keys = Vec::new();
    collect(&SCHEMA, "", &mut keys);
    keys
}

fn collect(node: &Value, path: &str, keys: &mut Vec<String>) {
    let choices = node.get("anyOf").and_then(Value::as_array).into_iter().flatten();
    let named = node.get("$ref").and_then(Value::as_str).and_then(|text| text.rsplit('/').next()).map(definition);
    let tables: Vec<&Value> = choices.chain(named).filter(|node| node["type"] != "null").collect();
    let deeper = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    let before = keys.len();
    tables.iter().for_each(|table| collect(table, path, keys));
    for (key, value) in node.get("properties").and_then(Value::as_object).into_iter().flatten() {
        collect(value, &deeper(key), keys);
    }
    let entries = node.get("items").filter(|entry| entry.get("$ref").is_some());
    entries.into_iter().for_each(|entry| collect(entry, &deeper("0"), keys));
    // What may be one value and a table too is offered as both.
    let is_plain = |kind: &Value| kind != "object" && kind != "null";
    let plain = |node: &Value| match &node["type"] {
        Value::Array(kinds) => kinds.iter().any(is_plain),
        kind => kind.is_string() && is_plain(kind),
    };
    let is_value = plain(node) || tables.iter().any(|table| table.get("$ref").is_none() && plain(table));
    if (keys.len() == before || is_value) && !path.is_empty() {
        keys.push(path.to_owned());
    }
    // Alternatives of one key, and what they have in common.
    let mut seen = std::collections::BTreeSet::new();
    keys.retain(|key| seen.insert(key.clone()));
}

/// A named definition of the schema; null when there is none.
pub(crate) fn definition(name: &str) -> &'static Value {
    &SCHEMA["$defs"][name]
}

#[cfg(test)]
mod tests {
    use super::super::examples::is_index;
    use super::*;
    use std::collections::BTreeSet;

    /// The schema of a key of a table, or of an entry of an array; of a choice, in the first alternative that has it.
    fn property<'a>(node: &'a Value, segment: &str) -> Option<&'a Value> {
        if let Some(choices) = node.get("anyOf").and_then(Value::as_array) {
            return choices.iter().find_map(|choice| property(choice, segment));
        }
        if let Some(name) = node.get("$ref").and_then(Value::as_str).and_then(|text| text.rsplit('/').next()) {
            return property(SCHEMA.get("$defs")?.get(name)?, segment);
        }
        if is_index(segment) { node.get("items") } else { node.get("properties")?.get(segment) }
    }

    /// Every path in a node, of tables and lists too.
    fn paths(node: &Value, path: &str, all: &mut BTreeSet<String>) {
        let choices = node.get("anyOf").and_then(Value::as_array).into_iter().flatten();
        let named = node.get("$ref").and_then(Value::as_str).and_then(|text| text.rsplit('/').next()).map(definition);
        choices.chain(named).for_each(|node| paths(node, path, all));
        let keys = node.get("properties").and_then(Value::as_object).into_iter().flatten();
        let entries = node.get("items").map(|entry| ("0", entry));
        for (key, value) in keys.map(|(key, value)| (key.as_str(), value)).chain(entries) {
            let deeper = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
            paths(value, &deeper, all);
            all.insert(deeper);
        }
    }

    /// `UPDATE=1` writes them anew.
    #[test]
    fn examples_of_messages_are_those_of_the_schema() {
        let mut all = BTreeSet::new();
        paths(&SCHEMA, "", &mut all);
        let line = |path: &String| {
            let found = path.split('.').try_fold(&*SCHEMA, |node, segment| property(node, segment))?;
            Some(format!("{path} = {}\n", found.get("examples")?.get(0)?))
        };
        let anew: String = all.iter().filter_map(line).collect();
        if std::env::var_os("UPDATE").is_some() {
            std::fs::write("src/case/examples.txt", &anew).expect("writable");
        }
        assert!(include_str!("examples.txt") == anew, "src/case/examples.txt is old: UPDATE=1 writes it anew");
    }
}
