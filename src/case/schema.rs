//! JSON schema of case files, for editors, the key reference and the examples in messages.

use super::*;
use serde_json::{Map, Value};
use std::sync::LazyLock;

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

/// Schema of a key of a table or of an entry of an array, in the first alternative that has it.
fn property<'a>(node: &'a Value, segment: &str) -> Option<&'a Value> {
    let own = if is_index(segment) { node.get("items") } else { node.get("properties").and_then(|p| p.get(segment)) };
    let referred = || property(&SCHEMA["$defs"][node.get("$ref")?.as_str()?.rsplit('/').next()?], segment);
    let in_choices = || node.get("anyOf")?.as_array()?.iter().find_map(|choice| property(choice, segment));
    // An entry of an array may be named without its number.
    own.or_else(|| property(node.get("items")?, segment)).or_else(referred).or_else(in_choices)
}
