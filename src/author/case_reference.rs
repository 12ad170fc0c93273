//! The reference of case files as Markdown, read off the JSON schema: what is listed is what is accepted.

use super::laws::{description, entries, reference};
use crate::case::{definition, whole};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Keys in the order in which a designer writes them. In every table those that are not named here follow, first what it
/// cannot do without.
const ORDER: &str = "\
    title geometry notes blank material tools punch die holder beads name source radius diameter \
    half_length half_width thickness flat hemispherical crowned profile travel speed motion from to \
    arc_to center turn file fillet offset_of by throat throat_diameter shoulder inner_radius \
    inner_diameter inner_half_width force pressure gap spring hardening anisotropy yield_condition young \
    poisson mode kinematic rate initial density specific_heat friction gas lower upper strain_rate heat \
    forming_limit points strain press springback stage stages stop output solver report";

const INTRODUCTION: &str = "\
# Case-file reference

Every table and key of a case file, as the program reads them: `stampflow schema --markdown` writes this page, and \
`stampflow schema` the same for editors. What the keys do together is in [a case file explained](case_file.md).

A key stands with an example line. Quantities are text with any unit of their kind, such as `\"0.9 mm\"` or \
`\"0.035 in\"`; the unit that is named is the one in which limits, defaults and formulas of this page are. Whatever is not \
marked **needed** may be left out; where its field is empty nothing takes its place, or the meaning says what does.
";

/// The reference of case files: a list of contents, and a section for each table in the order in which a case is written.
pub fn case_reference() -> String {
    let mut found = Reference::default();
    found.section(Place::default(), whole(), "");
    let mut text = INTRODUCTION.to_owned() + "\n## Contents\n\n";
    for (place, section) in &found.sections[1..] {
        let anchor = place.anchor();
        let _ = match place.path.split_once('.') {
            Some((_, inner)) => writeln!(text, "  - [`{inner}`](#{anchor})"),
            None => {
                let first = section.lines().next().unwrap_or_default();
                writeln!(text, "- [`{}`](#{anchor}): {}", place.path, lower(first.trim_end_matches('.')))
            }
        };
    }
    for (place, section) in found.sections {
        let _ = write!(text, "\n{}\n\n{}\n", place.heading(), section.trim_end());
    }
    text
}

/// Where a table is written.
#[derive(Clone, Default)]
struct Place {
    /// Its keys from the file's own down: `tools.punch.flat`; empty for the file.
    path: String,
    /// Whether it is a table: else it is a value that may take several forms.
    is_table: bool,
    /// Whether there may be several.
    is_list: bool,
}

impl Place {
    /// As a case writes it.
    fn heading(&self) -> String {
        let Self { path, is_table, is_list } = self;
        let level = if path.contains('.') { "###" } else { "##" };
        match (path.is_empty(), is_table, is_list) {
            (true, ..) => format!("{level} The file's own keys"),
            (_, false, _) => format!("{level} `{path}`"),
            (_, _, false) => format!("{level} `[{path}]`"),
            (_, _, true) => format!("{level} `[[{path}]]`"),
        }
    }

    /// What a heading is called in links, by the rule of mdBook and of most hosts of Markdown.
    fn anchor(&self) -> String {
        self.path.replace('.', "")
    }
}

#[derive(Default)]
struct Reference {
    /// Where each definition of the schema is told, by its name; others lead there.
    places: BTreeMap<&'static str, Place>,
    /// What is told at each place.
    sections: Vec<(Place, String)>,
}

/// A table that a key leads to, and what its own key says beyond a first paragraph.
type Deeper = (Place, &'static Value, &'static str);

impl Reference {
    /// Tells a table or a value of several forms, then the tables that its keys lead to.
    fn section(&mut self, place: Place, node: &'static Value, more: &str) {
        let mut text = String::new();
        for paragraph in [description(node), more].into_iter().flat_map(paragraphs) {
            let _ = writeln!(text, "{paragraph}\n");
        }
        let (at, mut deeper) = (self.sections.len(), Vec::new());
        self.sections.push((place.clone(), String::new()));
        for form in forms(node) {
            let told = paragraphs(description(form)).collect::<Vec<_>>().join(" ");
            let example = form["examples"].get(0).map_or(String::new(), |e| format!(" For example `{e}`."));
            let inside = referred(form).or_else(|| referred(&form["items"])).map_or(form, definition);
            let (kind, keys) = match Some(inside).filter(|inside| inside["properties"].is_object()) {
                Some(inside) if form["items"].is_object() => ("a list of tables".to_owned(), Some(inside)),
                Some(inside) => ("a table".to_owned(), Some(inside)),
                None => (self.kind(form, &place, &mut deeper), None),
            };
            let told = if told.is_empty() { String::new() } else { format!(": {told}") };
            let _ = writeln!(text, "- {kind}{told}{example}");
            if let Some(inside) = keys {
                let _ = writeln!(text, "\n{}", self.keys(inside, &place, &mut deeper));
            }
        }
        if node["properties"].is_object() {
            text += &self.keys(node, &place, &mut deeper);
        }
        self.sections[at].1 = text;
        for (place, node, more) in deeper {
            self.section(place, node, more);
        }
    }

    /// The keys of a table, a row each.
    fn keys(&mut self, table: &'static Value, place: &Place, deeper: &mut Vec<Deeper>) -> String {
        let mut keys: Vec<_> = entries(table).collect();
        keys.sort_by_key(|(key, _)| {
            let named = ORDER.split(' ').position(|named| named == *key).unwrap_or(usize::MAX);
            (named, !is_needed(table, key))
        });
        let mut text = "| key | value | when left out | meaning |\n|---|---|---|---|\n".to_owned();
        for (key, value) in keys {
            let path = if place.path.is_empty() { key.to_owned() } else { format!("{}.{key}", place.path) };
            let written = value["examples"].get(0).map_or(key.to_owned(), |example| format!("{key} = {example}"));
            let inner = Place { path, is_table: true, is_list: value["items"].is_object() };
            let known = deeper.len();
            let kind = self.kind(value, &inner, deeper);
            let of_its_own =
                Some(description(value)).filter(|told| !told.contains("with its unit")).unwrap_or_default();
            let referred = reference(value).map(|name| description(definition(name))).unwrap_or_default();
            let told = if of_its_own.is_empty() { referred } else { of_its_own };
            let (first, rest) = told.split_once("\n\n").unwrap_or((told, ""));
            // What leads to a section of its own is told there at length.
            let told = match &mut deeper[known..] {
                [(.., more)] if !of_its_own.is_empty() => {
                    *more = rest;
                    first
                }
                _ if of_its_own.is_empty() => first,
                _ => told,
            };
            let told = paragraphs(told).collect::<Vec<_>>().join(" ");
            let choices = reference(value).map(definition).into_iter().flat_map(choices);
            let choices = choices.filter(|_| deeper.len() == known).filter_map(|choice| {
                Some(format!("`{}`: {}", choice.get("const")?, lower(description(choice).trim_end_matches('.'))))
            });
            let choices = choices.collect::<Vec<_>>().join("; ");
            let with = table["dependentRequired"][key].as_array().into_iter().flatten().filter_map(Value::as_str);
            let with = with.map(|other| format!("`{other}`")).collect::<Vec<_>>().join(" and ");
            let needs = if with.is_empty() { with } else { format!("Needs {with}.") };
            let choices = if choices.is_empty() { choices } else { format!("{choices}.") };
            let meaning: Vec<String> = [told, choices, needs].into_iter().filter(|part| !part.is_empty()).collect();
            let cells = [format!("`{written}`"), kind, left_out(table, key, value), meaning.join(" ")];
            let cells = cells.map(|cell| cell.replace('|', "\\|"));
            let _ = writeln!(text, "| {} |", cells.join(" | "));
        }
        text
    }

    /// What may be written for a key, with unit and limits; tables that are told nowhere yet are to be told at its place.
    fn kind(&mut self, value: &'static Value, place: &Place, deeper: &mut Vec<Deeper>) -> String {
        if let Some(name) = referred(value) {
            return self.definition(name, place, deeper);
        }
        let alternatives = forms(value).map(|form| self.kind(form, place, deeper)).collect::<Vec<_>>();
        if !alternatives.is_empty() {
            return alternatives.join("; or ");
        }
        let quantity = value["x-quantity"].as_str();
        match kind_of(value) {
            _ if value["const"].is_string() => format!("`{}`", value["const"]),
            "array" => {
                let items = value["items"]["prefixItems"].as_array().into_iter().flatten();
                let parts: Vec<String> = items.map(|part| self.kind(part, place, deeper)).collect();
                let one = self.kind(&value["items"], place, deeper);
                match (value["minItems"].as_i64(), parts.is_empty()) {
                    (Some(count), _) => format!("{count} values: {one}"),
                    (_, true) if one.starts_with('[') => one,
                    (_, true) => format!("list: {one}"),
                    (_, false) => format!("list of pairs: {}", parts.join("; ")),
                }
            }
            "boolean" => "`true` or `false`".to_owned(),
            "string" => quantity.map_or("text".to_owned(), |quantity| format!("{quantity}{}", bounds(value))),
            "integer" => format!("whole number{}", bounds(value)),
            "number" => format!("number{}", bounds(value)),
            _ => String::new(),
        }
    }

    /// A definition of the schema: words to choose from, or a table that is told once.
    fn definition(&mut self, name: &'static str, place: &Place, deeper: &mut Vec<Deeper>) -> String {
        let node = definition(name);
        let words: Vec<String> = choices(node).filter_map(|c| Some(format!("`{}`", c.get("const")?))).collect();
        let is_short =
            choices(node).all(|choice| !description(choice).contains("\n\n") && choice["properties"].is_null());
        if !words.is_empty() && is_short {
            return words.join(", ");
        }
        let told = self.places.entry(name).or_insert_with(|| {
            let told = Place { is_table: node["type"] == "object", ..place.clone() };
            deeper.push((told.clone(), node, ""));
            told
        });
        let kind = match (told.is_table, place.is_list) {
            (true, true) => "tables",
            (true, false) => "table",
            (false, _) => "several forms",
        };
        format!("[{kind}](#{})", told.anchor())
    }
}

/// The paragraphs of a description, each in one line; a source is one of its own.
fn paragraphs(told: &str) -> impl Iterator<Item = String> {
    let lines: Vec<String> =
        told.replace("\nSource:", "\n\nSource:").split("\n\n").map(|p| p.replace('\n', " ")).collect();
    lines.into_iter().filter(|paragraph| !paragraph.is_empty())
}

/// The alternatives of a value that is not one of a few words.
fn forms(value: &'static Value) -> impl Iterator<Item = &'static Value> {
    let own = ["anyOf", "oneOf"].into_iter().flat_map(|of| value[of].as_array().into_iter().flatten());
    own.filter(|form| form["type"] != "null" && form["required"].is_null() || form["properties"].is_object())
}

/// The words that a definition lets choose from.
fn choices(node: &'static Value) -> impl Iterator<Item = &'static Value> {
    node["oneOf"].as_array().into_iter().flatten().filter(|choice| choice["type"].is_string())
}

/// The definition that a value is, by its name.
fn referred(value: &'static Value) -> Option<&'static str> {
    value["$ref"].as_str()?.rsplit('/').next()
}

/// The type of a value that may also be left out.
fn kind_of(value: &Value) -> &str {
    let several = value["type"].as_array().into_iter().flatten();
    several.chain([&value["type"]]).find_map(|kind| kind.as_str().filter(|kind| *kind != "null")).unwrap_or_default()
}

/// The limits of a number: `, above 0`, `, 3 to 101`.
fn bounds(value: &Value) -> String {
    let [least, most, above] = ["minimum", "maximum", "exclusiveMinimum"].map(|keyword| value[keyword].as_f64());
    match (least, most, above) {
        (Some(least), Some(most), _) => format!(", {least} to {most}"),
        (Some(least), None, _) => format!(", {least} or more"),
        (None, _, Some(above)) => format!(", above {above}"),
        _ => String::new(),
    }
}

fn is_needed(table: &Value, key: &str) -> bool {
    let keys = table["required"].as_array().into_iter().flatten();
    keys.chain(instead(table)).any(|needed| needed == key)
}

/// Keys of which a table wants exactly one.
fn instead(table: &Value) -> impl Iterator<Item = &Value> {
    table["oneOf"].as_array().into_iter().flatten().filter_map(|way| way["required"].get(0))
}

/// What holds where a key is not given.
fn left_out(table: &Value, key: &str, value: &Value) -> String {
    let others: Vec<String> = instead(table)
        .filter(|other| *other != key)
        .map(|other| format!("`{}`", other.as_str().unwrap_or_default()))
        .collect();
    match &value["default"] {
        _ if instead(table).any(|way| way == key) => format!("**needed**, or {}", others.join(", ")),
        _ if is_needed(table, key) => "**needed**".to_owned(),
        Value::Null => String::new(),
        Value::Array(empty) if empty.is_empty() => String::new(),
        default => format!("`{default}`"),
    }
}

/// A sentence that goes on another one.
fn lower(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_lowercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}
