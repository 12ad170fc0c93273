//! What each of several cases is called: by what sets it apart from the others.
//!
//! Of two variants of `cup.toml` that differ in friction one is `friction 0.08`, the other `friction 0.12`; cases that differ
//! in more than a few keys are called by their files.

use super::Candidate;
use crate::units::joined;
use std::collections::BTreeSet;
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// More keys than that are no name.
const FEW: usize = 3;

/// Keys that change nothing of a run.
const WORDS: [&str; 4] = ["title", "notes", "report", "compare"];

/// A key, dotted, and what stands there.
type Entry = (String, String);

pub(super) fn of(candidates: &[Candidate]) -> Vec<String> {
    let entries: Vec<Vec<Entry>> = candidates.iter().map(|candidate| entries(&candidate.case.text)).collect();
    let different = different(&entries);
    if !(1..=FEW).contains(&different.len()) {
        return spelled(candidates);
    }
    let last = |key: &str| key.rsplit('.').next().unwrap_or(key).to_owned();
    let name = |own: &Vec<Entry>| {
        let parts = different.iter().map(|key| {
            let word = match key.split('.').collect::<Vec<_>>()[..] {
                ["tools", tool, .., leaf] => format!("{tool} {leaf}"),
                [.., above, leaf] => format!("{above} {leaf}"),
                _ => last(key),
            };
            let word = word.replace('_', " ");
            match value(own, key) {
                Some(value) => String::from(format!("{word} {value}")),
                None => format!("{word} by default"),
            }
        });
        joined(parts, ", ")
    };
    entries.iter().map(name).collect()
}

/// By their files, with their folders where files of one name are among them.
fn spelled(candidates: &[Candidate]) -> Vec<String> {
    let names: Vec<String> = candidates.iter().map(Candidate::spelled).collect();
    let is_alone = |name: &String| names.iter().filter(|other| *other == name).count() == 1;
    let path = |candidate: &Candidate| candidate.case.path.display().to_string();
    names.iter().zip(candidates).map(|(name, c)| if is_alone(name) { name.clone() } else { path(c) }.into()).collect()
}

/// The keys in which cases differ, in their order; one for all tools where it is the same in each.
fn different(entries: &[Vec<Entry>]) -> Vec<String> {
    let mut keys: Vec<&String> = Vec::new();
    for (key, _) in entries.iter().flatten() {
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    let is_different = |key: &&String| entries.iter().any(|own| value(own, key) != value(&entries[0], key));
    let different: Vec<String> = keys.into_iter().filter(is_different).cloned().collect();
    let mut merged: Vec<String> = Vec::new();
    for key in &different {
        let of_all = of_all_tools(key, &different, entries).unwrap_or_else(|| key.clone());
        if !merged.contains(&of_all) {
            merged.push(of_all);
        }
    }
    merged
}

/// The last word of a key of a tool where others have it too, and in each case all of them the same value.
fn of_all_tools(key: &str, different: &[String], entries: &[Vec<Entry>]) -> Option<String> {
    let [_, leaf] = tool_key(key)?;
    let tools = |key: &&String| tool_key(key).is_some_and(|[_, other]| other == leaf);
    if different.iter().filter(tools).count() < 2 {
        return None;
    }
    let values = |own: &Vec<Entry>| {
        let of_tools = own.iter().filter(|(key, _)| tools(&key));
        of_tools.map(|(_, value)| value.clone()).collect::<BTreeSet<_>>().len()
    };
    entries.iter().all(|own| values(own) <= 1).then(|| leaf.to_owned())
}

/// Tool and leaf of `tools.punch.friction`.
fn tool_key(key: &str) -> Option<[&str; 2]> {
    match key.split('.').collect::<Vec<_>>()[..] {
        ["tools", tool, leaf] => Some([tool, leaf]),
        _ => None,
    }
}

/// What stands at a key; at a word alone what all tools have.
fn value<'e>(own: &'e [Entry], key: &str) -> Option<&'e str> {
    let is_it = |(other, _): &&Entry| {
        other == key || !key.contains('.') && tool_key(other).is_some_and(|[_, leaf]| leaf == key)
    };
    own.iter().find(is_it).map(|(_, value)| value.as_str())
}

/// Every key of a case file with what stands there.
fn entries(text: &str) -> Vec<Entry> {
    let mut all = Vec::new();
    // A case that was read is TOML.
    if let Ok(document) = text.parse::<DocumentMut>() {
        of_table(document.as_table(), "", &mut all);
    }
    all
}

fn of_table(table: &dyn TableLike, above: &str, all: &mut Vec<Entry>) {
    for (key, item) in table.iter().filter(|(key, _)| !above.is_empty() || !WORDS.contains(key)) {
        let key = if above.is_empty() { key.to_owned() } else { format!("{above}.{key}") };
        match item {
            Item::Value(Value::InlineTable(table)) => of_table(table, &key, all),
            Item::Table(table) => of_table(table, &key, all),
            Item::Value(value) => {
                let plain = || value.clone().decorated("", "").to_string();
                all.push((key, value.as_str().map_or_else(plain, str::to_owned)));
            }
            other => all.push((key, other.to_string())),
        }
    }
}
