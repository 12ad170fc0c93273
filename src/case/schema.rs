//! JSON schema of case files, for editors, the key reference and the examples in messages.

use super::file::CaseFile;
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// Examples of keys by the schema's definition of their table.
const EXAMPLES: &str = include_str!("examples.toml");

static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
    let text = schemars::schema_for!(CaseFile).to_value().to_string();
    // Documentation has units as rustdoc wants them, \[MPa\].
    let mut schema: Value =
        serde_json::from_str(&text.replace(r"\\[", "[").replace(r"\\]", "]")).expect("serialized JSON is valid");
    let examples: BTreeMap<String, Map<String, Value>> = toml::from_str(EXAMPLES).expect("the examples are TOML");
    for (table, examples) in examples {
        let node = if table == "CaseFile" { &mut schema } else { &mut schema["$defs"][table] };
        for (key, example) in examples {
            node["properties"][key]["examples"] = Value::from(vec![example]);
        }
    }
    schema
});

/// Returns the JSON schema of a case file, indented.
pub fn schema() -> String {
    serde_json::to_string_pretty(&*SCHEMA).expect("a JSON value can be written")
}

/// Returns a line that would set the key at a dotted path: `thickness = "0.9 mm"`.
pub(super) fn example(path: &str) -> Option<String> {
    let property = path.split('.').try_fold(&*SCHEMA, property)?;
    Some(format!("{} = {}", path.rsplit('.').next()?, property.get("examples")?.get(0)?))
}

pub(super) fn is_index(name: &str) -> bool {
    name.parse::<usize>().is_ok()
}

fn reference(node: &Value) -> Option<&'static Value> {
    Some(&SCHEMA["$defs"][node.get("$ref")?.as_str()?.rsplit('/').next()?])
}

fn alternatives(node: &Value) -> impl Iterator<Item = &Value> {
    node.get("anyOf").and_then(Value::as_array).into_iter().flatten()
}

/// Schema of a key of a table or of an entry of an array, in the first alternative that has it.
fn property<'a>(node: &'a Value, segment: &str) -> Option<&'a Value> {
    let own = if is_index(segment) { node.get("items") } else { node.get("properties").and_then(|p| p.get(segment)) };
    let referred = || reference(node).and_then(|node| property(node, segment));
    own.or_else(referred).or_else(|| alternatives(node).find_map(|choice| property(choice, segment)))
}

/// Returns the dotted path of every key that holds a value, `tools.punch.travel`; of lists the keys of the first entry,
/// `stages.0.trim`.
pub fn keys() -> BTreeSet<String> {
    let mut keys = BTreeSet::new();
    collect(&SCHEMA, "", &mut keys);
    keys
}

fn collect(node: &Value, path: &str, keys: &mut BTreeSet<String>) {
    let forms: Vec<&Value> = alternatives(node).chain(reference(node)).filter(|node| node["type"] != "null").collect();
    forms.iter().for_each(|form| collect(form, path, keys));
    let properties = node.get("properties").and_then(Value::as_object);
    let entry = node.get("items").filter(|entry| entry.get("$ref").is_some()).map(|entry| ("0", entry));
    for (key, value) in properties.into_iter().flatten().map(|(key, value)| (key.as_str(), value)).chain(entry) {
        collect(value, &if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }, keys);
    }
    if forms.is_empty() && properties.is_none() && entry.is_none() {
        keys.insert(path.to_owned());
    }
}
