//! The summary as text and as JSON.

use super::{Entry, Figure, Group, INDENT, Summary, Value};
use crate::measure::{Change, Event};
use crate::table::Unit;
use crate::units::Amount;
use crate::units::rounded;
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::json;
use std::fmt;

impl Serialize for Summary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.entries.len()))?;
        for Entry { key, value, .. } in &self.entries {
            match value {
                Value::Number(amount) => {
                    map.serialize_entry(&amount.unit.keyed(key), &rounded(amount.value))?;
                    if let Some(half) = amount.bar() {
                        map.serialize_entry(&amount.unit.keyed(&format!("{key}_error_bar")), &rounded(half))?;
                    }
                }
                Value::Count(v) => map.serialize_entry(key, v)?,
                Value::Flag(v) => map.serialize_entry(key, v)?,
                Value::Text(v) => map.serialize_entry(key, v)?,
                Value::List(v) => map.serialize_entry(key, v)?,
                Value::Changes(v) => map.serialize_entry(key, &v.iter().map(of_change).collect::<Vec<_>>())?,
                Value::Events(v, force) => {
                    map.serialize_entry(key, &v.iter().map(|event| of_event(event, *force)).collect::<Vec<_>>())?;
                }
            }
        }
        map.end()
    }
}

impl Summary {
    /// The printed lines but the lists and what was measured before and after.
    pub fn figures(&self) -> impl Iterator<Item = Figure> {
        self.printed().filter_map(move |entry| {
            let (value, unit) = match &entry.value {
                Value::Number(amount) => amount.parts(),
                Value::List(_) | Value::Changes(_) | Value::Events(..) => return None,
                value => (said(value).to_string(), ""),
            };
            Some(Figure { group: entry.group, key: entry.key, label: entry.indented(), value, unit })
        })
    }

    /// Labels and values of the printed lines; the entries of a list stand below each other, the first at its label.
    pub fn rows(&self) -> Vec<(Group, [String; 2])> {
        let rows = self.printed().flat_map(|entry| {
            let label = entry.indented();
            let rows = match &entry.value {
                Value::List(lines) => {
                    let text = lines.iter().map(|line| format!("- {}", line.to_string()));
                    let labels = std::iter::once(label).chain(std::iter::repeat(String::new()));
                    labels.zip(text).collect()
                }
                Value::Events(events, force) => {
                    let text = events.iter().map(|event| row_of_event(event, *force).to_string());
                    std::iter::once(label).chain(std::iter::repeat(String::new())).zip(text).collect()
                }
                Value::Changes(changes) => {
                    let head = (label, String::from("before → after (change)").to_string());
                    std::iter::once(head).chain(changes.iter().map(|change| row_of_change(change))).collect()
                }
                value => vec![(label, said(value).to_string())],
            };
            rows.into_iter().map(|(label, value)| (entry.group, [label, value]))
        });
        rows.collect()
    }

    fn aligned(&self) -> String {
        let rows = self.rows();
        let width = rows.iter().map(|(_, [label, _])| label.chars().count()).max().unwrap_or(0);
        rows.iter().map(|(_, [label, value])| format!("{label:<width$}  {value}\n")).collect()
    }

    /// What readers are told: labels, words and lists.
    pub fn messages(&self) -> impl Iterator<Item = String> {
        self.printed().flat_map(|entry| {
            let values = match &entry.value {
                Value::List(lines) => lines.clone(),
                Value::Changes(changes) => {
                    changes.iter().flat_map(|change| [change.quantity.label.into(), change.told()]).collect()
                }
                Value::Events(events, force) => events.iter().map(|event| row_of_event(event, *force)).collect(),
                value => vec![said(value)],
            };
            std::iter::once(entry.label.clone()).chain(values)
        })
    }

    fn printed(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(|entry| !entry.label.is_empty())
    }
}

impl Entry {
    fn indented(&self) -> String {
        INDENT.repeat(self.level) + &self.label.to_string()
    }
}

/// A value that is neither a list nor a table, with its unit.
fn said(value: &Value) -> String {
    match value {
        Value::Number(amount) => (*amount).into(),
        Value::Count(count) => Amount::count(*count).into(),
        Value::Flag(true) => "yes".into(),
        Value::Flag(false) => "no".into(),
        Value::Text(text) => text.clone(),
        Value::List(_) | Value::Changes(_) | Value::Events(..) => String::new(),
    }
}

/// `Wall to the punch direction`, `0.3° → 8.2° (+7.9°)`.
fn row_of_change(change: &Change) -> (String, String) {
    let said = match change.change() {
        Some(by) => format!("{change} ({by})", change = change.told(), by = change.quantity.signed(by)),
        None => change.told(),
    };
    (INDENT.to_owned() + &String::from(change.quantity.label).to_string(), said.to_string())
}

/// `44.1 mm, 48.3 kN: rim meets the die`; of a gas's work the time in place of travel and force.
fn row_of_event(event: &Event, force: Unit) -> String {
    let what = event.kind.label();
    match event.travel {
        0.0 => format!("{time}: {what}", time = Amount::time(event.time)),
        travel => format!(
            "{travel}, {force}: {what}",
            travel = Amount::place(travel),
            force = Amount::force(event.force, force)
        ),
    }
}

fn of_event(event: &Event, force: Unit) -> serde_json::Value {
    json!({
        "key": event.kind.key(),
        "what": event.kind.label(),
        Unit::Mm.keyed("travel"): rounded(event.travel),
        Unit::Second.keyed("time"): rounded(event.time),
        force.keyed("punch_force"): rounded(event.force),
    })
}

fn of_change(change: &Change) -> serde_json::Value {
    json!({
        "key": change.quantity.key,
        "unit": change.quantity.unit.spelled(),
        "before": change.before.map(rounded),
        "after": change.after.map(rounded),
        "change": change.change().map(rounded),
    })
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.aligned())
    }
}
