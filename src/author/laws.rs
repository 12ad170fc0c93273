//! The laws that a case can name, with their parameters, read off the JSON schema: what is listed is what is accepted.

use crate::case::definition;
use serde::Serialize;
use serde_json::Value;
use std::fmt::Write;

/// Kinds of law: heading, the schema's table of alternatives, where a case names them.
const KINDS: [(&str, &str, &str); 4] = [
    ("Hardening: yield stress over equivalent plastic strain", "Hardening", "[material.hardening.NAME]"),
    ("Rate: a factor on the yield stress", "Rate", "[material.rate] NAME = { .. }"),
    (
        "Thermal: a factor on the yield stress by the temperature of [heat]",
        "ThermalLaw",
        "[material.softening] NAME = { .. }",
    ),
    (
        "Friction, beside a plain coefficient (Coulomb): friction stress over pressure and sliding",
        "Friction",
        "friction = { NAME = { .. } } of a tool, or by side in [friction]",
    ),
];

/// Laws without alternatives: heading, name, the schema's definition, where a case names it.
const SINGLE: [(&str, &str, &str, &str); 4] = [
    (
        "Yield condition, beside \"hill48\" (see Anisotropy): the stresses at which the sheet yields",
        "hosford",
        "HosfordLaw",
        "[material] yield_condition = { NAME = { .. } }",
    ),
    ("Voids: a yield condition that feels the mean stress", "voids", "Gtn", "[material.voids]"),
    (
        "Forming limit: the major strain at which the sheet necks, over the minor strain; beside points, hill and swift",
        "keeler_brazier",
        "KeelerBrazier",
        "[forming_limit] NAME = { .. }",
    ),
    ("Forming limit by an imperfection", "marciniak_kuczynski", "MarciniakKuczynski", "[forming_limit] NAME = { .. }"),
];

/// One law that a case can name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Law {
    /// What kind of law it is, in words.
    pub kind: &'static str,
    /// Where a case names it.
    pub place: &'static str,
    /// What a case calls it.
    pub name: String,
    /// Formula, range of validity and source, line by line.
    pub description: String,
    /// Its keys, in the order of the schema.
    pub parameters: Vec<Parameter>,
}

/// A key of a law; that of a table inside it stands behind a dot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    pub key: String,
    pub optional: bool,
    pub meaning: String,
}

/// Every law with its formula, source and parameters.
pub fn law_list() -> Vec<Law> {
    let of_kinds = KINDS.iter().flat_map(|&(kind, table, place)| {
        let laws = entries(definition(table));
        laws.map(move |(name, law)| law_of(kind, place, name, definition(reference(law).unwrap_or_default())))
    });
    let single = SINGLE.iter().map(|&(kind, name, table, place)| law_of(kind, place, name, definition(table)));
    let anisotropy = Law {
        kind: "Anisotropy: Hill's yield condition of 1948",
        place: "[material] anisotropy = 1.6",
        name: String::new(),
        description: description(&definition("Material")["properties"]["anisotropy"]).to_owned(),
        parameters: Vec::new(),
    };
    modes().chain(of_kinds).chain(single).chain([anisotropy]).collect()
}

/// How stress follows the sheet's motion.
fn modes() -> impl Iterator<Item = Law> {
    definition("Mode")["oneOf"].as_array().into_iter().flatten().map(|mode| Law {
        kind: "Stress of the sheet's motion: by the flow approach, or elastoplastic",
        place: "[material] mode = \"NAME\"",
        name: mode["const"].as_str().unwrap_or_default().to_owned(),
        description: description(mode).to_owned(),
        parameters: Vec::new(),
    })
}

/// The same as text.
pub fn laws() -> String {
    let mut text = String::new();
    for kind in law_list().chunk_by(|a, b| a.kind == b.kind) {
        let _ = writeln!(text, "{}\n  {}\n", kind[0].kind, kind[0].place);
        for law in kind {
            describe(&mut text, law);
        }
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}

/// A law's name, words and parameters, and an empty line.
fn describe(text: &mut String, law: &Law) {
    let indent = if law.name.is_empty() { "  " } else { "    " };
    if !law.name.is_empty() {
        let _ = writeln!(text, "  {}", law.name);
    }
    for sentences in unbroken(&law.description) {
        let _ = writeln!(text, "{indent}{sentences}");
    }
    for Parameter { key, optional, meaning } in &law.parameters {
        let inner = if key.contains('.') { "  " } else { "" };
        let optional = if *optional { " (optional)" } else { "" };
        let _ = writeln!(text, "      {:<28} {meaning}", format!("{inner}{key}{optional}"));
    }
    text.push('\n');
}

/// A text's lines, those joined again that were broken within a sentence.
fn unbroken(text: &str) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        match joined.last_mut().filter(|last| !last.ends_with(['.', ':'])) {
            Some(last) => *last += &format!(" {line}"),
            None => joined.push(line.to_owned()),
        }
    }
    joined
}

fn law_of(kind: &'static str, place: &'static str, name: &str, law: &Value) -> Law {
    let required: Vec<&str> = law["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let mut parameters = Vec::new();
    for (key, parameter) in entries(law) {
        let inner = reference(parameter).map(definition).filter(|inner| inner["properties"].is_object());
        let meaning = match inner {
            Some(_) => description(parameter).trim_end_matches('.').to_owned(),
            None => words(parameter),
        };
        parameters.push(Parameter { key: key.to_owned(), optional: !required.contains(&key), meaning });
        for (inner_key, parameter) in inner.into_iter().flat_map(entries) {
            let key = format!("{key}.{inner_key}");
            parameters.push(Parameter { key, optional: false, meaning: words(parameter) });
        }
    }
    Law { kind, place, name: name.to_owned(), description: description(law).to_owned(), parameters }
}

/// What a parameter is, and an example.
fn words(parameter: &Value) -> String {
    let example = parameter["examples"].get(0).map_or(String::new(), |e| format!("such as {e}"));
    // The types' own words ("a stress with its unit") say less than the example does.
    let own = Some(description(parameter)).filter(|d| !d.contains("with its unit")).unwrap_or_default();
    [own.trim_end_matches('.'), &example].into_iter().filter(|w| !w.is_empty()).collect::<Vec<_>>().join("; ")
}

pub(super) fn entries(table: &Value) -> impl Iterator<Item = (&str, &Value)> {
    table["properties"].as_object().into_iter().flatten().map(|(key, value)| (key.as_str(), value))
}

pub(super) fn description(schema: &Value) -> &str {
    schema["description"].as_str().unwrap_or_default()
}

/// The definition that a key refers to, which may be optional.
pub(super) fn reference(schema: &Value) -> Option<&str> {
    let mut choices = std::iter::once(schema).chain(schema["anyOf"].as_array().into_iter().flatten());
    choices.find_map(|choice| choice["$ref"].as_str()?.rsplit('/').next())
}
