//! Reference of case files as Markdown, generated from the JSON schema.

use crate::common::prelude::*;

const QUICKSTART: &str = include_str!("../../cases/quickstart.toml");

const INTRODUCTION: &str = "\
# Case-file reference

Every table and key of a case file, from the program's own schema. How the keys work together is in
[a case file explained](case_file.md).

Each key stands with an example line. Quantities are text with a unit of their kind, such as `\"0.9 mm\"` or `\"0.035 in\"`.
A key without **needed** may be left out.
";

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/case_reference.md");

fn definitions() -> Vec<(String, Value)> {
    let schema: Value = serde_json::from_str(&case::schema()).expect("JSON");
    let own = schema["$defs"].as_object().expect("definitions").clone();
    own.into_iter().chain([(String::new(), schema)]).collect()
}

/// Trust: over the whole schema.
#[test]
fn every_key_has_a_row_and_every_example_of_one_stands_in_it() {
    let schema: Value = serde_json::from_str(&case::schema()).expect("JSON");
    let mut reference = Reference { schema: &schema, text: INTRODUCTION.to_owned(), paths: BTreeMap::new() };
    reference.section("", &schema);
    let page = reference.text.replace("\n\n\n", "\n\n");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(PAGE, &page).expect("writable");
    }
    assert_eq!(std::fs::read_to_string(PAGE).expect("readable"), page, "UPDATE=1 where that is meant");
    for (name, table) in definitions() {
        for (key, property) in table["properties"].as_object().into_iter().flatten() {
            let line = match property["examples"].get(0) {
                Some(example) => format!("\n| `{key} = {example}` |"),
                None => format!("\n| `{key}` |"),
            };
            assert!(page.contains(&line), "{name} has {line}");
        }
    }
}

/// Needs that another one brings about, or that no setting without the other can be written for.
const IMPLIED: [(&str, &str, &str); 3] =
    [("SectionTable", "closed_at", "offset_of"), ("SectionTable", "fillet", "file"), ("SectionTable", "layer", "file")];

/// Trust: over the whole schema: each key that is said to need another one is refused without it.
#[test]
fn what_is_said_to_be_needed_is() {
    let mut said = Vec::new();
    for (name, table) in definitions() {
        for (key, needs) in table["dependentRequired"].as_object().into_iter().flatten() {
            let needed = |need: &Value| [name.clone(), key.clone(), need.as_str().expect("a key").to_owned()];
            said.extend(needs.as_array().expect("keys").iter().map(needed));
        }
    }
    let rows = include_str!("../bad_cases/needs.txt").lines().filter(|line| !line.starts_with('#'));
    let needs: Vec<Vec<&str>> = rows.map(|line| line.split(" | ").collect()).collect();
    let tried = needs.iter().map(|row| (row[0], row[1], row[2])).chain(IMPLIED);
    let mut tried: Vec<_> = tried.map(|(table, key, need)| [table, key, need].map(str::to_owned)).collect();
    tried.sort();
    said.sort();
    assert_eq!(said, tried);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/quickstart.toml");
    case::parse(QUICKSTART, path, &[]).unwrap_or_else(|e| panic!("{}", e.render(false)));
    for row in needs {
        assert!(case::parse(QUICKSTART, path, &[row[3].to_owned()]).is_err(), "{row:?}");
    }
}

struct Reference<'a> {
    schema: &'a Value,
    text: String,
    /// Path under which each definition of the schema is described.
    paths: BTreeMap<&'a str, String>,
}

type Inner<'a> = Vec<(String, &'a Value)>;

impl<'a> Reference<'a> {
    fn section(&mut self, path: &str, node: &'a Value) {
        let heading = if path.is_empty() { "The file's own keys".to_owned() } else { format!("`{path}`") };
        let _ = write!(self.text, "\n## {heading}");
        self.body(path, node);
    }

    fn body(&mut self, path: &str, node: &'a Value) {
        let paragraphs = str_of(node, "description").split("\n\n").map(|text| text.replace('\n', " "));
        let _ = write!(self.text, "\n{}\n", paragraphs.collect::<Vec<_>>().join("\n\n"));
        let mut inner = Inner::new();
        for form in alternatives(node) {
            let kind = self.kind(form, path, &mut inner);
            let _ = write!(self.text, "\n- {kind}: {}", one_line(form));
        }
        for table in alternatives(node).chain([node]).filter(|table| table["properties"].is_object()) {
            self.keys(table, path, &mut inner);
        }
        // Tools are described where the first stage has them.
        inner.sort_by_key(|(path, _)| path == "stages");
        for (deeper, node) in inner {
            if deeper == path { self.body(path, node) } else { self.section(&deeper, node) }
        }
    }

    fn keys(&mut self, table: &'a Value, path: &str, inner: &mut Inner<'a>) {
        self.text += "\n\n| key | value | when left out | meaning |\n|---|---|---|---|\n";
        for (key, value) in table["properties"].as_object().into_iter().flatten() {
            let deeper = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            let line = value["examples"].get(0).map_or(key.clone(), |example| format!("{key} = {example}"));
            let kind = self.kind(value, &deeper, inner);
            let names = |list: &Value| list.as_array().is_some_and(|keys| keys.iter().any(|name| name == key));
            let is_alternative = list(&table["oneOf"]).any(|form| names(&form["required"]));
            let default = match &value["default"] {
                _ if names(&table["required"]) => "**needed**".to_owned(),
                _ if is_alternative => "**needed**, or another one".to_owned(),
                Value::Null => String::new(),
                default => format!("`{default}`"),
            };
            let referred = reference(value).map(|name| one_line(&self.schema["$defs"][name])).unwrap_or_default();
            let mut meaning = if value["description"].is_string() { one_line(value) } else { referred };
            let needs = list(&table["dependentRequired"][key]);
            let needs: Vec<String> = needs.map(|other| format!("`{}`", other.as_str().unwrap_or(""))).collect();
            if !needs.is_empty() {
                let _ = write!(meaning, " Needs {}.", needs.join(" and "));
            }
            let cells = [format!("`{line}`"), kind, default, meaning].map(|cell| cell.replace('|', "\\|"));
            let _ = writeln!(self.text, "| {} |", cells.join(" | "));
        }
    }

    /// Type, unit and limits of a value; a table is queued in `inner` and linked.
    fn kind(&mut self, value: &'a Value, path: &str, inner: &mut Inner<'a>) -> String {
        if let Some(name) = reference(value).filter(|_| alternatives(value).count() <= 1) {
            let node = &self.schema["$defs"][name];
            let words: Option<Vec<String>> =
                alternatives(node).map(|form| Some(format!("`{}`", form.get("const")?))).collect();
            if let Some(words) = words.filter(|words| !words.is_empty()) {
                return words.join(", ");
            }
            let known = self.paths.entry(name).or_insert_with(|| {
                inner.push((path.to_owned(), node));
                path.to_owned()
            });
            return format!("[`{known}`](#{})", known.replace('.', ""));
        }
        let forms: Vec<String> = alternatives(value).map(|form| self.kind(form, path, inner)).collect();
        let types = list(&value["type"]).chain([&value["type"]]).filter_map(Value::as_str);
        match types.filter(|kind| *kind != "null").last().unwrap_or_default() {
            _ if !forms.is_empty() => forms.join("; or "),
            _ if value["const"].is_string() => format!("`{}`", value["const"]),
            "array" if value["items"].is_object() => format!("list: {}", self.kind(&value["items"], path, inner)),
            "array" => {
                list(&value["prefixItems"]).map(|part| self.kind(part, path, inner)).collect::<Vec<_>>().join("; ")
            }
            "string" => value["x-quantity"].as_str().unwrap_or("text").to_owned() + &bounds(value),
            kind => kind.to_owned() + &bounds(value),
        }
    }
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

fn alternatives(value: &Value) -> impl Iterator<Item = &Value> {
    let all = list(&value["anyOf"]).chain(list(&value["oneOf"]));
    all.filter(|form| form["type"] != "null" && (form["required"].is_null() || form["properties"].is_object()))
}

fn reference(value: &Value) -> Option<&str> {
    let own = value["$ref"].as_str().or_else(|| alternatives(value).find_map(|form| form["$ref"].as_str()));
    own?.rsplit('/').next()
}

fn bounds(value: &Value) -> String {
    let limits = [("minimum", "from"), ("exclusiveMinimum", "above"), ("maximum", "to")];
    limits.iter().filter_map(|(key, word)| Some(format!(", {word} {}", value[*key].as_f64()?))).collect()
}

fn str_of<'v>(value: &'v Value, key: &str) -> &'v str {
    value[key].as_str().unwrap_or_default()
}

fn one_line(value: &Value) -> String {
    str_of(value, "description").split_whitespace().collect::<Vec<_>>().join(" ")
}
