//! The summary as text and as JSON.

use super::{Entry, Figure, Group, Summary, Value};
use crate::measure::Change;
use crate::table::Unit;
use crate::units::four_digits;
use crate::units::rounded;
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::json;
use std::fmt;

impl Serialize for Summary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.entries.len()))?;
        for Entry { key, unit, value, .. } in &self.entries {
            let key = unit.keyed(key);
            match value {
                Value::Number(v) => map.serialize_entry(&key, &rounded(*v))?,
                Value::Count(v) => map.serialize_entry(&key, v)?,
                Value::Flag(v) => map.serialize_entry(&key, v)?,
                Value::Text(v) => map.serialize_entry(&key, v)?,
                Value::List(v) => map.serialize_entry(&key, v)?,
                Value::Changes(v) => map.serialize_entry(&key, &v.iter().map(of_change).collect::<Vec<_>>())?,
            }
        }
        map.end()
    }
}

impl Summary {
    /// The printed lines but the lists and what was measured before and after.
    pub fn figures(&self) -> impl Iterator<Item = Figure> {
        self.entries.iter().filter(|entry| !entry.label.is_empty()).filter_map(|entry| {
            let (value, unit) = match &entry.value {
                Value::Number(v) => (digits(*v, entry.unit), entry.unit.symbol()),
                Value::Count(v) => (v.to_string(), Unit::None.symbol()),
                Value::Flag(v) => (if *v { "yes" } else { "no" }.to_owned(), ""),
                Value::Text(v) => (v.clone(), ""),
                Value::List(_) | Value::Changes(_) => return None,
            };
            Some(Figure { group: entry.group, key: entry.key, label: entry.label.clone(), value, unit })
        })
    }

    /// Labels and values of the printed lines; the entries of a list stand below each other, the first at its label.
    pub fn rows(&self) -> Vec<(Group, [String; 2])> {
        let printed = self.entries.iter().filter(|entry| !entry.label.is_empty());
        let rows = printed.flat_map(|Entry { group, label, unit, value, .. }| {
            let one = |text: String| vec![(label.clone(), text)];
            let rows = match value {
                Value::Number(v) => one(with_unit(*v, *unit)),
                Value::Count(v) => one(v.to_string()),
                Value::Flag(v) => one(if *v { "yes" } else { "no" }.to_owned()),
                Value::Text(v) => one(v.clone()),
                Value::List(lines) => {
                    let labelled =
                        |(i, line)| (if i == 0 { label.clone() } else { String::new() }, format!("- {line}"));
                    lines.iter().enumerate().map(labelled).collect()
                }
                Value::Changes(changes) => {
                    let head = (label.clone(), "before → after (change)".to_owned());
                    std::iter::once(head).chain(changes.iter().map(row_of_change)).collect()
                }
            };
            rows.into_iter().map(|(label, value)| (*group, [label, value]))
        });
        rows.collect()
    }
}

/// Four digits; of an angle tenths, as [`Quantity`](crate::measure::Quantity) has them.
fn digits(value: f64, unit: Unit) -> String {
    if unit == Unit::Degree { format!("{value:.1}") } else { four_digits(value) }
}

/// Degrees stand close to their number.
fn with_unit(value: f64, unit: Unit) -> String {
    let space = if unit == Unit::Degree { "" } else { " " };
    format!("{}{space}{}", digits(value, unit), unit.symbol())
}

/// `Wall to the punch direction`, `0.3° → 8.2° (+7.9°)`.
fn row_of_change(change: &Change) -> (String, String) {
    let by = change.change().map_or(String::new(), |by| format!(" ({})", change.quantity.signed(by)));
    (format!("  {}", change.quantity.label), change.text() + &by)
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
        let rows = self.rows();
        let width = rows.iter().map(|(_, [label, _])| label.chars().count()).max().unwrap_or(0);
        rows.iter().try_for_each(|(_, [label, value])| writeln!(f, "{label:<width$}  {value}"))
    }
}
