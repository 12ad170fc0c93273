//! Reference of case files as Markdown, generated from the JSON schema.

use crate::case::{definition, whole};
use serde_json::Value;
use std::collections::BTreeMap;

const INTRODUCTION: &str = "\
# Case-file reference

Every table and key of a case file; `stampflow schema --markdown` writes this page. How the keys work together is in
[a case file explained](case_file.md).

Each key stands with an example line. Quantities are text with a unit of their kind, such as `\"0.9 mm\"` or `\"0.035 in\"`.
A key without **needed** may be left out.
";

/// Markdown page with one section for each table of a case file.
pub fn case_reference() -> String {
    let mut reference = Reference { text: INTRODUCTION.to_owned(), paths: BTreeMap::new() };
    reference.section("", whole());
    reference.text
}

struct Reference {
    text: String,
    /// Path under which each definition of the schema is described.
    paths: BTreeMap<&'static str, String>,
}

/// Tables still to be described: path and schema.
type Inner = Vec<(String, &'static Value)>;

impl Reference {
    fn section(&mut self, path: &str, node: &'static Value) {
        let heading = if path.is_empty() { "The file's own keys".to_owned() } else { format!("`{path}`") };
        self.text += &format!("\n## {heading}\n");
        self.body(path, node);
    }

    fn body(&mut self, path: &str, node: &'static Value) {
        self.text += &format!("\n{}\n", node["description"].as_str().unwrap_or_default());
        let mut inner = Inner::new();
        for form in alternatives(node) {
            let kind = self.kind(form, path, &mut inner);
            self.text += &format!("\n- {kind}: {}", one_line(form));
        }
        for table in alternatives(node).chain([node]).filter(|table| table["properties"].is_object()) {
            self.text += "\n\n| key | value | when left out | meaning |\n|---|---|---|---|\n";
            for (key, value) in table["properties"].as_object().into_iter().flatten() {
                self.row(table, key, value, path, &mut inner);
            }
        }
        // Tools are described where the first stage has them.
        inner.sort_by_key(|(path, _)| path == "stages");
        for (deeper, node) in inner {
            if deeper == path { self.body(path, node) } else { self.section(&deeper, node) }
        }
    }

    fn row(&mut self, table: &Value, key: &str, value: &'static Value, path: &str, inner: &mut Inner) {
        let deeper = if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        let line = value["examples"].get(0).map_or(key.to_owned(), |example| format!("{key} = {example}"));
        let kind = self.kind(value, &deeper, inner);
        let names = |keys: &Value| list(keys).any(|name| name == key);
        let default = match &value["default"] {
            _ if names(&table["required"]) => "**needed**".to_owned(),
            _ if list(&table["oneOf"]).any(|form| names(&form["required"])) => "**needed**, or another one".to_owned(),
            Value::Null => String::new(),
            default => format!("`{default}`"),
        };
        let described =
            if value["description"].is_string() { value } else { definition(reference(value).unwrap_or("")) };
        let needs = list(&table["dependentRequired"][key]).filter_map(Value::as_str).map(|other| format!("`{other}`"));
        let needs = needs.collect::<Vec<_>>().join(" and ");
        let needs = if needs.is_empty() { needs } else { format!(" Needs {needs}.") };
        let cells = [format!("`{line}`"), kind, default, one_line(described) + &needs];
        self.text += &format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
    }

    /// Type, unit and limits of a value; a table is queued in `inner` and linked.
    fn kind(&mut self, value: &'static Value, path: &str, inner: &mut Inner) -> String {
        if let Some(name) = reference(value).filter(|_| alternatives(value).count() <= 1) {
            let node = definition(name);
            let words = alternatives(node).map(|form| Some(format!("`{}`", form.get("const")?)));
            if let Some(words) = words.collect::<Option<Vec<_>>>().filter(|words| !words.is_empty()) {
                return words.join(", ");
            }
            let known = self.paths.entry(name).or_insert_with(|| {
                inner.push((path.to_owned(), node));
                path.to_owned()
            });
            return format!("[`{known}`](#{})", known.replace('.', ""));
        }
        let mut kinds = |forms: &mut dyn Iterator<Item = &'static Value>, or: &str| {
            forms.map(|form| self.kind(form, path, inner)).collect::<Vec<_>>().join(or)
        };
        let forms = kinds(&mut alternatives(value), "; or ");
        let types = list(&value["type"]).chain([&value["type"]]).filter_map(Value::as_str);
        match types.filter(|kind| *kind != "null").last().unwrap_or_default() {
            _ if !forms.is_empty() => forms,
            _ if value["const"].is_string() => format!("`{}`", value["const"]),
            "array" if value["items"].is_object() => format!("list: {}", self.kind(&value["items"], path, inner)),
            "array" => kinds(&mut list(&value["prefixItems"]), "; "),
            "string" => value["x-quantity"].as_str().unwrap_or("text").to_owned() + &bounds(value),
            kind => kind.to_owned() + &bounds(value),
        }
    }
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// The variants of a value; alternatives of required keys are none.
fn alternatives(value: &'static Value) -> impl Iterator<Item = &'static Value> {
    let all = list(&value["anyOf"]).chain(list(&value["oneOf"]));
    all.filter(|form| form["type"] != "null" && (form["required"].is_null() || form["properties"].is_object()))
}

fn reference(value: &'static Value) -> Option<&'static str> {
    let own = value["$ref"].as_str().or_else(|| alternatives(value).find_map(|form| form["$ref"].as_str()));
    own?.rsplit('/').next()
}

fn bounds(value: &Value) -> String {
    let limits = [("minimum", "from"), ("exclusiveMinimum", "above"), ("maximum", "to")];
    limits.iter().filter_map(|(key, word)| Some(format!(", {word} {}", value[*key].as_f64()?))).collect()
}

fn one_line(value: &Value) -> String {
    value["description"].as_str().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
}
